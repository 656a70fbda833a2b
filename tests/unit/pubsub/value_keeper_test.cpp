// SPDX-License-Identifier: MIT
#include "limpet/pubsub/value_keeper.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "limpet/core/random.hpp"
#include "limpet/pubsub/broker_status.hpp"

namespace limpet {
namespace {

constexpr std::size_t kLimit = std::size_t{1} << 20;

/// A file in memory, as the launcher holds one.
class KeptValues : public testing::Test {
 protected:
  KeptValues() : descriptor_(::memfd_create("kept-test", MFD_CLOEXEC)) {}
  ~KeptValues() override { ::close(descriptor_); }
  KeptValues(const KeptValues&) = delete;
  KeptValues& operator=(const KeptValues&) = delete;

  /// A broker with one writer, and its keeper.
  struct Life {
    Life(int descriptor, std::size_t limit)
        : broker({.community = "alpha", .hostname = "h", .limits = {}}, Seconds(100.0)),
          keeper(descriptor, limit, broker),
          writer(*broker
                      .Admit({.type = wire_type::kHello, .key = "asynchronous", .text = "uPoke"},
                             Seconds(100.0))
                      .client) {}
    void Write(std::string_view name, std::string_view text, Seconds now) {
      const ByteBuffer packet = PacketOf({.id = 3,
                                          .data_type = wire_data::kString,
                                          .source = "uPoke",
                                          .key = name,
                                          .time = 99.5,
                                          .text = text});
      EXPECT_FALSE(broker.Receive(writer, packet, Seconds(100.0)).has_value());
      keeper.Keep(now);
    }
    [[nodiscard]] std::string TextOf(std::string_view name) const {
      const auto variable = broker.router().Find(name);
      const auto latest = variable ? broker.LatestOf(*variable) : std::nullopt;
      return latest ? std::string(latest->text) : "";
    }
    Broker broker;
    ValueKeeper keeper;
    Broker::Client writer;
  };
  [[nodiscard]] std::unique_ptr<Life> Begin(std::size_t limit = kLimit) const {
    return std::make_unique<Life>(descriptor_, limit);
  }

  int descriptor_;
};

TEST_F(KeptValues, AreThereForTheBrokerThatTakesThePlace) {
  Begin()->Write("DEPLOY", "true", Seconds(1.0));
  const auto next = Begin();
  const auto latest = next->broker.LatestOf(next->broker.router().Find("DEPLOY").value());
  ASSERT_TRUE(latest.has_value());
  EXPECT_EQ(latest->text, "true");
  EXPECT_EQ(latest->source, "uPoke");
  EXPECT_EQ(latest->community, "alpha");
  EXPECT_EQ(latest->time, 99.5);
}

TEST_F(KeptValues, HaveNoRateUntilTheyAreWrittenAgain) {
  Begin()->Write("DEPLOY", "true", Seconds(1.0));
  const auto next = Begin();
  const Router& router = next->broker.router();
  const Router::VariableInfo& info = router.Info(router.Find("DEPLOY").value());
  EXPECT_EQ(WriteFrequency(info, next->broker.started()), 0.0);
}

TEST_F(KeptValues, OutliveManyBrokers) {
  Begin()->Write("DEPLOY", "true", Seconds(1.0));
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(Begin()->TextOf("DEPLOY"), "true");
  }
}

/// A helm says that it is not deployed, and within the second it is: a database that dies then must
/// not bring the former back.
TEST_F(KeptValues, AreKeptAtOnceThoughSomethingElseWasSaidJustBefore) {
  {
    const auto life = Begin();
    life->Write("DEPLOY", "false", Seconds(100.0));
    life->Write("DEPLOY", "true", Seconds(100.1));
  }
  EXPECT_EQ(Begin()->TextOf("DEPLOY"), "true");
}

TEST_F(KeptValues, OfABusyVariableAreKeptOnceASecond) {
  const auto life = Begin();
  for (int i = 1; i <= 9; ++i)
    life->Write("NAV_X", std::to_string(i), Seconds(100.0 + 0.1 * i));
  EXPECT_TRUE(life->keeper.has_waiting());
  EXPECT_EQ(Begin()->TextOf("NAV_X"), "4") << "four at once, and no more within the second";
}

TEST_F(KeptValues, OfABusyVariableAreTheLastOnceItIsQuiet) {
  const auto life = Begin();
  life->Write("NAV_X", "1", Seconds(1.0));
  life->Write("NAV_X", "2", Seconds(1.1));
  life->keeper.KeepWaiting(Seconds(2.0));
  EXPECT_FALSE(life->keeper.has_waiting());
  EXPECT_EQ(Begin()->TextOf("NAV_X"), "2");
}

TEST_F(KeptValues, LeaveOutWhatTheBrokerSaysOfItself) {
  {
    const auto life = Begin();
    life->broker.PublishStatus(Seconds(102.0));
    life->keeper.Keep(Seconds(1.0));
  }
  EXPECT_FALSE(Begin()->broker.router().Find("DB_CLIENTS").has_value());
}

TEST_F(KeptValues, AreForgottenWithAClear) {
  {
    const auto life = Begin();
    life->Write("DEPLOY", "true", Seconds(1.0));
    const ByteBuffer clear = PacketOf({.id = -2, .type = wire_type::kRequest, .key = "DB_CLEAR"});
    EXPECT_FALSE(life->broker.Receive(life->writer, clear, Seconds(100.0)).has_value());
    life->Write("AFTER", "1", Seconds(2.0));
  }
  const auto next = Begin();
  EXPECT_EQ(next->TextOf("DEPLOY"), "");
  EXPECT_EQ(next->TextOf("AFTER"), "1");
}

TEST_F(KeptValues, AreTheLatestThoughTheFileWasFilledManyTimes) {
  {
    const auto life = Begin();
    life->Write("DEPLOY", "true", Seconds(0.0));
    const std::string large(20'000, 'x');
    for (int i = 1; i <= 400; ++i) {
      life->Write("MAP", large + std::to_string(i), Seconds(2.0 * i));
    }
  }
  const auto next = Begin();
  EXPECT_EQ(next->TextOf("DEPLOY"), "true");
  EXPECT_TRUE(next->TextOf("MAP").ends_with("x400"));
}

TEST_F(KeptValues, TakeNoMoreMemoryThanAllowed) {
  const auto life = Begin();
  const std::string large(20'000, 'x');
  for (int i = 1; i <= 400; ++i) {
    life->Write("MAP" + std::to_string(i), large, Seconds(2.0 * i));
  }
  struct stat status {};
  ASSERT_EQ(::fstat(descriptor_, &status), 0);
  EXPECT_LE(static_cast<std::size_t>(status.st_size), 2 * kLimit + 4096);
}

TEST_F(KeptValues, AreNoneInAFileOfNoise) {
  Random random(1, "noise");
  ByteBuffer noise(100'000);
  for (std::byte& byte : noise) {
    byte = static_cast<std::byte>(random.Index(256));
  }
  ASSERT_EQ(::pwrite(descriptor_, noise.data(), noise.size(), 0),
            static_cast<ssize_t>(noise.size()));
  EXPECT_EQ(Begin()->broker.router().variable_count(), 1U);  // DB_EVENT: its writer came
}

TEST_F(KeptValues, AreThoseBeforeAMessageThatIsDamaged) {
  {
    const auto life = Begin();
    life->Write("DEPLOY", "true", Seconds(1.0));
    life->Write("RETURN", "false", Seconds(1.0));
  }
  const KeptFile file(descriptor_, kLimit);
  const std::int32_t lie = 1 << 30;
  const auto second = static_cast<off_t>(file.Load().size() / 2 + 1);
  std::int64_t place = 4096 + static_cast<std::int64_t>(kLimit);  // the half written last
  ASSERT_EQ(::pwrite(descriptor_, &lie, sizeof(lie), place + second), 4);
  EXPECT_EQ(Begin()->TextOf("DEPLOY"), "true");
}

}  // namespace
}  // namespace limpet

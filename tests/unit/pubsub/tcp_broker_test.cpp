// SPDX-License-Identifier: MIT
// The broker on real sockets, with clients of ours.
#include "limpet/pubsub/tcp_broker.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <fstream>
#include <memory>
#include <mutex>
#include <set>

#include <fmt/format.h>
#include <malloc.h>
#include <unistd.h>

#include "limpet/core/clock.hpp"
#include "limpet/wire/little_endian.hpp"
#include "tests/support/loopback_broker.hpp"

namespace limpet {
namespace {

using namespace std::chrono_literals;

struct Ways {
  const char* name;
  bool clients_go_locally, sends_together;
};
void PrintTo(const Ways& ways, std::ostream* out) { *out << ways.name; }

/// Whatever clients come by, and however the broker sends.
class TcpBrokerTest : public LoopbackBroker, public testing::WithParamInterface<Ways> {
 protected:
  TcpBrokerTest() : LoopbackBroker(GetParam().sends_together) {
    clients_go_locally_ = GetParam().clients_go_locally;
  }
};
INSTANTIATE_TEST_SUITE_P(Clients, TcpBrokerTest,
                         testing::Values(Ways{"Local", true, true}, Ways{"ByTcp", false, true},
                                         Ways{"LocalOneByOne", true, false}),
                         [](const auto& of) { return of.param.name; });

TEST_P(TcpBrokerTest, CarriesEveryTypeFromOneClientToAnother) {
  MailInbox inbox;
  const auto reader = Join("pReader", &inbox);
  for (const char* name : {"NUMBER", "TEXT", "BYTES"}) {
    reader->Subscribe(name, Seconds(0.0));
  }
  const auto writer = Join("pWriter");
  writer->Publish("NUMBER", 1.25, "part");
  writer->Publish("TEXT", "a,b=c");
  writer->PublishValue("BYTES", Value(Binary{std::byte{0}, std::byte{255}}));
  const auto number = inbox.Await("NUMBER");
  const auto text = inbox.Await("TEXT");
  const auto bytes = inbox.Await("BYTES");
  ASSERT_TRUE(number && text && bytes);
  EXPECT_EQ(std::get<double>(number->value), 1.25);
  EXPECT_EQ(number->source, "pWriter");
  EXPECT_EQ(number->source_aux, "part");
  EXPECT_EQ(number->community, "alpha");
  EXPECT_EQ(std::get<std::string>(text->value), "a,b=c");
  EXPECT_EQ(std::get<Binary>(bytes->value).size(), 2U);
}

TEST_P(TcpBrokerTest, SendsTheLatestValueToALateSubscriber) {
  const auto writer = Join("pWriter");
  writer->Publish("X", 7.0);
  MailInbox first, late;
  const auto reader = Join("pFirst", &first);
  reader->Subscribe("X", Seconds(0.0));
  ASSERT_TRUE(first.Await("X").has_value());
  const auto other = Join("pLate", &late);
  other->SubscribeWildcard(
      {.app_pattern = "*", .variable_pattern = "X*", .interval = Seconds(0.0)});
  const auto heard = late.Await("X");
  ASSERT_TRUE(heard.has_value());
  EXPECT_EQ(heard->id, -1);
}

TEST_P(TcpBrokerTest, TellsOfComersAndGoersAtOnce) {
  MailInbox inbox;
  const auto watcher = Join("pWatch", &inbox);
  watcher->Subscribe("DB_EVENT", Seconds(0.0));
  ASSERT_TRUE(inbox.AwaitText("connected=pWatch"));
  {
    const auto brief = Join("pBrief");
    EXPECT_TRUE(inbox.AwaitText("connected=pBrief"));
  }
  EXPECT_TRUE(inbox.AwaitText("disconnected=pBrief"));
}

TEST_P(TcpBrokerTest, ListsItsClientsEveryTwoSeconds) {
  MailInbox inbox;
  const auto watcher = Join("pWatch", &inbox);
  watcher->Subscribe("DB_CLIENTS", Seconds(0.0));
  const auto clients = inbox.Await("DB_CLIENTS");
  ASSERT_TRUE(clients.has_value());
  EXPECT_EQ(std::get<std::string>(clients->value), "pWatch,");
}

/// Readers that are in: what a client asked for before READY holds once it has heard that.
class Roll {
 public:
  explicit Roll(int readers) : readers_(readers) {}
  /// True for READY.
  bool Note(const WireMessage& message, int reader) {
    if (message.key != "READY") return false;
    const std::lock_guard lock(mutex_);
    in_.insert(reader);
    return true;
  }
  /// Says READY until all have heard it.
  void Call(TcpClient& writer) {
    for (int tries = 0; tries < 500 && !AreAllIn(); ++tries) {
      writer.Publish("READY", 1.0);
      std::this_thread::sleep_for(10ms);
    }
    ASSERT_TRUE(AreAllIn());
  }

 private:
  [[nodiscard]] bool AreAllIn() {
    const std::lock_guard lock(mutex_);
    return static_cast<int>(in_.size()) == readers_;
  }
  int readers_;
  std::mutex mutex_;
  std::set<int> in_;
};

TEST_P(TcpBrokerTest, TellsEveryReaderEverythingInOrder) {
  constexpr int kReaders = 12, kValues = 500;
  Roll roll(kReaders);
  std::array<std::atomic<int>, kReaders> heard{};  // in order
  std::vector<std::unique_ptr<TcpClient>> readers;
  for (auto& mine : heard) {
    const int number = static_cast<int>(readers.size());
    readers.push_back(
        Join(fmt::format("pReader{}", number), [&mine, &roll, number](const WireMessage& m) {
          if (roll.Note(m, number)) return;
          mine += m.key == "COUNT" && m.number == static_cast<double>(mine) ? 1 : 0;
        }));
    readers.back()->Subscribe("COUNT", Seconds(0.0));
    readers.back()->Subscribe("READY", Seconds(0.0));
  }
  const RawPeer stuck(broker_->port());
  stuck.Hello("pStuck");
  stuck.Send(
      PacketOf({.type = wire_type::kRegister, .source = "pStuck", .key = "COUNT", .number = 0.0}));
  const auto writer = Join("pWriter");
  roll.Call(*writer);
  for (int i = 0; i < kValues; ++i) {
    writer->Publish("COUNT", static_cast<double>(i));
    if (i % 10 == 0) {
      std::this_thread::sleep_for(200us);  // single messages and packets of several
    }
  }
  for (const auto& mine : heard) {
    for (int tries = 0; tries < 500 && mine < kValues; ++tries) {
      std::this_thread::sleep_for(10ms);
    }
    EXPECT_EQ(mine, kValues);
  }
}

TEST_P(TcpBrokerTest, ReadersThatPauseGetTheirQueueWholeAndInOrder) {
  constexpr int kReaders = 3, kValues = 2500;
  Roll roll(kReaders);
  std::atomic<bool> may_read{false};
  std::array<std::atomic<int>, kReaders> heard{};  // in order
  std::vector<std::unique_ptr<TcpClient>> readers;
  for (auto& mine : heard) {
    const int number = static_cast<int>(readers.size());
    readers.push_back(Join(fmt::format("pReader{}", number), [&, number](const WireMessage& m) {
      if (roll.Note(m, number)) return;
      may_read.wait(false);
      mine += m.text == fmt::format("{:01000}", mine.load()) ? 1 : 0;
    }));
    readers.back()->Subscribe("FLOOD", Seconds(0.0));
    readers.back()->Subscribe("READY", Seconds(0.0));
  }
  const auto writer = Join("pWriter");
  roll.Call(*writer);
  for (int i = 0; i < kValues; ++i) {  // less than a queue, more than a socket holds
    writer->Publish("FLOOD", std::string_view(fmt::format("{:01000}", i)));
  }
  ExpectHealthy("AFTER_FLOOD");
  may_read = true;
  may_read.notify_all();
  for (const auto& mine : heard) {
    for (int tries = 0; tries < 500 && mine < kValues; ++tries) {
      std::this_thread::sleep_for(10ms);
    }
    EXPECT_EQ(mine, kValues);
  }
}

TEST_P(TcpBrokerTest, CarriesMegabytes) {
  MailInbox inbox;
  const auto reader = Join("pReader", &inbox);
  reader->Subscribe("BIG", Seconds(0.0));
  const auto writer = Join("pWriter");
  writer->PublishValue("BIG", Value(Binary(5U << 20, std::byte{7})));
  const auto heard = inbox.Await("BIG");
  ASSERT_TRUE(heard.has_value());
  EXPECT_EQ(std::get<Binary>(heard->value).size(), 5U << 20);
}

TEST_P(TcpBrokerTest, WelcomesManyAtOnce) {
  std::vector<std::unique_ptr<TcpClient>> clients;
  for (int i = 0; i < 50; ++i) {
    clients.push_back(Join("pMany" + std::to_string(i)));
  }
  for (int tries = 0; tries < 500; ++tries) {
    const bool all = std::ranges::all_of(
        clients, [](const auto& c) { return c->state() == TcpClient::State::kConnected; });
    if (all) {
      return;
    }
    std::this_thread::sleep_for(10ms);
  }
  FAIL() << "50 clients did not connect within 5 s";
}

TEST_P(TcpBrokerTest, KeepsServingWhileAReaderHasStopped) {
  const RawPeer stuck(broker_->port());
  stuck.Hello("pStuck");
  ASSERT_EQ(stuck.Answer(), wire_type::kWelcome);
  stuck.Send(
      PacketOf({.type = wire_type::kRegister, .source = "pStuck", .key = "FLOOD", .number = 0.0}));
  MailInbox inbox;
  const auto watcher = Join("pWatch", &inbox);
  watcher->Subscribe("DB_DROPPED", Seconds(0.0));
  const auto writer = Join("pWriter");
  for (int i = 0; i < 30; ++i) {
    writer->PublishValue("FLOOD", Value(Binary(1U << 20)));
    std::this_thread::sleep_for(5ms);
  }
  ExpectHealthy();
  std::string losses;
  for (int tries = 0; tries < 60 && losses.find("pStuck=") == std::string::npos; ++tries) {
    std::this_thread::sleep_for(100ms);
    MailInbox fresh;
    const auto reader = Join("pAsk" + std::to_string(tries), &fresh);
    reader->Subscribe("DB_DROPPED", Seconds(0.0));
    if (const auto heard = fresh.Await("DB_DROPPED", 2s)) {
      losses = std::get<std::string>(heard->value);
    }
  }
  EXPECT_NE(losses.find("pStuck="), std::string::npos) << losses;
}

#if !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)  // their allocators keep freed memory

/// Of this process, broker and clients [MB].
double Resident() {
  double total = 0.0, resident = 0.0;
  std::ifstream("/proc/self/statm") >> total >> resident;
  return 1e-6 * resident * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

TEST_P(TcpBrokerTest, MemoryOfABurstGoesBack) {
  const auto writer = Join("pWriter");
  ExpectHealthy();
  ::malloc_trim(0);  // what earlier tests of this process have left
  const double before = Resident();
  {
    std::vector<std::unique_ptr<RawPeer>> stuck;
    for (int i = 0; i < 8; ++i) {
      const std::string name = "pStuck" + std::to_string(i);
      stuck.push_back(std::make_unique<RawPeer>(broker_->port()));
      stuck.back()->Hello(name);
      ASSERT_EQ(stuck.back()->Answer(), wire_type::kWelcome);
      stuck.back()->Send(
          PacketOf({.type = wire_type::kRegister, .source = name, .key = "FLOOD", .number = 0.0}));
    }
    ExpectHealthy("AFTER_REGISTERING");
    const std::string text(1000, 'x');
    for (int i = 0; i < 12'000; ++i) {
      writer->Publish("FLOOD", std::string_view(text));
      if (i % 100 == 0) {
        writer->Publish("SMALL" + std::to_string(i), 1.0);  // stays, between what goes
        while (writer->unsent() > 0) {                      // its own queue is in this process, too
          std::this_thread::sleep_for(1ms);
        }
      }
    }
    ExpectHealthy("AFTER_FLOOD");
    EXPECT_GT(Resident(), before + 16.0);
  }
  for (int tries = 0; tries < 50 && Resident() > before + 12.0; ++tries) {
    std::this_thread::sleep_for(100ms);
  }
  EXPECT_LT(Resident(), before + 12.0);
}

#endif

TEST(TcpBroker, SaysWhereItCannotListen) {
  TcpBrokerOptions options;
  options.bind_address = "203.0.113.7";
  try {
    const TcpBroker broker(options);
    FAIL() << "listens on an address that is not ours";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("203.0.113.7:9000"), std::string::npos);
  }
}

}  // namespace
}  // namespace limpet

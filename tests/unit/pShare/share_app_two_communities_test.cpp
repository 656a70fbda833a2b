// SPDX-License-Identifier: MIT
// Two communities on TCP, a pShare in each, and UDP between them; and somebody who means harm.
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/pShare/share_app.hpp"
#include "limpet/app/live_link.hpp"
#include "limpet/core/clock.hpp"
#include "limpet/core/random.hpp"
#include "limpet/pubsub/tcp_broker.hpp"
#include "limpet/sharing/share_datagram.hpp"
#include "limpet/wire/little_endian.hpp"
#include "limpet/wire/message_conversion.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

using namespace std::chrono_literals;

constexpr const char* kAnyPort = "route=localhost:0, interface=127.0.0.1";

/// A database, an operator who reads and writes, and a pShare that can be started anew.
class Community {
 public:
  Community(std::string name, std::filesystem::path folder)
      : name_(std::move(name)), folder_(std::move(folder)), broker_(Options(name_)) {
    serving_ = std::thread([this] { broker_.Run(); });
    operator_ = Join("pOperator", [this](const WireMessage& message) { Hear(message); });
    operator_->SubscribeWildcard({.app_pattern = "*", .variable_pattern = "*", .interval = {}});
  }
  ~Community() {
    StopSharing();
    operator_.reset();
    broker_.Stop();
    serving_.join();
  }
  Community(const Community&) = delete;
  Community& operator=(const Community&) = delete;

  /// Starts pShare; gives the port of its input.
  std::uint16_t Share(ShareParams params) {
    link_ = std::make_unique<LiveLink>(TcpClientOptions{
        .port = broker_.port(), .name = "pShare", .on_mail = nullptr, .on_state = nullptr});
    AppContext context;
    context.name = "pShare";
    context.link = link_.get();
    context.globals = {{"Community", name_, {}}};
    context.mission_folder = folder_;
    context.runs_live = true;
    if (!params.key_file.empty()) {
      params.to = name_ == "shore" ? "vehicle" : "shore";
    }
    app_ = std::make_unique<ShareApp>(context, params);
    const std::uint16_t port = app_->Ports().at(0);
    is_over_ = false;
    running_ = std::thread([this] { Loop(); });
    return port;
  }
  void StopSharing() {
    if (running_.joinable()) {
      is_over_ = true;
      link_->Wake();
      running_.join();
      app_.reset();
      link_.reset();
    }
  }

  void Write(const std::string& name, std::string_view value) { operator_->Publish(name, value); }
  void Write(const std::string& name, double value) { operator_->Publish(name, value); }
  /// The newest write of `name` that satisfies `is_it`, once there is one.
  template <class Condition>
  std::optional<Message> AwaitThat(const std::string& name, Condition is_it) {
    std::unique_lock lock(mutex_);
    std::optional<Message> found;
    arrival_.wait_for(lock, 5s, [&] {
      for (const Message& message : heard_) {
        if (message.name == name && is_it(message)) {
          found = message;
        }
      }
      return found.has_value();
    });
    return found;
  }
  std::optional<Message> Await(const std::string& name) {
    return AwaitThat(name, [](const Message&) { return true; });
  }
  /// True once PSHARE_COUNTS satisfies `is_it`.
  template <class Condition>
  bool AwaitCounts(Condition is_it) {
    return AwaitThat("PSHARE_COUNTS",
                     [&](const Message& message) {
                       const auto counts = TopicCodec<ShareCounts>::Decode(message.value);
                       return counts && is_it(*counts);
                     })
        .has_value();
  }
  std::size_t CountOf(const std::string& name) {
    const std::lock_guard lock(mutex_);
    return static_cast<std::size_t>(
        std::ranges::count(heard_, name, [](const Message& message) { return message.name; }));
  }

 private:
  static TcpBrokerOptions Options(const std::string& name) {
    TcpBrokerOptions options;
    options.broker.community = name;
    options.port = 0;
    return options;
  }
  std::unique_ptr<TcpClient> Join(const std::string& name,
                                  std::function<void(const WireMessage&)> on_mail) {
    return std::make_unique<TcpClient>(TcpClientOptions{
        .port = broker_.port(), .name = name, .on_mail = std::move(on_mail), .on_state = nullptr});
  }
  void Hear(const WireMessage& message) {
    const std::lock_guard lock(mutex_);
    heard_.push_back(MessageFrom(message));
    arrival_.notify_all();
  }
  void Loop() {
    while (!is_over_) {
      for (const MessagePtr& message : link_->TakeMail(SteadyTime() + Seconds(0.05))) {
        app_->Deliver(message);
      }
      app_->Attend(link_->Now());
      app_->Tick(link_->Now());
    }
  }

  std::string name_;
  std::filesystem::path folder_;
  TcpBroker broker_;
  std::thread serving_, running_;
  std::mutex mutex_;
  std::condition_variable arrival_;
  std::vector<Message> heard_;
  std::unique_ptr<TcpClient> operator_;
  std::unique_ptr<LiveLink> link_;
  std::unique_ptr<ShareApp> app_;
  std::atomic<bool> is_over_{false};
};

std::string To(std::uint16_t port) { return "localhost:" + std::to_string(port); }

class TwoCommunitiesTest : public ::testing::TestWithParam<bool> {
 protected:
  TwoCommunitiesTest() {
    EXPECT_FALSE(SaveShareKey(ShareKey::Random(), folder_.path() / "fleet.key"));
  }
  /// Sealed, or plain if the test's parameter says so.
  static ShareParams Params(std::vector<std::string> outputs) {
    ShareParams params;
    params.outputs = std::move(outputs);
    params.inputs = {kAnyPort};
    if (GetParam()) {
      params.allows_plain_routes = true;
    } else {
      params.key_file = "fleet.key";
    }
    return params;
  }
  TemporaryFolder folder_;
  Community shore_{"shore", folder_.path()}, vehicle_{"vehicle", folder_.path()};
};

INSTANTIATE_TEST_SUITE_P(SealedAndPlain, TwoCommunitiesTest, ::testing::Values(false, true),
                         [](const auto& kind) { return kind.param ? "Plain" : "Sealed"; });

TEST_P(TwoCommunitiesTest, ExchangeValuesBothWays) {
  const auto shore_port = shore_.Share(Params({}));
  const auto vehicle_port = vehicle_.Share(Params({"NAV_*->V_:" + To(shore_port)}));
  shore_.Write("PSHARE_CMD", "cmd=output,src_name=DEPLOY,route=" + To(vehicle_port));
  vehicle_.Write("NAV_X", 7.5);
  const auto seen = shore_.Await("V_NAV_X");
  ASSERT_TRUE(seen.has_value());
  EXPECT_EQ(std::get<double>(seen->value), 7.5);
  EXPECT_EQ(seen->source, "pOperator");
  EXPECT_EQ(seen->community, "vehicle");
  shore_.Write("DEPLOY", "true");
  ASSERT_TRUE(vehicle_.Await("DEPLOY").has_value());
  EXPECT_EQ(vehicle_.Await("DEPLOY")->community, "shore");
}

TEST_P(TwoCommunitiesTest, TakeUpAgainAfterARestart) {
  const auto shore_port = shore_.Share(Params({}));
  vehicle_.Share(Params({"X->" + To(shore_port)}));
  vehicle_.Write("X", "before");
  ASSERT_TRUE(shore_.Await("X").has_value());
  vehicle_.StopSharing();
  vehicle_.Write("X", "after");
  vehicle_.Share(Params({"X->" + To(shore_port)}));
  EXPECT_TRUE(shore_.AwaitThat(
      "X", [](const Message& message) { return std::get<std::string>(message.value) == "after"; }));
}

TEST_P(TwoCommunitiesTest, DoNotEchoEachOtherForEver) {
  const auto shore_port = shore_.Share(Params({}));
  const auto vehicle_port = vehicle_.Share(Params({"NAV_*->" + To(shore_port)}));
  shore_.Write("PSHARE_CMD", "cmd=output,src_name=NAV_*,route=" + To(vehicle_port));
  ASSERT_TRUE(shore_.AwaitThat("PSHARE_OUTPUT_SUMMARY", [](const Message&) { return true; }));
  vehicle_.Write("NAV_X", 1.0);
  ASSERT_TRUE(vehicle_.AwaitCounts([](const ShareCounts& counts) { return counts.looped == 1.0; }));
  EXPECT_EQ(vehicle_.CountOf("NAV_X"), 1U);
  EXPECT_EQ(shore_.CountOf("NAV_X"), 1U);
}

/// Bytes that nobody honest sends.
std::vector<ByteBuffer> HostileDatagrams() {
  const ByteBuffer good = *EncodeShare(
      {.source = "pFar", .community = "beta", .key = "HARMFUL", .time = 5.0, .number = 1.0});
  std::vector<ByteBuffer> all{{}, ByteBuffer(1, std::byte{0})};
  all.emplace_back(60'000, std::byte{0xff});
  for (const std::size_t at : {std::size_t{0}, std::size_t{10}, std::size_t{18}}) {
    for (const std::int32_t length : {-1, 1, 0x7fffffff}) {
      all.push_back(good);
      Put(all.back().data() + at, length);
    }
  }
  for (const std::string& name : {std::string(), std::string("A,B"), std::string(40'000, 'N')}) {
    all.push_back(*EncodeShare({.source = "pFar", .key = name, .time = 5.0}));
  }
  Random random(11, "hostile");
  for (int i = 0; i < 300; ++i) {
    all.emplace_back(static_cast<std::size_t>(random.Uniform(1.0, 1500.0)));
    for (std::byte& byte : all.back()) {
      byte = static_cast<std::byte>(static_cast<int>(random.Uniform(0.0, 255.99)));
    }
    all.push_back(good);  // cut
    all.back().resize(static_cast<std::size_t>(random.Uniform(0.0, 60.0)));
  }
  return all;
}

TEST_P(TwoCommunitiesTest, AreUnharmedByHostileDatagrams) {
  const auto shore_port = shore_.Share(Params({}));
  vehicle_.Share(Params({"X->" + To(shore_port)}));
  UdpSockets enemy([] {});
  const ShareAddress target{.host = "127.0.0.1", .port = shore_port};
  enemy.Resolve(target);
  for (const ByteBuffer& datagram : HostileDatagrams()) {
    static_cast<void>(enemy.Send(target, datagram));
  }
  EXPECT_TRUE(shore_.AwaitCounts([](const ShareCounts& counts) {
    return counts.malformed + counts.not_sealed + counts.forged > 100.0;
  }));
  EXPECT_TRUE(shore_.AwaitThat("PSHARE_WARNINGS", [](const Message& message) {
    return std::get<std::string>(message.value).find("REFUSED_") != std::string::npos;
  }));
  vehicle_.Write("X", "still here");
  EXPECT_TRUE(shore_.Await("X").has_value());
  EXPECT_EQ(shore_.CountOf("HARMFUL"), 0U);
}

ByteBuffer Deploy() {
  return *EncodeShare({.data_type = wire_data::kString,
                       .source = "pFar",
                       .key = "DEPLOY",
                       .time = 5.0,
                       .text = "true"});
}
ByteBuffer SealDeploy(Sealer& sealer, const char* to, ShareInstant now) {
  return sealer.Seal(SealedContent::Kind::kData, ShareReceiverId(to), Deploy(), now);
}
/// That long ago, by both clocks.
ShareInstant Before(double seconds) {
  ShareInstant now = ShareInstant::Now();
  now.steady -= Seconds(seconds);
  now.unix -= Seconds(seconds);
  return now;
}

/// Somebody on the network, beside two communities that share a key.
class SealedCommunitiesTest : public TwoCommunitiesTest {
 protected:
  std::uint16_t ShareAtShore(double max_age = 5.0) {
    ShareParams params = Params({});
    params.max_age = Seconds(max_age);
    return shore_.Share(params);
  }
  void SendTo(std::uint16_t port, ByteView datagram) {
    const ShareAddress target{.host = "127.0.0.1", .port = port};
    peer_.Resolve(target);
    ASSERT_FALSE(peer_.Send(target, datagram));
  }
  ShareKey key_ = *LoadShareKey(folder_.path() / "fleet.key");
  UdpSockets peer_{[] {}};
};
INSTANTIATE_TEST_SUITE_P(Sealed, SealedCommunitiesTest, ::testing::Values(false));

TEST_P(SealedCommunitiesTest, LetNobodyInWhoHasAnotherKeyOrRepeatsWhatHeHeard) {
  const auto shore_port = shore_.Share(Params({}));
  const ShareKey key = *LoadShareKey(folder_.path() / "fleet.key");
  const ShareInstant now = ShareInstant::Now();
  Sealer vehicle(key, now), stranger(ShareKey::Random(), now);
  UdpSockets enemy([] {});
  const ShareAddress target{.host = "127.0.0.1", .port = shore_port};
  enemy.Resolve(target);
  const ByteBuffer deploy = Deploy();
  const ByteBuffer sealed = SealDeploy(vehicle, "shore", now);
  for (const ByteBuffer& datagram :
       {SealDeploy(stranger, "shore", now), deploy, sealed, sealed, sealed}) {
    ASSERT_FALSE(enemy.Send(target, datagram));
  }
  EXPECT_TRUE(shore_.AwaitCounts([](const ShareCounts& counts) {
    return counts.forged == 1.0 && counts.not_sealed == 1.0 && counts.replayed == 2.0 &&
           counts.taken == 1.0;
  }));
  EXPECT_EQ(shore_.CountOf("DEPLOY"), 1U);
}

TEST_P(SealedCommunitiesTest, BelieveNothingThatIsMeantForAnother) {
  const auto shore_port = ShareAtShore();
  Sealer sealer(key_, ShareInstant::Now());
  SendTo(shore_port, SealDeploy(sealer, "vehicle", ShareInstant::Now()));
  EXPECT_TRUE(
      shore_.AwaitCounts([](const ShareCounts& counts) { return counts.elsewhere == 1.0; }));
  EXPECT_EQ(shore_.CountOf("DEPLOY"), 0U);
}

TEST_P(SealedCommunitiesTest, BelieveNothingThatWasHeldBack) {
  const auto shore_port = ShareAtShore(0.5);
  std::this_thread::sleep_for(600ms);
  Sealer sealer(key_, Before(30.0));
  SendTo(shore_port, SealDeploy(sealer, "shore", Before(0.6)));
  SendTo(shore_port, SealDeploy(sealer, "shore", Before(20.0)));
  EXPECT_TRUE(shore_.AwaitCounts([](const ShareCounts& counts) { return counts.stale == 2.0; }));
  EXPECT_EQ(shore_.CountOf("DEPLOY"), 0U);
}

TEST_P(SealedCommunitiesTest, BelieveNothingThatWasRecordedBeforeARestart) {
  auto shore_port = ShareAtShore(0.5);
  Sealer sealer(key_, ShareInstant::Now());
  const ByteBuffer recorded = SealDeploy(sealer, "shore", ShareInstant::Now());
  SendTo(shore_port, recorded);
  ASSERT_TRUE(shore_.Await("DEPLOY").has_value());
  shore_.StopSharing();
  shore_port = ShareAtShore(0.5);  // there is no file that it could have forgotten
  SendTo(shore_port, recorded);
  EXPECT_TRUE(shore_.AwaitCounts([](const ShareCounts& counts) { return counts.stale == 1.0; }));
  EXPECT_EQ(shore_.CountOf("DEPLOY"), 1U);
}

TEST_P(SealedCommunitiesTest, BelieveASenderWhoseClockIsOffOnceItHasAnswered) {
  const auto shore_port = ShareAtShore();
  std::this_thread::sleep_for(500ms);  // nothing is believed that may be older than the shore
  const auto behind = [] {
    ShareInstant now = ShareInstant::Now();
    now.unix -= Seconds(33 * 60.0);
    return now;
  };
  const auto sealer = std::make_shared<Sealer>(key_, behind());
  ShareGuard guard(key_, {}, sealer, behind());
  SendTo(shore_port, SealDeploy(*sealer, "shore", behind()));
  const auto deadline = std::chrono::steady_clock::now() + 5s;
  for (bool has_answered = false; !has_answered && std::chrono::steady_clock::now() < deadline;) {
    for (const UdpSockets::Datagram& datagram : peer_.Take()) {
      const auto answer = guard.Answer(datagram.bytes, behind());
      ASSERT_TRUE(answer.has_value());
      peer_.Reply(datagram, *answer);
      has_answered = true;
    }
    std::this_thread::sleep_for(1ms);
  }
  EXPECT_TRUE(shore_.Await("DEPLOY").has_value());
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
// pShare without a database: its block, its commands, and what it sends and takes on real sockets.
#include "apps/pShare/share_app.hpp"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/app/registry.hpp"
#include "limpet/sharing/share_datagram.hpp"
#include "limpet/wire/message_conversion.hpp"
#include "tests/support/moos_captures.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/test_link.hpp"

namespace limpet {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

ConfigBlock Block(std::vector<std::pair<std::string, std::string>> lines) {
  ConfigBlock block{.name = "pShare", .where = {}, .entries = {}};
  int number = 10;
  for (auto& [key, value] : lines) {
    block.entries.push_back({key, value, {.file = "mission.moos", .line = number++}});
  }
  return block;
}
std::string Problems(std::vector<std::pair<std::string, std::string>> lines) {
  const auto problems = CheckShareBlock(Block(std::move(lines)));
  return problems.empty() ? "" : ConfigError(problems).what();
}

TEST(ShareBlock, OfAStockMissionIsRefusedWithTheWordThatIsMissing) {
  const std::string text =
      Problems({{"output", "src_name=X,route=localhost:9021"}, {"input", "route=localhost:9030"}});
  EXPECT_THAT(text, HasSubstr("mission.moos:10: output"));
  EXPECT_THAT(text, HasSubstr("mission.moos:11: input"));
  EXPECT_THAT(text, HasSubstr("`allow_plain_routes = true`"));
}

TEST(ShareBlock, OfAStockMissionIsGoodOnceThatIsSaid) {
  EXPECT_EQ(Problems({{"Output", "src_name=X,route=localhost:9021"},
                      {"Input", "route=localhost:9030"},
                      {"multicast_base_port", "24460"},
                      {"verbose", "true"},
                      {"AppTick", "2"},
                      {"allow_plain_routes", "true"}}),
            "");
}

TEST(ShareBlock, NamesLineAndNearestWordOfAMistake) {
  const std::string text = Problems({{"key_file", "k"}, {"output", "src=X,route=localhost:9021"}});
  EXPECT_THAT(text, HasSubstr("mission.moos:11: output"));
  EXPECT_THAT(text, HasSubstr("unknown word `src`"));
}

TEST(ShareBlock, SealsForNobodyInParticularOnlyByMulticast) {
  const std::string text = Problems({{"key_file", "k"},
                                     {"output", "src_name=X,route=localhost:9021"},
                                     {"output", "src_name=X,route=multicast_8"},
                                     {"output", "src_name=X,route=localhost:9021,to=shore"}});
  EXPECT_THAT(text, HasSubstr("mission.moos:11: output"));
  EXPECT_THAT(text, HasSubstr("`to = NAME`"));
  EXPECT_THAT(text, ::testing::Not(HasSubstr("mission.moos:12")));
  EXPECT_THAT(text, ::testing::Not(HasSubstr("mission.moos:13")));
  EXPECT_EQ(Problems({{"key_file", "k"}, {"to", "shore"}, {"output", "X->localhost:9021"}}), "");
}

/// One pShare on a link of ours, and a peer that sends and receives datagrams by itself.
class ShareAppTest : public ::testing::Test {
 protected:
  ShareAppTest() {
    const auto input = peer_.Listen({.host = "localhost", .port = 0}, "127.0.0.1");
    peer_port_ = peer_.PortOf(*input);
  }

  ShareApp& Start(ShareParams params, bool is_live = true) {
    AppContext context;
    context.name = "pShare";
    context.link = &link_;
    context.globals = {{"Community", "alpha", {}}};
    context.mission_folder = folder_.path();
    context.runs_live = is_live;
    app_ = std::make_unique<ShareApp>(context, params);
    return *app_;
  }
  static ShareParams Plain(std::vector<std::string> outputs, std::vector<std::string> inputs = {}) {
    ShareParams params;
    params.outputs = std::move(outputs);
    params.inputs = std::move(inputs);
    params.allows_plain_routes = true;
    return params;
  }
  [[nodiscard]] std::string ToPeer() const { return "localhost:" + std::to_string(peer_port_); }
  [[nodiscard]] MessagePtr Write(const std::string& name, Value value) const {
    return std::make_shared<const Message>(Message{.name = name,
                                                   .value = std::move(value),
                                                   .time = link_.time,
                                                   .source = "pSrc",
                                                   .source_aux = "",
                                                   .community = "alpha"});
  }
  /// The next datagram that the peer gets.
  std::optional<ByteBuffer> AwaitAtPeer() {
    std::unique_lock lock(mutex_);
    arrival_.wait_for(lock, 5s, [this] { return has_arrived_ || !got_.empty(); });
    has_arrived_ = false;
    for (auto& datagram : peer_.Take()) {
      got_.push_back(std::move(datagram.bytes));
    }
    if (got_.empty()) {
      return std::nullopt;
    }
    ByteBuffer first = std::move(got_.front());
    got_.erase(got_.begin());
    return first;
  }
  /// Sends to an input of the app, and lets the app work until it has counted that.
  void SendToApp(ByteView bytes, std::size_t which = 0) {
    const ShareAddress input{.host = "127.0.0.1", .port = app_->Ports().at(which)};
    peer_.Resolve(input);
    const std::string before = Counts();
    ASSERT_FALSE(peer_.Send(input, bytes));
    const auto deadline = std::chrono::steady_clock::now() + 5s;
    while (Counts() == before && std::chrono::steady_clock::now() < deadline) {
      std::this_thread::sleep_for(1ms);
    }
  }
  std::string Counts() {
    app_->Attend(link_.time);
    link_.time += Seconds(1.0);
    app_->Tick(link_.time);
    return EncodeRecord(CountsNow());
  }
  ShareCounts CountsNow() const { return link_.Last(topics::kShareCounts).value_or(ShareCounts()); }
  static ByteBuffer FarWrite(std::string_view name) {
    return *EncodeShare(
        {.source = "pFar", .community = "beta", .key = name, .time = 5.0, .number = 42.0});
  }
  const Message* Published(const std::string& name) const {
    for (const MessagePtr& message : link_.published) {
      if (message->name == name) {
        return message.get();
      }
    }
    return nullptr;
  }

  TemporaryFolder folder_;
  TestLink link_;
  std::mutex mutex_;
  std::condition_variable arrival_;
  bool has_arrived_ = false;
  std::vector<ByteBuffer> got_;
  UdpSockets peer_{[this] {
    const std::lock_guard lock(mutex_);
    has_arrived_ = true;
    arrival_.notify_one();
  }};
  std::uint16_t peer_port_ = 0;
  std::unique_ptr<ShareApp> app_;
};

TEST_F(ShareAppTest, SaysThatItSharesNothingEmbedded) {
  Start(Plain({"X->" + ToPeer()}), false);
  EXPECT_TRUE(app_->warnings().contains("NOT_LIVE"));
  app_->Tick(link_.time);
  EXPECT_THAT(link_.subscriptions, IsEmpty());
}

TEST_F(ShareAppTest, WarnsOfPlainRoutes) {
  Start(Plain({"X->" + ToPeer()}));
  EXPECT_TRUE(app_->warnings().contains("PLAIN_ROUTES"));
}

TEST_F(ShareAppTest, RefusesAKeyFileThatOthersMayRead) {
  const auto file = folder_.path() / "fleet.key";
  ASSERT_FALSE(SaveShareKey(ShareKey::Random(), file));
  std::filesystem::permissions(file, std::filesystem::perms::others_read,
                               std::filesystem::perm_options::add);
  ShareParams params;
  params.key_file = "fleet.key";
  params.inputs = {"route=localhost:0"};
  EXPECT_THROW(Start(params), ConfigError);
}

TEST_F(ShareAppTest, SendsWhatAStockPShareSendsByteForByte) {
  const auto files = Captures(".datagram.bin");
  ASSERT_FALSE(files.empty());
  Start(Plain({"src_name=X,dest_name=Y,route=" + ToPeer(), "NAV_*->V_:" + ToPeer(),
               "S->" + ToPeer(), "src_name=FAST,route=" + ToPeer() + ",frequency=2"}));
  int compared = 0;
  for (const auto& file : Captures(".datagram.bin")) {
    const ByteBuffer recorded = BytesOfFile(file);
    Message message = MessageFrom(*DecodeShare(recorded));
    message.name = message.name == "Y"             ? "X"
                   : message.name == "V_NAV_DEPTH" ? "NAV_DEPTH"
                                                   : message.name;
    app_->Deliver(std::make_shared<const Message>(message));
    if (message.name == "X" || message.name == "S" || message.name == "NAV_DEPTH" ||
        message.name == "FAST") {
      EXPECT_EQ(AwaitAtPeer(), recorded) << file;
      ++compared;
    }
  }
  EXPECT_EQ(compared, 4);
}

TEST_F(ShareAppTest, SharesAVariableOnceThoughANameAndAPatternMatchIt) {
  Start(Plain({"X->A:" + ToPeer(), "X*->B_:" + ToPeer(), "X?->C_:" + ToPeer()}));
  app_->Deliver(Write("X", 1.0));
  app_->Deliver(Write("X1", 1.0));
  std::vector<std::string> names;
  for (int i = 0; i < 4; ++i) {
    const auto datagram = AwaitAtPeer();
    ASSERT_TRUE(datagram.has_value());
    names.emplace_back(DecodeShare(*datagram)->key);
  }
  EXPECT_THAT(names, ::testing::ElementsAre("A", "B_X", "B_X1", "C_X1"));
  EXPECT_THAT(Counts(), HasSubstr("sent=4,"));
}

TEST_F(ShareAppTest, PostsWhatComesInUnderItsForeignSource) {
  Start(Plain({}, {"route=localhost:0, interface=127.0.0.1, white_list=REM_*"}));
  SendToApp(FarWrite("REM_A"));
  const Message* posted = Published("REM_A");
  ASSERT_NE(posted, nullptr);
  EXPECT_EQ(posted->source, "pFar");
  EXPECT_EQ(posted->community, "beta");
  EXPECT_EQ(posted->time, Seconds(5.0));
  SendToApp(FarWrite("NOTLISTED"));
  EXPECT_EQ(Published("NOTLISTED"), nullptr);
  EXPECT_EQ(CountsNow().unlisted, 1.0);
}

TEST_F(ShareAppTest, TakesNothingThatItSharesItselfByName) {
  Start(Plain({"X->" + ToPeer()}, {"route=localhost:0, interface=127.0.0.1"}));
  SendToApp(FarWrite("X"));
  EXPECT_EQ(Published("X"), nullptr);
  EXPECT_EQ(CountsNow().looped, 1.0);
}

TEST_F(ShareAppTest, TakesNoCommandsFromAfar) {
  Start(Plain({}, {"route=localhost:0, interface=127.0.0.1"}));
  SendToApp(FarWrite("PSHARE_CMD"));
  EXPECT_EQ(Published("PSHARE_CMD"), nullptr);
}

TEST_F(ShareAppTest, WarnsOfAMalformedDatagramAndForgetsItInTime) {
  Start(Plain({}, {"route=localhost:0, interface=127.0.0.1"}));
  SendToApp(ByteBuffer(10, std::byte{0xff}));
  EXPECT_EQ(CountsNow().malformed, 1.0);
  EXPECT_THAT(app_->warnings().at("REFUSED_malformed").text, HasSubstr("from 127.0.0.1:"));
  link_.time += Seconds(60.0);
  app_->Tick(link_.time);
  EXPECT_FALSE(app_->warnings().contains("REFUSED_malformed"));
}

TEST_F(ShareAppTest, SaysWhichVariableIsTooLarge) {
  Start(Plain({"X->" + ToPeer()}));
  app_->Deliver(Write("X", std::string(60'000, 'x')));
  EXPECT_THAT(app_->warnings().at("TOO_LARGE_X").text, HasSubstr("49152"));
  EXPECT_THAT(Counts(), HasSubstr("too_large=1,"));
  app_->Deliver(Write("X", 1.0));
  EXPECT_FALSE(app_->warnings().contains("TOO_LARGE_X"));
}

TEST_F(ShareAppTest, SaysWhichRouteTheSystemDoesNotTake) {
  Start(Plain({"X->255.255.255.255:9021"}));  // nobody asked for a broadcast
  app_->Deliver(Write("X", 1.0));
  EXPECT_TRUE(app_->warnings().contains("UNSENT_255.255.255.255:9021"));
}

TEST_F(ShareAppTest, TakesRoutesAtRunTime) {
  Start(Plain({}));
  app_->Deliver(Write("PSHARE_CMD", "cmd=output,src_name=X,route=" + ToPeer()));
  app_->Deliver(Write("PSHARE_CMD", std::string("cmd=input,route=localhost:0")));
  app_->Deliver(Write("X", 1.0));
  EXPECT_TRUE(AwaitAtPeer().has_value());
  app_->Tick(link_.time);
  EXPECT_EQ(link_.Last(topics::kShareOutputs), "X->X:" + ToPeer());
  EXPECT_EQ(link_.Last(topics::kShareInputs), "localhost:" + std::to_string(app_->Ports().at(0)));
}

TEST_F(ShareAppTest, IgnoresCommandsOfBeforeItsStart) {
  Start(Plain({}));
  link_.time -= Seconds(1.0);
  app_->Deliver(Write("PSHARE_CMD", "cmd=output,src_name=X,route=" + ToPeer()));
  app_->Tick(link_.time);
  EXPECT_EQ(link_.Last(topics::kShareOutputs), "");
}

TEST_F(ShareAppTest, SaysWhatIsWrongWithACommand) {
  Start({});
  app_->Deliver(Write("PSHARE_CMD", "cmd=output,src_name=X,route=" + ToPeer()));
  EXPECT_THAT(app_->warnings().at("BAD_COMMAND").text, HasSubstr("allow_plain_routes"));
}

/// A pShare with a key, whose block allows nothing plain.
class SealedShareAppTest : public ShareAppTest {
 protected:
  SealedShareAppTest() {
    EXPECT_FALSE(SaveShareKey(ShareKey::Random(), folder_.path() / "fleet.key"));
    EXPECT_FALSE(SaveShareKey(ShareKey::Random(), folder_.path() / "other.key"));
    params_.key_file = "fleet.key";
    params_.to = "shore";
  }
  void Command(const std::string& text) {
    app_->Deliver(Write("PSHARE_CMD", text));
    link_.time += Seconds(1.0);
    app_->Tick(link_.time);
  }
  ShareParams params_;
};

TEST_F(SealedShareAppTest, OpensNoPlainRouteByCommand) {
  Start(params_);
  Command("cmd=input,route=localhost:0,plain=true");
  EXPECT_THAT(app_->warnings().at("BAD_COMMAND").text, HasSubstr("`allow_plain_routes = true`"));
  EXPECT_THAT(app_->Ports(), IsEmpty());
  Command("cmd=output,src_name=X,plain=true,route=" + ToPeer());
  EXPECT_EQ(link_.Last(topics::kShareOutputs), "");
  EXPECT_EQ(CountsNow().commands, 2.0);
}

TEST_F(SealedShareAppTest, OpensSealedRoutesByCommandWithTheKeysOfItsBlockAlone) {
  Start(params_);
  Command("cmd=input,route=localhost:0,key=other.key");
  EXPECT_THAT(app_->warnings().at("BAD_COMMAND").text, HasSubstr("no key but those"));
  EXPECT_THAT(app_->Ports(), IsEmpty());
  Command("cmd=input,route=localhost:0");
  EXPECT_FALSE(app_->warnings().contains("BAD_COMMAND"));
  EXPECT_EQ(app_->Ports().size(), 1U);
}

TEST_F(ShareAppTest, ListensOnLoopbackWhereACommandOpensAPlainInput) {
  Start(Plain({}));
  app_->Deliver(Write("PSHARE_CMD", std::string("cmd=input,route=localhost:0,interface=0.0.0.0")));
  EXPECT_THAT(app_->warnings().at("BAD_COMMAND").text, HasSubstr("`command_interface`"));
  EXPECT_THAT(app_->Ports(), IsEmpty());
}

TEST_F(ShareAppTest, LetsInNoMoreThroughACommandsInputThanThroughItsBlocks) {
  Start(Plain({}, {"route=localhost:0, interface=127.0.0.1, white_list=REM_*"}));
  app_->Deliver(Write("PSHARE_CMD", std::string("cmd=input,route=localhost:0")));
  ASSERT_EQ(app_->Ports().size(), 2U);
  SendToApp(FarWrite("DEPLOY"), 1);
  EXPECT_EQ(CountsNow().unlisted, 1.0);
  SendToApp(FarWrite("REM_A"), 1);
  EXPECT_NE(Published("REM_A"), nullptr);
}

TEST_F(ShareAppTest, GoesOnTryingToListenAtAPortInUse) {
  Start(Plain({}, {"interface=127.0.0.1, route=" + ToPeer()}));
  EXPECT_TRUE(app_->warnings().contains("CANNOT_LISTEN_" + std::to_string(peer_port_)));
  EXPECT_THAT(app_->Ports(), IsEmpty());
}

TEST_F(ShareAppTest, ListensAtAPortThatIsFreeAgain) {
  auto other = std::make_unique<UdpSockets>([] {});
  const auto taken = other->Listen({.host = "localhost", .port = 0}, "127.0.0.1");
  const std::string port = std::to_string(other->PortOf(*taken));
  Start(Plain({}, {"interface=127.0.0.1, route=localhost:" + port}));
  EXPECT_TRUE(app_->warnings().contains("CANNOT_LISTEN_" + port));
  other.reset();
  link_.time += Seconds(1.0);
  app_->Tick(link_.time);
  EXPECT_FALSE(app_->warnings().contains("CANNOT_LISTEN_" + port));
  EXPECT_THAT(app_->Ports(), testing::SizeIs(1));
}

}  // namespace
}  // namespace limpet

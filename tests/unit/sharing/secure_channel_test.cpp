// SPDX-License-Identifier: MIT
#include "limpet/sharing/secure_channel.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "limpet/sharing/key_ring.hpp"
#include "limpet/sharing/share_gate.hpp"
#include "limpet/wire/message_codec.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

ByteBuffer Text(std::string_view text) {
  const auto* begin = reinterpret_cast<const std::byte*>(text.data());
  return {begin, begin + text.size()};
}

/// A moment by two clocks that agree.
ShareInstant At(double seconds) {
  return {.steady = Seconds(1000.0 + seconds), .unix = Seconds(1.8e9 + seconds)};
}

constexpr auto kData = SealedContent::Kind::kData;
const std::uint64_t kShore = ShareReceiverId("shore");

/// A vehicle that seals for the shore, and the shore. The shore has been there for a minute.
class ShareGuardTest : public ::testing::Test {
 protected:
  ByteBuffer Seal(std::string_view text, double at = 60.0) {
    return sealer_.Seal(kData, kShore, Text(text), At(at));
  }
  std::shared_ptr<ShareGuard> Guard(const char* name, double start, double max_age = 5.0) {
    return std::make_shared<ShareGuard>(
        key_, ShareGuard::Settings{.receiver = ShareReceiverId(name), .max_age = Seconds(max_age)},
        std::make_shared<Sealer>(key_, At(start)), At(start));
  }
  /// What became of a datagram: nothing if it was let in.
  std::optional<ShareRefusal> Judge(ByteView datagram, double at = 60.0) {
    return guard_->Judge(datagram, 0, At(at)).refusal;
  }

  ShareKey key_ = ShareKey::Random();
  Sealer sealer_{key_, At(50.0)};
  std::shared_ptr<ShareGuard> guard_ = Guard("shore", 0.0);
};

TEST_F(ShareGuardTest, OpensWhatWasSealed) {
  const auto verdict = guard_->Judge(Seal("depth 7.5"), 0, At(60.0));
  ASSERT_EQ(verdict.bodies.size(), 1U);
  EXPECT_EQ(verdict.bodies[0], Text("depth 7.5"));
}

TEST_F(ShareGuardTest, AddsWhatItSaysAndHidesTheRest) {
  const ByteBuffer sealed = Seal("depth 7.5");
  EXPECT_EQ(sealed.size(), 9 + kSealSize);
  const ByteBuffer said = Text("depth");
  EXPECT_EQ(std::search(sealed.begin(), sealed.end(), said.begin(), said.end()), sealed.end());
}

TEST_F(ShareGuardTest, RefusesADatagramWithAnyBitChanged) {
  const ByteBuffer sealed = Seal("depth 7.5");
  for (std::size_t i = 0; i < sealed.size() * 8; ++i) {
    ByteBuffer changed = sealed;
    changed[i / 8] ^= std::byte{1} << static_cast<int>(i % 8);
    EXPECT_TRUE(Judge(changed).has_value()) << "bit " << i;
  }
  EXPECT_FALSE(Judge(sealed).has_value()) << "forgeries leave no trace";
}

TEST_F(ShareGuardTest, RefusesACutOrLengthenedDatagram) {
  const ByteBuffer sealed = Seal("depth 7.5");
  for (std::size_t size = 0; size < sealed.size(); ++size) {
    EXPECT_TRUE(Judge(ByteView(sealed).first(size)).has_value()) << size;
  }
  ByteBuffer longer = sealed;
  longer.push_back(std::byte{0});
  EXPECT_EQ(Judge(longer), ShareRefusal::kForged);
}

TEST_F(ShareGuardTest, RefusesAnotherKey) {
  Sealer stranger(ShareKey::Random(), At(50.0));
  EXPECT_EQ(Judge(stranger.Seal(kData, kShore, Text("x"), At(60.0))), ShareRefusal::kForged);
}

TEST_F(ShareGuardTest, RefusesWhatIsMeantForAnotherVehicle) {
  const auto other = Guard("other", 0.0);
  const ByteBuffer sealed = Seal("DEPLOY");
  EXPECT_EQ(other->Judge(sealed, 0, At(60.0)).refusal, ShareRefusal::kElsewhere);
  EXPECT_FALSE(Judge(sealed)) << "whom it is meant for believes it";
}

TEST_F(ShareGuardTest, TakesWhatIsForAllOfAMulticastChannelThereAlone) {
  const std::uint64_t channel = ShareChannelId("224.1.1.11:24468:multicast_8");
  const ByteBuffer sealed = sealer_.Seal(kData, channel, Text("x"), At(60.0));
  EXPECT_EQ(Judge(sealed), ShareRefusal::kElsewhere);
  EXPECT_EQ(guard_->Judge(sealed, channel + 1, At(60.0)).refusal, ShareRefusal::kElsewhere);
  EXPECT_EQ(guard_->Judge(sealed, channel, At(60.0)).bodies.size(), 1U);
}

TEST_F(ShareGuardTest, RefusesWhatWasHeldBackThoughItIsTheFirstOfItsSender) {
  for (const double age : {5.1, 20.0, 3600.0}) {
    const auto guard = Guard("shore", 0.0);
    const auto verdict = guard->Judge(Seal("DEPLOY"), 0, At(60.0 + age));
    EXPECT_TRUE(verdict.bodies.empty()) << age;
    EXPECT_TRUE(verdict.reply.has_value()) << "the sender may say that its clock is off";
    EXPECT_EQ(guard->TakeGivenUp(At(60.0 + age + 5.1)), 1U) << "but nobody answers";
  }
}

TEST_F(ShareGuardTest, RefusesWhatWasHeldBackAmidOthers) {
  const ByteBuffer held = Seal("DEPLOY");
  EXPECT_FALSE(Judge(Seal("x", 60.1), 60.1));
  static_cast<void>(guard_->Judge(held, 0, At(80.0)));
  EXPECT_EQ(guard_->TakeGivenUp(At(90.0)), 1U);
}

TEST_F(ShareGuardTest, TakesASenderWhoseClockIsHalfAnHourBehindOnceItHasAnswered) {
  const auto behind = [](double at) {
    ShareInstant now = At(at);
    now.unix -= Seconds(33 * 60.0);
    now.steady -= Seconds(500.0);  // nor do they count from one origin
    return now;
  };
  const auto shore_sealer = std::make_shared<Sealer>(key_, behind(50.0));
  ShareGuard shore(key_, {.receiver = ShareReceiverId("shore")}, shore_sealer, behind(50.0));
  const auto vehicle = Guard("vehicle", 0.0);
  const std::uint64_t to = ShareReceiverId("vehicle");
  const ByteBuffer deploy = shore_sealer->Seal(kData, to, Text("DEPLOY"), behind(60.0));
  const auto first = vehicle->Judge(deploy, 0, At(60.1));
  EXPECT_TRUE(first.bodies.empty());
  ASSERT_TRUE(first.reply.has_value());
  const auto answer = shore.Answer(*first.reply, behind(60.2));
  ASSERT_TRUE(answer.has_value());
  const auto then = vehicle->Judge(*answer, 0, At(60.3));
  ASSERT_EQ(then.bodies.size(), 1U) << "what has waited for the answer";
  EXPECT_EQ(then.bodies[0], Text("DEPLOY"));
  const ByteBuffer next = shore_sealer->Seal(kData, to, Text("RETURN"), behind(70.0));
  EXPECT_EQ(vehicle->Judge(next, 0, At(70.1)).bodies.size(), 1U);
  const ByteBuffer held = shore_sealer->Seal(kData, to, Text("RETURN"), behind(80.0));
  EXPECT_EQ(vehicle->Judge(held, 0, At(100.0)).refusal, ShareRefusal::kStale);
  EXPECT_EQ(vehicle->Judge(*answer, 0, At(101.0)).refusal, ShareRefusal::kReplayed);
}

TEST_F(ShareGuardTest, AnswersItsOwnQuestionsAlone) {
  const auto question = guard_->Judge(Seal("x"), 0, At(60.0)).reply;
  ASSERT_TRUE(question.has_value());
  EXPECT_FALSE(Guard("other", 0.0)->Answer(*question, At(60.0)).has_value());
  EXPECT_FALSE(guard_->Answer(Seal("x"), At(60.0)).has_value());
}

TEST_F(ShareGuardTest, TakesADatagramOnce) {
  const ByteBuffer sealed = Seal("DEPLOY");
  EXPECT_FALSE(Judge(sealed).has_value());
  EXPECT_EQ(Judge(sealed), ShareRefusal::kReplayed);
}

TEST_F(ShareGuardTest, TakesDatagramsInAnyOrderWithinTheWindow) {
  std::vector<ByteBuffer> sealed;
  for (std::size_t i = 0; i < ReplayWindow::kWidth; ++i) {
    sealed.push_back(Seal("x"));
  }
  std::ranges::reverse(sealed);
  for (const ByteBuffer& datagram : sealed) {
    EXPECT_FALSE(Judge(datagram).has_value());
  }
}

TEST_F(ShareGuardTest, RefusesWhatIsBehindTheWindow) {
  const ByteBuffer late = Seal("x");
  for (std::size_t i = 0; i < ReplayWindow::kWidth; ++i) {
    EXPECT_FALSE(Judge(Seal("x")).has_value());
  }
  EXPECT_EQ(Judge(late), ShareRefusal::kReplayed);
}

TEST_F(ShareGuardTest, BelievesNothingOfBeforeItsStart) {
  const ByteBuffer recorded = Seal("DEPLOY");
  EXPECT_FALSE(Judge(recorded));
  // A new process, with nothing to remember: no file could be emptied.
  const auto restarted = Guard("shore", 61.0);
  for (const double at : {61.0, 61.5, 63.0, 100.0}) {
    EXPECT_TRUE(restarted->Judge(recorded, 0, At(at)).bodies.empty()) << at;
  }
  EXPECT_EQ(restarted->Judge(Seal("x", 61.6), 0, At(61.7)).bodies.size(), 1U);
}

TEST_F(ShareGuardTest, TakesASenderThatHasStartedAnew) {
  EXPECT_FALSE(Judge(Seal("x")).has_value());
  Sealer restarted(key_, At(61.0));
  EXPECT_FALSE(Judge(restarted.Seal(kData, kShore, Text("x"), At(61.1)), 61.2).has_value());
}

TEST_F(ShareGuardTest, RefusesItsOwnDatagramsSentBack) {
  const auto sealer = std::make_shared<Sealer>(key_, At(0.0));
  ShareGuard guard(key_, {.receiver = kShore}, sealer, At(0.0));
  EXPECT_EQ(guard.Judge(sealer->Seal(kData, kShore, Text("x"), At(1.0)), 0, At(1.0)).refusal,
            ShareRefusal::kOwn);
}

TEST_F(ShareGuardTest, TellsPlainDatagramsAndThoseOfFormerVersionsApart) {
  EXPECT_EQ(Judge(Text("hello, this is no sealed datagram at all, but long enough")),
            ShareRefusal::kNotSealed);
  EXPECT_EQ(Judge(Text("LSH1 and then what a former Limpet has sealed, so many bytes")),
            ShareRefusal::kOldVersion);
}

TEST(ReplayWindow, ForgetsEverythingAfterALongGap) {
  ReplayWindow window;
  window.Take(5);
  window.Take(5 + 10 * ReplayWindow::kWidth);
  EXPECT_FALSE(window.IsNew(5));
  EXPECT_TRUE(window.IsNew(5 + 10 * ReplayWindow::kWidth - 1));
  EXPECT_TRUE(window.IsNew(UINT64_MAX));
}

TEST(KeyRing, NeverSealsTwiceUnderOneNonce) {
  const TemporaryFolder folder;
  const ShareKey key = ShareKey::Random();
  ASSERT_FALSE(SaveShareKey(key, folder.path() / "a"));
  ASSERT_FALSE(SaveShareKey(key, folder.path() / "copy_of_a"));
  KeyRing keys(folder.path(), {});
  EXPECT_EQ(keys.Load("a", At(0.0))->sealer, keys.Load("copy_of_a", At(0.0))->sealer);
  KeyRing again(folder.path(), {});
  EXPECT_NE(keys.Load("a", At(0.0))->sealer->run(), again.Load("a", At(0.0))->sealer->run());
}

class ShareGateTest : public ::testing::Test {
 protected:
  static ByteBuffer Write(std::string_view name) {
    ByteBuffer bytes;
    AppendMessage({.source = "pFar", .community = "alpha", .key = name, .time = 5, .number = 3.0},
                  bytes);
    return bytes;
  }
  static std::optional<ShareRefusal> Refusal(ShareGate& gate, ByteView datagram) {
    const ShareAdmission admission = gate.Admit(datagram, At(60.0));
    EXPECT_EQ(admission.messages.size() + admission.refusals.size(), 1U);
    return admission.refusals.empty() ? std::nullopt : std::optional(admission.refusals[0]);
  }
  ByteBuffer Seal(ByteView plain) { return sealer_.Seal(kData, kShore, plain, At(60.0)); }
  std::shared_ptr<ShareGuard> Guard() {
    return std::make_shared<ShareGuard>(key_, ShareGuard::Settings{.receiver = kShore},
                                        std::make_shared<Sealer>(key_, At(0.0)), At(0.0));
  }
  ShareKey key_ = ShareKey::Random();
  Sealer sealer_{key_, At(50.0)};
};

TEST_F(ShareGateTest, LetsInWhatTheWhiteListNames) {
  ShareGate gate(nullptr, {{"REM_*", "B?"}});
  EXPECT_FALSE(Refusal(gate, Write("REM_A")));
  EXPECT_FALSE(Refusal(gate, Write("B1")));
  EXPECT_EQ(Refusal(gate, Write("NOTLISTED")), ShareRefusal::kUnlisted);
}

TEST_F(ShareGateTest, LetsInWhatIsOnEveryListThatHoldsAnything) {
  ShareGate gate(nullptr, {{"REM_*"}, {}, {"*_A"}});
  EXPECT_FALSE(Refusal(gate, Write("REM_A")));
  EXPECT_EQ(Refusal(gate, Write("REM_B")), ShareRefusal::kUnlisted);
}

TEST_F(ShareGateTest, KeepsSourceCommunityAndTime) {
  ShareGate gate(nullptr, {});
  const ShareAdmission admission = gate.Admit(Write("X"), At(60.0));
  ASSERT_EQ(admission.messages.size(), 1U);
  EXPECT_EQ(admission.messages[0].source, "pFar");
  EXPECT_EQ(admission.messages[0].community, "alpha");
  EXPECT_EQ(admission.messages[0].time, Seconds(5.0));
}

TEST_F(ShareGateTest, TellsSealedAndPlainApart) {
  ShareGate plain(nullptr, {}), sealed(Guard(), {});
  EXPECT_EQ(Refusal(plain, Seal(Write("X"))), ShareRefusal::kSealed);
  EXPECT_EQ(Refusal(sealed, Write("X")), ShareRefusal::kNotSealed);
  EXPECT_FALSE(Refusal(sealed, Seal(Write("X"))));
}

TEST_F(ShareGateTest, LooksIntoWhatItOpens) {
  ShareGate gate(Guard(), {});
  EXPECT_EQ(Refusal(gate, Seal(Text("no message"))), ShareRefusal::kMalformed);
}

}  // namespace
}  // namespace limpet

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

class SecureChannelTest : public ::testing::Test {
 protected:
  static constexpr std::uint64_t kVehicle = 1, kShore = 2;

  Sealer VehicleSince(std::uint64_t epoch) { return {key_, kVehicle, epoch}; }
  /// What became of a datagram: nothing if it was let in.
  std::optional<ShareRefusal> Open(ByteView datagram) {
    const auto opened = opener_.Open(datagram);
    return opened ? std::nullopt : std::optional(opened.error());
  }

  ShareKey key_ = ShareKey::Random();
  Sealer sealer_{key_, kVehicle, 100};
  Opener opener_{key_, kShore};
};

TEST_F(SecureChannelTest, OpensWhatWasSealed) {
  const auto opened = opener_.Open(sealer_.Seal(Text("depth 7.5")));
  ASSERT_TRUE(opened.has_value());
  EXPECT_EQ(*opened, Text("depth 7.5"));
}

TEST_F(SecureChannelTest, AddsWhatItSaysAndHidesTheRest) {
  const ByteBuffer sealed = sealer_.Seal(Text("depth 7.5"));
  EXPECT_EQ(sealed.size(), 9 + kSealSize);
  EXPECT_TRUE(std::ranges::search(sealed, Text("depth")).empty());
}

TEST_F(SecureChannelTest, RefusesADatagramWithAnyBitChanged) {
  const ByteBuffer sealed = sealer_.Seal(Text("depth 7.5"));
  for (std::size_t i = 0; i < sealed.size() * 8; ++i) {
    ByteBuffer changed = sealed;
    changed[i / 8] ^= std::byte{1} << static_cast<int>(i % 8);
    EXPECT_TRUE(Open(changed).has_value()) << "bit " << i;
  }
  EXPECT_FALSE(Open(sealed).has_value()) << "forgeries leave no trace";
}

TEST_F(SecureChannelTest, RefusesACutOrLengthenedDatagram) {
  const ByteBuffer sealed = sealer_.Seal(Text("depth 7.5"));
  for (std::size_t size = 0; size < sealed.size(); ++size) {
    EXPECT_TRUE(Open(ByteView(sealed).first(size)).has_value()) << size;
  }
  ByteBuffer longer = sealed;
  longer.push_back(std::byte{0});
  EXPECT_EQ(Open(longer), ShareRefusal::kForged);
}

TEST_F(SecureChannelTest, RefusesAnotherKey) {
  Sealer stranger(ShareKey::Random(), kVehicle, 100);
  EXPECT_EQ(Open(stranger.Seal(Text("x"))), ShareRefusal::kForged);
}

TEST_F(SecureChannelTest, TakesADatagramOnce) {
  const ByteBuffer sealed = sealer_.Seal(Text("DEPLOY"));
  EXPECT_FALSE(Open(sealed).has_value());
  EXPECT_EQ(Open(sealed), ShareRefusal::kReplayed);
}

TEST_F(SecureChannelTest, TakesDatagramsInAnyOrderWithinTheWindow) {
  std::vector<ByteBuffer> sealed;
  for (std::size_t i = 0; i < ReplayWindow::kWidth; ++i) {
    sealed.push_back(sealer_.Seal(Text("x")));
  }
  std::ranges::reverse(sealed);
  for (const ByteBuffer& datagram : sealed) {
    EXPECT_FALSE(Open(datagram).has_value());
  }
}

TEST_F(SecureChannelTest, RefusesWhatIsBehindTheWindow) {
  const ByteBuffer late = sealer_.Seal(Text("x"));
  for (std::size_t i = 0; i < ReplayWindow::kWidth; ++i) {
    EXPECT_FALSE(Open(sealer_.Seal(Text("x"))).has_value());
  }
  EXPECT_EQ(Open(late), ShareRefusal::kReplayed);
}

TEST_F(SecureChannelTest, TakesASenderThatHasStartedAnew) {
  EXPECT_FALSE(Open(sealer_.Seal(Text("x"))).has_value());
  Sealer restarted = VehicleSince(101);
  EXPECT_FALSE(Open(restarted.Seal(Text("x"))).has_value());
}

TEST_F(SecureChannelTest, RefusesAFormerSession) {
  const ByteBuffer former = sealer_.Seal(Text("DEPLOY"));
  Sealer restarted = VehicleSince(101);
  EXPECT_FALSE(Open(restarted.Seal(Text("x"))).has_value());
  EXPECT_EQ(Open(former), ShareRefusal::kFormer);
}

TEST_F(SecureChannelTest, KeepsSendersApart) {
  Sealer other(key_, 3, 50);
  EXPECT_FALSE(Open(sealer_.Seal(Text("x"))).has_value());
  EXPECT_FALSE(Open(other.Seal(Text("x"))).has_value());
}

TEST_F(SecureChannelTest, RefusesItsOwnDatagramsSentBack) {
  Sealer own(key_, kShore, 100);
  EXPECT_EQ(Open(own.Seal(Text("x"))), ShareRefusal::kOwn);
}

TEST_F(SecureChannelTest, RefusesPlainDatagrams) {
  EXPECT_EQ(Open(Text("hello, this is no sealed datagram at all, but long enough")),
            ShareRefusal::kNotSealed);
}

TEST_F(SecureChannelTest, RemembersWhatItTookBeforeARestart) {
  const ByteBuffer first = sealer_.Seal(Text("x")), second = sealer_.Seal(Text("y"));
  opener_.Remember(kVehicle, sealer_.epoch(), 0);
  EXPECT_EQ(Open(first), ShareRefusal::kReplayed);
  EXPECT_FALSE(Open(second).has_value());
}

TEST(ShareEpoch, OnlyGoesForwardWhateverTheClockSays) {
  const std::uint64_t first = NewShareEpoch(Seconds(2e9));
  EXPECT_GT(NewShareEpoch(Seconds(1e9), first), first);
  EXPECT_GT(NewShareEpoch(Seconds(2e9 + 1.0)), first);
}

TEST(ReplayWindow, ForgetsEverythingAfterALongGap) {
  ReplayWindow window;
  window.Take(1, 5);
  window.Take(1, 5 + 10 * ReplayWindow::kWidth);
  EXPECT_EQ(window.Judge(1, 5), ReplayWindow::Verdict::kTooOld);
  EXPECT_EQ(window.Judge(1, 5 + 10 * ReplayWindow::kWidth - 1), ReplayWindow::Verdict::kNew);
  EXPECT_EQ(window.Judge(1, UINT64_MAX), ReplayWindow::Verdict::kNew);
}

TEST(KeyRing, NeverSealsTwiceUnderOneNonce) {
  const TemporaryFolder folder;
  const ShareKey key = ShareKey::Random();
  ASSERT_FALSE(SaveShareKey(key, folder.path() / "a"));
  ASSERT_FALSE(SaveShareKey(key, folder.path() / "copy_of_a"));
  KeyRing keys(folder.path(), "alpha/pShare", Seconds(2e9));
  EXPECT_EQ(keys.Load("a")->sealer, keys.Load("copy_of_a")->sealer);
}

TEST(KeyRing, RemembersAfterARestartWhatItTook) {
  const TemporaryFolder folder;
  const ShareKey key = ShareKey::Random();
  ASSERT_FALSE(SaveShareKey(key, folder.path() / "a"));
  Sealer vehicle(key, 1, 100);
  const ByteBuffer first = vehicle.Seal(Text("DEPLOY")), second = vehicle.Seal(Text("x"));
  {
    KeyRing keys(folder.path(), "shore/pShare", Seconds(2e9));
    ASSERT_TRUE(keys.Load("a")->opener->Open(first).has_value());
    ASSERT_FALSE(keys.Save());
  }
  KeyRing keys(folder.path(), "shore/pShare", Seconds(2e9));
  const auto repeated = keys.Load("a")->opener->Open(first);
  ASSERT_FALSE(repeated.has_value());
  EXPECT_EQ(repeated.error(), ShareRefusal::kReplayed);
  EXPECT_TRUE(keys.Load("a")->opener->Open(second).has_value());
}

TEST(KeyRing, BeginsALaterEpochThoughTheClockWentBack) {
  const TemporaryFolder folder;
  ASSERT_FALSE(SaveShareKey(ShareKey::Random(), folder.path() / "a"));
  KeyRing before(folder.path(), "alpha/pShare", Seconds(2e9));
  const std::uint64_t epoch = before.Load("a")->sealer->epoch();
  ASSERT_FALSE(before.Save());
  KeyRing after(folder.path(), "alpha/pShare", Seconds(0.0));
  EXPECT_GT(after.Load("a")->sealer->epoch(), epoch);
}

TEST(ShareMemory, LeavesOutWhatItCannotRead) {
  const ShareMemory memory = ShareMemory::Parse("own 1f\n2 3 4\nnonsense\n5 6 x\n7 8\n\xff\n");
  EXPECT_EQ(memory.own_epoch, 0x1fU);
  EXPECT_EQ(memory.heard, (std::map<std::uint64_t, ShareMemory::Heard>{{2, {3, 4}}}));
  EXPECT_EQ(ShareMemory::Parse(memory.Text()), memory);
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
    const auto admitted = gate.Admit(datagram);
    return admitted ? std::nullopt : std::optional(admitted.error());
  }
  ShareKey key_ = ShareKey::Random();
};

TEST_F(ShareGateTest, LetsInWhatTheWhiteListNames) {
  ShareGate gate(nullptr, {"REM_*", "B?"});
  EXPECT_FALSE(Refusal(gate, Write("REM_A")));
  EXPECT_FALSE(Refusal(gate, Write("B1")));
  EXPECT_EQ(Refusal(gate, Write("NOTLISTED")), ShareRefusal::kUnlisted);
}

TEST_F(ShareGateTest, KeepsSourceCommunityAndTime) {
  ShareGate gate(nullptr, {});
  const auto message = gate.Admit(Write("X"));
  ASSERT_TRUE(message.has_value());
  EXPECT_EQ(message->source, "pFar");
  EXPECT_EQ(message->community, "alpha");
  EXPECT_EQ(message->time, Seconds(5.0));
}

TEST_F(ShareGateTest, TellsSealedAndPlainApart) {
  Sealer sealer(key_, 1, 100);
  ShareGate plain(nullptr, {}), sealed(std::make_shared<Opener>(key_, 2), {});
  EXPECT_EQ(Refusal(plain, sealer.Seal(Write("X"))), ShareRefusal::kSealed);
  EXPECT_EQ(Refusal(sealed, Write("X")), ShareRefusal::kNotSealed);
  EXPECT_FALSE(Refusal(sealed, sealer.Seal(Write("X"))));
}

TEST_F(ShareGateTest, LooksIntoWhatItOpens) {
  Sealer sealer(key_, 1, 100);
  ShareGate gate(std::make_shared<Opener>(key_, 2), {});
  EXPECT_EQ(Refusal(gate, sealer.Seal(Text("no message"))), ShareRefusal::kMalformed);
}

}  // namespace
}  // namespace limpet

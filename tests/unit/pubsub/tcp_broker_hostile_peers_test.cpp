// SPDX-License-Identifier: MIT
// Peers that mean harm, or are broken: the broker and everybody else stay as they are.
#include <memory>
#include <vector>

#include "limpet/core/random.hpp"
#include "limpet/wire/little_endian.hpp"
#include "tests/support/loopback_broker.hpp"

namespace limpet {
namespace {

using namespace std::chrono_literals;

using HostilePeers = LoopbackBroker;

TEST_F(HostilePeers, TakesAGreetingInPieces) {
  const RawPeer peer(broker_->port());
  const auto* bytes = reinterpret_cast<const std::byte*>(kGreeting.data());
  for (std::size_t i = 0; i < kGreeting.size(); ++i) {
    peer.Send({bytes + i, 1});
  }
  peer.Send(PacketOf({.type = wire_type::kHello,
                      .data_type = wire_data::kString,
                      .key = "asynchronous",
                      .text = "pPieces"}));
  EXPECT_EQ(peer.Answer(), wire_type::kWelcome);
}

TEST_F(HostilePeers, HangsUpOnASilentConnection) {
  const RawPeer peer(broker_->port());
  EXPECT_TRUE(peer.IsClosed());
  ExpectHealthy();
}

TEST_F(HostilePeers, HangsUpOnAWrongGreeting) {
  const RawPeer peer(broker_->port());
  peer.Send(ByteBuffer(32, std::byte{'x'}));
  EXPECT_TRUE(peer.IsClosed());
  ExpectHealthy();
}

TEST_F(HostilePeers, HangsUpOnLengthsThatCannotBe) {
  int round = 0;
  for (const std::int32_t length : {-1, 0, 8, 0x7fffffff}) {
    const RawPeer peer(broker_->port());
    peer.Hello("pLiar" + std::to_string(round++));
    ASSERT_EQ(peer.Answer(), wire_type::kWelcome);
    ByteBuffer header(69);
    Put(Put(header.data(), length), std::int32_t{1});
    peer.Send(header);
    EXPECT_TRUE(peer.IsClosed()) << length;
  }
  ExpectHealthy();
}

TEST_F(HostilePeers, HangsUpOnHellosOfLengthsThatCannotBe) {
  for (const std::int32_t length : {-1, 0, 8, 1 << 20, 0x7fffffff}) {
    const RawPeer peer(broker_->port());
    peer.Greet();
    ByteBuffer header(69);
    Put(Put(header.data(), length), std::int32_t{1});
    peer.Send(header);
    EXPECT_TRUE(peer.IsClosed()) << length;
  }
  ExpectHealthy();
}

TEST_F(HostilePeers, HangsUpOnMessagesThatDoNotFitTheirPacket) {
  int round = 0;
  for (const std::int32_t length : {-1, 0, 53, 1'000'000, 0x7fffffff}) {
    const RawPeer peer(broker_->port());
    peer.Hello("pLarge" + std::to_string(round++));
    ASSERT_EQ(peer.Answer(), wire_type::kWelcome);
    ByteBuffer packet = PacketOf({.source = "pLarge", .key = "X"});
    Put(packet.data() + kPacketHeaderSize, length);
    peer.Send(packet);
    EXPECT_TRUE(peer.IsClosed()) << length;
  }
  ExpectHealthy();
}

TEST_F(HostilePeers, DelaysNobodyForThoseWhoStopInTheMiddle) {
  std::vector<std::unique_ptr<RawPeer>> peers;
  const ByteBuffer packet = PacketOf({.source = "pHalf", .key = "X", .text = "some text"});
  for (int i = 0; i < 40; ++i) {
    peers.push_back(std::make_unique<RawPeer>(broker_->port()));  // says nothing
    peers.push_back(std::make_unique<RawPeer>(broker_->port()));
    peers.back()->Send({reinterpret_cast<const std::byte*>(kGreeting.data()), 9});
    peers.push_back(std::make_unique<RawPeer>(broker_->port()));
    peers.back()->Hello("pHalf" + std::to_string(i));
    peers.back()->Send(ByteView(packet).first(40));
  }
  ExpectHealthy();
}

TEST_F(HostilePeers, TakesNoVariableWhoseNameIsNoneOrAMegabyte) {
  const RawPeer peer(broker_->port());
  peer.Hello("pNamer");
  ASSERT_EQ(peer.Answer(), wire_type::kWelcome);
  const std::string megabyte(1 << 20, 'N');
  for (const std::string_view name : {std::string_view(), std::string_view(megabyte)}) {
    peer.Send(PacketOf({.source = "pNamer", .key = name}));
    peer.Send(
        PacketOf({.type = wire_type::kRegister, .source = "pNamer", .key = name, .number = 0.0}));
  }
  MailInbox inbox;
  const auto reader = Join("pReader", &inbox);
  reader->Subscribe("DB_REFUSED", Seconds(0.0));
  EXPECT_TRUE(inbox.AwaitText(
      "type_mismatch=0,foreign_source=0,bad_name=4,no_room=0,stranger=0,unfinished=0,stalled=0,"
      "silent=0"));
}

TEST_F(HostilePeers, CarriesAVariableWithACommaInItsName) {
  MailInbox inbox;
  const auto reader = Join("pReader", &inbox);
  reader->Subscribe("A,B", Seconds(0.0));
  const auto writer = Join("pWriter");
  writer->Publish("A,B", 1.0);
  EXPECT_TRUE(inbox.Await("A,B").has_value());
  ExpectHealthy();
}

TEST_F(HostilePeers, HangsUpOnAMillionMessagesIn69Bytes) {
  const RawPeer peer(broker_->port());
  peer.Hello("pMillion");
  ASSERT_EQ(peer.Answer(), wire_type::kWelcome);
  ByteBuffer packet(69);
  Put(Put(packet.data(), std::int32_t{69}), std::int32_t{1'000'000});
  peer.Send(packet);
  EXPECT_TRUE(peer.IsClosed());
  ExpectHealthy();
}

TEST_F(HostilePeers, HangsUpOnStringsThatDoNotFitTheirMessage) {
  int round = 0;
  for (const std::int32_t length : {-1, -2'000'000'000, 1'000'000, 0x7fffffff}) {
    const RawPeer peer(broker_->port());
    peer.Hello("pLong" + std::to_string(round++));
    ASSERT_EQ(peer.Answer(), wire_type::kWelcome);
    ByteBuffer packet = PacketOf({.source = "pLong", .key = "X"});
    Put(packet.data() + kPacketHeaderSize + 10, length);
    peer.Send(packet);
    EXPECT_TRUE(peer.IsClosed()) << length;
  }
  ExpectHealthy();
}

TEST_F(HostilePeers, RefusesNamesThatWouldGarbleItsLists) {
  for (const std::string& name :
       {std::string(), std::string("a,b"), std::string("a\nb"), std::string(2000, 'n')}) {
    const RawPeer peer(broker_->port());
    peer.Hello(name);
    EXPECT_EQ(peer.Answer(), wire_type::kPoison);
  }
  const RawPeer megabyte(broker_->port());
  megabyte.Hello(std::string(1 << 20, 'n'));
  EXPECT_TRUE(megabyte.IsClosed());
  ExpectHealthy();
}

TEST_F(HostilePeers, RefusesANameInUse) {
  const RawPeer first(broker_->port());
  first.Hello("pTwin");
  ASSERT_EQ(first.Answer(), wire_type::kWelcome);
  const RawPeer second(broker_->port());
  second.Hello("pTwin");
  EXPECT_EQ(second.Answer(), wire_type::kPoison);
}

TEST_F(HostilePeers, IgnoresARegistrationInAnothersName) {
  MailInbox inbox;
  const auto victim = Join("pVictim", &inbox);
  const RawPeer spoofer(broker_->port());
  spoofer.Hello("pSpoofer");
  ASSERT_EQ(spoofer.Answer(), wire_type::kWelcome);
  spoofer.Send(
      PacketOf({.type = wire_type::kRegister, .source = "pVictim", .key = "FLOOD", .number = 0.0}));
  ExpectHealthy("FLOOD");
  EXPECT_FALSE(inbox.Await("FLOOD", 100ms).has_value());
}

TEST_F(HostilePeers, HangsUpOnAStrangerWhoAnnouncesMoreThanAHello) {
  const RawPeer peer(broker_->port());
  peer.Greet();
  ByteBuffer header(69);
  Put(Put(header.data(), std::int32_t{5000}), std::int32_t{1});
  peer.Send(header);
  EXPECT_TRUE(peer.IsClosed());
}

TEST_F(HostilePeers, SurvivesRandomAndMutatedPackets) {
  Random random(11, "hostile");
  for (int round = 0; round < 60; ++round) {
    const RawPeer peer(broker_->port());
    peer.Hello("pFuzz" + std::to_string(round));
    ByteBuffer packet = PacketOf({.source = "pFuzz", .key = "X", .text = "some text"});
    for (int k = 0; k < 1 + round % 8; ++k) {
      packet[static_cast<std::size_t>(random.Uniform(0.0, static_cast<double>(packet.size())))] =
          static_cast<std::byte>(random.Uniform(0.0, 256.0));
    }
    peer.Send(packet);
    ByteBuffer noise(200);
    for (std::byte& byte : noise) {
      byte = static_cast<std::byte>(random.Uniform(0.0, 256.0));
    }
    peer.Send(noise);
  }
  ExpectHealthy();
}

}  // namespace
}  // namespace limpet

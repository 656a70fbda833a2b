// SPDX-License-Identifier: MIT
// The broker on real sockets: clients of ours, and peers that mean harm.
#include "limpet/pubsub/tcp_broker.hpp"

#include <algorithm>
#include <atomic>
#include <thread>

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include "limpet/core/clock.hpp"
#include "limpet/core/random.hpp"
#include "limpet/pubsub/tcp_client.hpp"
#include "limpet/wire/little_endian.hpp"
#include "tests/support/mail_inbox.hpp"

namespace limpet {
namespace {

using namespace std::chrono_literals;

class TcpBrokerTest : public testing::Test {
 protected:
  TcpBrokerTest() {
    TcpBrokerOptions options;
    options.broker.community = "alpha";
    options.port = 0;
    options.handshake_timeout = Seconds(0.4);
    broker_ = std::make_unique<TcpBroker>(options);
    thread_ = std::thread([this] { broker_->Run(); });
  }
  ~TcpBrokerTest() override {
    broker_->Stop();
    thread_.join();
  }
  TcpBrokerTest(const TcpBrokerTest&) = delete;
  TcpBrokerTest& operator=(const TcpBrokerTest&) = delete;

  std::unique_ptr<TcpClient> Join(const std::string& name, MailInbox* inbox = nullptr) {
    return std::make_unique<TcpClient>(TcpClientOptions{.port = broker_->port(),
                                                        .name = name,
                                                        .on_mail =
                                                            [inbox](const WireMessage& message) {
                                                              if (inbox != nullptr) {
                                                                inbox->Add(message);
                                                              }
                                                            },
                                                        .on_state = nullptr});
  }

  /// The community works: a value goes from one client to another.
  void ExpectHealthy(const std::string& name = "HEALTH") {
    MailInbox inbox;
    const auto reader = Join("pHealthReader" + name, &inbox);
    reader->Subscribe(name, Seconds(0.0));
    const auto writer = Join("pHealthWriter" + name);
    writer->Publish(name, 42.0);
    const auto heard = inbox.Await(name);
    ASSERT_TRUE(heard.has_value());
    EXPECT_EQ(std::get<double>(heard->value), 42.0);
  }

  std::unique_ptr<TcpBroker> broker_;
  std::thread thread_;
};

/// A peer that writes whatever bytes it likes.
class RawPeer {
 public:
  explicit RawPeer(std::uint16_t port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in place{};
    place.sin_family = AF_INET;
    place.sin_port = htons(port);
    place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(::connect(socket_, reinterpret_cast<sockaddr*>(&place), sizeof place), 0);
    const timeval longest{.tv_sec = 5, .tv_usec = 0};
    ::setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &longest, sizeof longest);
  }
  ~RawPeer() { ::close(socket_); }
  RawPeer(const RawPeer&) = delete;
  RawPeer& operator=(const RawPeer&) = delete;

  void Send(ByteView bytes) const {
    static_cast<void>(::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL));
  }
  void Greet() const {
    Send({reinterpret_cast<const std::byte*>(kGreeting.data()), kGreeting.size()});
  }
  void Hello(std::string_view name) const {
    Greet();
    Send(PacketOf({.type = wire_type::kHello,
                   .data_type = wire_data::kString,
                   .key = "asynchronous",
                   .text = name}));
  }
  /// The letter of the answer to the hello; 0 if the broker hung up.
  [[nodiscard]] char Answer() const {
    ByteBuffer bytes(4096);
    const ssize_t count = ::recv(socket_, bytes.data(), bytes.size(), 0);
    return count > 17 ? std::to_integer<char>(bytes[kPacketHeaderSize + 8]) : char{0};
  }
  /// True once the broker has hung up.
  [[nodiscard]] bool IsClosed() const {
    ByteBuffer bytes(65536);
    ssize_t count = 1;
    while (count > 0) {
      count = ::recv(socket_, bytes.data(), bytes.size(), 0);
    }
    return count == 0 || errno == ECONNRESET;
  }

 private:
  int socket_;
};

TEST_F(TcpBrokerTest, CarriesEveryTypeFromOneClientToAnother) {
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

TEST_F(TcpBrokerTest, SendsTheLatestValueToALateSubscriber) {
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

TEST_F(TcpBrokerTest, TellsOfComersAndGoersAtOnce) {
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

TEST_F(TcpBrokerTest, ListsItsClientsEveryTwoSeconds) {
  MailInbox inbox;
  const auto watcher = Join("pWatch", &inbox);
  watcher->Subscribe("DB_CLIENTS", Seconds(0.0));
  const auto clients = inbox.Await("DB_CLIENTS");
  ASSERT_TRUE(clients.has_value());
  EXPECT_EQ(std::get<std::string>(clients->value), "pWatch,");
}

TEST_F(TcpBrokerTest, CarriesMegabytes) {
  MailInbox inbox;
  const auto reader = Join("pReader", &inbox);
  reader->Subscribe("BIG", Seconds(0.0));
  const auto writer = Join("pWriter");
  writer->PublishValue("BIG", Value(Binary(5U << 20, std::byte{7})));
  const auto heard = inbox.Await("BIG");
  ASSERT_TRUE(heard.has_value());
  EXPECT_EQ(std::get<Binary>(heard->value).size(), 5U << 20);
}

TEST_F(TcpBrokerTest, WelcomesManyAtOnce) {
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

TEST_F(TcpBrokerTest, TakesAGreetingInPieces) {
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

TEST_F(TcpBrokerTest, HangsUpOnASilentConnection) {
  const RawPeer peer(broker_->port());
  EXPECT_TRUE(peer.IsClosed());
  ExpectHealthy();
}

TEST_F(TcpBrokerTest, HangsUpOnAWrongGreeting) {
  const RawPeer peer(broker_->port());
  peer.Send(ByteBuffer(32, std::byte{'x'}));
  EXPECT_TRUE(peer.IsClosed());
  ExpectHealthy();
}

TEST_F(TcpBrokerTest, HangsUpOnLengthsThatCannotBe) {
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

TEST_F(TcpBrokerTest, HangsUpOnHellosOfLengthsThatCannotBe) {
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

TEST_F(TcpBrokerTest, HangsUpOnMessagesThatDoNotFitTheirPacket) {
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

TEST_F(TcpBrokerTest, DelaysNobodyForThoseWhoStopInTheMiddle) {
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

TEST_F(TcpBrokerTest, TakesNoVariableWhoseNameIsNoneOrAMegabyte) {
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
  EXPECT_TRUE(inbox.AwaitText("type_mismatch=0,foreign_source=0,bad_name=4,no_room=0"));
}

TEST_F(TcpBrokerTest, CarriesAVariableWithACommaInItsName) {
  MailInbox inbox;
  const auto reader = Join("pReader", &inbox);
  reader->Subscribe("A,B", Seconds(0.0));
  const auto writer = Join("pWriter");
  writer->Publish("A,B", 1.0);
  EXPECT_TRUE(inbox.Await("A,B").has_value());
  ExpectHealthy();
}

TEST_F(TcpBrokerTest, HangsUpOnAMillionMessagesIn69Bytes) {
  const RawPeer peer(broker_->port());
  peer.Hello("pMillion");
  ASSERT_EQ(peer.Answer(), wire_type::kWelcome);
  ByteBuffer packet(69);
  Put(Put(packet.data(), std::int32_t{69}), std::int32_t{1'000'000});
  peer.Send(packet);
  EXPECT_TRUE(peer.IsClosed());
  ExpectHealthy();
}

TEST_F(TcpBrokerTest, HangsUpOnStringsThatDoNotFitTheirMessage) {
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

TEST_F(TcpBrokerTest, RefusesNamesThatWouldGarbleItsLists) {
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

TEST_F(TcpBrokerTest, RefusesANameInUse) {
  const RawPeer first(broker_->port());
  first.Hello("pTwin");
  ASSERT_EQ(first.Answer(), wire_type::kWelcome);
  const RawPeer second(broker_->port());
  second.Hello("pTwin");
  EXPECT_EQ(second.Answer(), wire_type::kPoison);
}

TEST_F(TcpBrokerTest, IgnoresARegistrationInAnothersName) {
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

TEST_F(TcpBrokerTest, SurvivesRandomAndMutatedPackets) {
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

TEST_F(TcpBrokerTest, KeepsServingWhileAReaderHasStopped) {
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

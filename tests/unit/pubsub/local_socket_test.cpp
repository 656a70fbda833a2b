// SPDX-License-Identifier: MIT
#include "limpet/pubsub/local_socket.hpp"

#include <array>
#include <vector>

#include <asio/io_context.hpp>
#include <asio/write.hpp>
#include <gmock/gmock.h>
#include <unistd.h>

#include "tests/support/loopback_broker.hpp"

namespace limpet {
namespace {

using asio::ip::make_address;
using Acceptor = asio::local::stream_protocol::acceptor;

class LocalSocket : public LoopbackBroker {
 protected:
  [[nodiscard]] std::optional<StreamSocket> Connect(const char* address = "127.0.0.1") {
    return ConnectLocally(context_.get_executor(), make_address(address), broker_->port());
  }
  asio::io_context context_;
};

/// Not 9000: a database of this machine may listen there on all addresses.
constexpr std::uint16_t kUnusedPort = 29753;

/// One of the sixteen million loopback addresses: this process's own, so that nobody else's broker
/// comes or goes there meanwhile.
asio::ip::address_v4 OwnLoopback() {
  return asio::ip::address_v4(0x7f80'0000U | (static_cast<std::uint32_t>(::getpid()) & 0x7f'ffffU));
}

bool HangsUp(StreamSocket& socket) {
  socket.non_blocking(false);
  return limpet::HangsUp(socket.native_handle());
}

TEST_F(LocalSocket, IsFoundWhereTheBrokerListensAndNowhereElse) {
  EXPECT_TRUE(Connect().has_value());
  EXPECT_FALSE(Connect("127.0.0.2").has_value());
  EXPECT_FALSE(Connect("192.168.1.7").has_value()) << "another machine has its own port 9000";
}

TEST_F(LocalSocket, JoinsOneCommunityWithTcp) {
  MailInbox inbox;
  const auto reader = Join("pLocal", &inbox);
  reader->Subscribe("X", Seconds(0.0));
  clients_go_locally_ = false;
  const auto writer = Join("pByTcp");
  writer->Publish("X", 4.5);
  const auto heard = inbox.Await("X");
  ASSERT_TRUE(heard.has_value());
  EXPECT_EQ(heard->source, "pByTcp");
}

TEST_F(LocalSocket, HangsUpOnSilenceAndOnAWrongGreeting) {
  auto silent = Connect();
  auto wrong = Connect();
  ASSERT_TRUE(silent && wrong);
  asio::write(*wrong, asio::buffer(std::string(32, 'x')));
  EXPECT_TRUE(HangsUp(*wrong));
  EXPECT_TRUE(HangsUp(*silent));
  ExpectHealthy();
}

TEST(LocalPlace, OfAllAddressesIsLoopbacks) {
  const auto any = LocalPlaceOf(make_address("0.0.0.0"), 9000);
  ASSERT_TRUE(any.has_value());
  EXPECT_EQ(*any, *LocalPlaceOf(make_address("127.0.0.1"), 9000));
  EXPECT_NE(*any, *LocalPlaceOf(make_address("127.0.0.1"), 9001));
  EXPECT_FALSE(LocalPlaceOf(make_address("10.0.0.1"), 9000).has_value());
}

TEST(LocalPlace, TakenByAnotherIsAnError) {
  TcpBrokerOptions options;
  options.bind_address = OwnLoopback().to_string();
  options.port = kUnusedPort;
  asio::io_context context;
  const Acceptor stranger(context, *LocalPlaceOf(OwnLoopback(), options.port));
  try {
    const TcpBroker broker(options);
    FAIL() << "clients would go to the stranger";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("@limpet/" + options.bind_address + ":29753"));
  }
}

TEST(LocalPlace, OfABrokerThatTakesNobodyInIsNotWaitedFor) {
  asio::io_context context;
  Acceptor deaf(context);
  const auto place = *LocalPlaceOf(OwnLoopback(), kUnusedPort);
  deaf.open();
  deaf.bind(place);
  deaf.listen(1);
  std::vector<StreamSocket> waiting;
  for (int i = 0; i < 10; ++i) {
    auto socket = ConnectLocally(context.get_executor(), OwnLoopback(), kUnusedPort);
    if (!socket) {
      return;
    }
    waiting.push_back(std::move(*socket));
  }
  FAIL() << "ten in a queue for one";
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/sharing/udp_sockets.hpp"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

#include <gtest/gtest.h>

namespace limpet {
namespace {

using namespace std::chrono_literals;

constexpr const char* kLoopback = "127.0.0.1";

ByteBuffer PayloadOf(std::string_view text) {
  const auto* begin = reinterpret_cast<const std::byte*>(text.data());
  return {begin, begin + text.size()};
}

class UdpSocketsTest : public ::testing::Test {
 protected:
  /// The next datagrams, once there are any.
  std::vector<UdpSockets::Datagram> Await() {
    std::unique_lock lock(mutex_);
    arrival_.wait_for(lock, 5s, [this] { return has_arrived_; });
    has_arrived_ = false;
    return sockets_.Take();
  }
  /// The address that a socket of ours now listens at.
  ShareAddress Listen() {
    const auto input = sockets_.Listen({.host = "localhost", .port = 0}, kLoopback);
    EXPECT_TRUE(input.has_value());
    const ShareAddress address{.host = "localhost", .port = sockets_.PortOf(*input)};
    sockets_.Resolve(address);
    return address;
  }

  std::mutex mutex_;
  std::condition_variable arrival_;
  bool has_arrived_ = false;
  UdpSockets sockets_{[this] {
    const std::lock_guard lock(mutex_);
    has_arrived_ = true;
    arrival_.notify_one();
  }};
};

TEST_F(UdpSocketsTest, CarryADatagram) {
  EXPECT_FALSE(sockets_.Send(Listen(), PayloadOf("hello")));
  const auto datagrams = Await();
  ASSERT_EQ(datagrams.size(), 1U);
  EXPECT_EQ(datagrams[0].bytes, PayloadOf("hello"));
  EXPECT_TRUE(datagrams[0].sender.Text().starts_with("127.0.0.1:"));
}

TEST_F(UdpSocketsTest, CarryTheLargestShare) {
  const ByteBuffer large(48 * 1024 + 44, std::byte{7});
  EXPECT_FALSE(sockets_.Send(Listen(), large));
  const auto datagrams = Await();
  ASSERT_EQ(datagrams.size(), 1U);
  EXPECT_EQ(datagrams[0].bytes, large);
}

TEST_F(UdpSocketsTest, RefuseAPortInUse) {
  const ShareAddress address = Listen();
  EXPECT_FALSE(sockets_.Listen(address, kLoopback).has_value());
}

TEST_F(UdpSocketsTest, RefuseAnInterfaceThatIsNone) {
  EXPECT_FALSE(sockets_.Listen({.host = "x", .port = 0}, "not an address").has_value());
}

TEST_F(UdpSocketsTest, SayThatAHostIsUnknown) {
  const ShareAddress nowhere{.host = "no.such.host.invalid", .port = 9};
  sockets_.Resolve(nowhere);
  EXPECT_TRUE(sockets_.Send(nowhere, PayloadOf("x")).has_value());
}

TEST_F(UdpSocketsTest, KeepNoMoreThanTheirBoundAndCountTheRest) {
  const ShareAddress address = Listen();
  const ByteBuffer large(40'000, std::byte{1});
  const auto deadline = std::chrono::steady_clock::now() + 5s;
  while (sockets_.overflow() == 0 && std::chrono::steady_clock::now() < deadline) {
    static_cast<void>(sockets_.Send(address, large));
  }
  EXPECT_GT(sockets_.overflow(), 0U);
  EXPECT_LE(sockets_.Take().size() * large.size(), UdpSockets::kQueuePerInput);
}

TEST_F(UdpSocketsTest, ReachAMulticastChannel) {
  ShareAddress channel{.host = "224.1.1.11", .port = 0, .channel = 8};
  const auto input = sockets_.Listen(channel, "0.0.0.0");
  if (!input) {
    GTEST_SKIP() << "no multicast here: " << input.error().text;
  }
  channel.port = sockets_.PortOf(*input);
  sockets_.Resolve(channel);
  if (const auto error = sockets_.Send(channel, PayloadOf("to all"))) {
    GTEST_SKIP() << "no multicast route here: " << error->text;
  }
  const auto datagrams = Await();
  ASSERT_EQ(datagrams.size(), 1U);
  EXPECT_EQ(datagrams[0].bytes, PayloadOf("to all"));
}

}  // namespace
}  // namespace limpet

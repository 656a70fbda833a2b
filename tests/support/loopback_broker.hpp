// SPDX-License-Identifier: MIT
// A broker on real sockets for a test: clients of ours, and peers that write whatever they like.
#pragma once

#include <cerrno>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <thread>

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include "limpet/pubsub/tcp_broker.hpp"
#include "limpet/pubsub/tcp_client.hpp"
#include "tests/support/mail_inbox.hpp"

namespace limpet {

class LoopbackBroker : public testing::Test {
 protected:
  explicit LoopbackBroker(bool may_send_together = true) {
    TcpBrokerOptions options;
    options.may_send_together = may_send_together;
    options.broker.community = "alpha";
    options.port = 0;
    options.handshake_timeout = Seconds(0.4);
    broker_ = std::make_unique<TcpBroker>(options);
    thread_ = std::thread([this] { broker_->Run(); });
  }
  ~LoopbackBroker() override {
    broker_->Stop();
    thread_.join();
  }
  LoopbackBroker(const LoopbackBroker&) = delete;
  LoopbackBroker& operator=(const LoopbackBroker&) = delete;

  std::unique_ptr<TcpClient> Join(const std::string& name, MailInbox* inbox = nullptr) {
    return Join(name, [inbox](const WireMessage& message) {
      if (inbox != nullptr) {
        inbox->Add(message);
      }
    });
  }
  std::unique_ptr<TcpClient> Join(const std::string& name,
                                  std::function<void(const WireMessage&)> on_mail) {
    return std::make_unique<TcpClient>(TcpClientOptions{.port = broker_->port(),
                                                        .name = name,
                                                        .may_go_locally = clients_go_locally_,
                                                        .on_mail = std::move(on_mail),
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

  bool clients_go_locally_ = true;
  std::unique_ptr<TcpBroker> broker_;
  std::thread thread_;
};

/// recv, also when a signal comes in between: closing a broker's io_uring is one to its thread.
inline ssize_t Hear(int socket, std::span<std::byte> bytes) {
  ssize_t count = -1;
  do {
    count = ::recv(socket, bytes.data(), bytes.size(), 0);
  } while (count < 0 && errno == EINTR);
  return count;
}

/// The other side of a blocking socket has hung up, within five seconds.
inline bool HangsUp(int socket) {
  const timeval longest{.tv_sec = 5, .tv_usec = 0};
  ::setsockopt(socket, SOL_SOCKET, SO_RCVTIMEO, &longest, sizeof longest);
  ByteBuffer bytes(65536);
  ssize_t count = 1;
  while (count > 0) {
    count = Hear(socket, bytes);
  }
  return count == 0 || errno == ECONNRESET;
}

/// A peer that writes whatever bytes it likes.
class RawPeer {
 public:
  /// `room`: what the system takes in for it [bytes]; 0: as usual.
  explicit RawPeer(std::uint16_t port, int room = 0) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    if (room > 0) {
      ::setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, &room, sizeof room);
    }
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
  /// From any thread: ends what another one sends or awaits.
  void HangUp() const { ::shutdown(socket_, SHUT_RDWR); }
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
    const ssize_t count = Hear(socket_, bytes);
    return count > 17 ? std::to_integer<char>(bytes[kPacketHeaderSize + 8]) : char{0};
  }
  /// True once the broker has hung up.
  [[nodiscard]] bool IsClosed() const { return HangsUp(socket_); }

 private:
  int socket_;
};

}  // namespace limpet

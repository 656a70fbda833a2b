// SPDX-License-Identifier: MIT
#include "tests/bench/loopback_limits.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <list>
#include <stdexcept>
#include <thread>
#include <vector>

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include "limpet/core/clock.hpp"

namespace limpet {
namespace {

constexpr std::size_t kMessage = 80;  ///< about what a double takes on the wire [bytes]

/// Two connected sockets of this machine.
class SocketPair {
 public:
  explicit SocketPair(SocketKind kind) {
    if (kind == SocketKind::kLocal) {
      std::array<int, 2> ends{};
      if (::socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()) != 0) {
        throw std::runtime_error("no local sockets");
      }
      writer = ends[0];
      reader = ends[1];
      return;
    }
    const int listener = ::socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in place{};
    place.sin_family = AF_INET;
    place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    auto* address = reinterpret_cast<sockaddr*>(&place);
    socklen_t size = sizeof place;
    writer = ::socket(AF_INET, SOCK_STREAM, 0);
    if (::bind(listener, address, size) != 0 || ::listen(listener, 1) != 0 ||
        ::getsockname(listener, address, &size) != 0 || ::connect(writer, address, size) != 0) {
      throw std::runtime_error("no loopback sockets");
    }
    reader = ::accept(listener, nullptr, nullptr);
    ::close(listener);
    const int on = 1;
    ::setsockopt(writer, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    ::setsockopt(reader, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  }
  ~SocketPair() {
    ::close(writer);
    ::close(reader);
  }
  SocketPair(const SocketPair&) = delete;
  SocketPair& operator=(const SocketPair&) = delete;

  int writer = -1, reader = -1;
};

void ReadDelays(int socket, std::vector<double>& delays) {
  std::array<std::byte, kMessage> message{};
  while (::recv(socket, message.data(), message.size(), MSG_WAITALL) ==
         static_cast<ssize_t>(message.size())) {
    double sent = 0.0;
    std::memcpy(&sent, message.data(), sizeof sent);
    delays.push_back(1e6 * (SteadyTime().value() - sent));
  }
}

}  // namespace

HopDelay LoopbackHop(SocketKind kind, int readers, int count, double hz) {
  std::list<SocketPair> pairs;
  for (int i = 0; i < readers; ++i) {
    pairs.emplace_back(kind);
  }
  std::vector<std::vector<double>> delays(pairs.size());
  std::vector<std::thread> threads;
  auto mine = delays.begin();
  for (const SocketPair& pair : pairs) {
    mine->reserve(static_cast<std::size_t>(count));
    threads.emplace_back([&pair, &own = *mine++] { ReadDelays(pair.reader, own); });
  }
  std::array<std::byte, kMessage> message{};
  for (int n = 0; n < count; ++n) {
    const double now = SteadyTime().value();
    std::memcpy(message.data(), &now, sizeof now);
    for (const SocketPair& pair : pairs) {
      static_cast<void>(::send(pair.writer, message.data(), message.size(), MSG_NOSIGNAL));
    }
    std::this_thread::sleep_for(std::chrono::duration<double>(1.0 / hz));
  }
  for (const SocketPair& pair : pairs) {
    ::shutdown(pair.writer, SHUT_WR);
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  std::vector<double> last(static_cast<std::size_t>(count), 0.0);
  for (const auto& one : delays) {
    for (std::size_t n = 0; n < one.size(); ++n) {
      last[n] = std::max(last[n], one[n]);
    }
  }
  std::ranges::sort(last);
  return {.p50 = last[last.size() / 2], .p99 = last[last.size() * 99 / 100]};
}

double LoopbackRoundTrip(SocketKind kind, int count) {
  const SocketPair pair(kind);
  std::thread echo([&pair] {
    std::array<std::byte, kMessage> message{};
    while (::recv(pair.reader, message.data(), message.size(), MSG_WAITALL) > 0) {
      static_cast<void>(::send(pair.reader, message.data(), message.size(), MSG_NOSIGNAL));
    }
  });
  std::array<std::byte, kMessage> message{};
  std::vector<double> times(static_cast<std::size_t>(count));
  for (double& time : times) {
    const double begin = SteadyTime().value();
    static_cast<void>(::send(pair.writer, message.data(), message.size(), MSG_NOSIGNAL));
    static_cast<void>(::recv(pair.writer, message.data(), message.size(), MSG_WAITALL));
    time = 1e6 * (SteadyTime().value() - begin);
  }
  ::shutdown(pair.writer, SHUT_WR);
  echo.join();
  std::ranges::nth_element(times, times.begin() + count / 2);
  return times[times.size() / 2];
}

double LoopbackThroughput(SocketKind kind, std::size_t block, double seconds) {
  const SocketPair pair(kind);
  std::vector<std::byte> out(block), in(block);
  std::thread reader([&pair, &in] {
    while (::recv(pair.reader, in.data(), in.size(), MSG_WAITALL) > 0) {
    }
  });
  const double begin = SteadyTime().value();
  std::size_t sent = 0;
  while (SteadyTime().value() - begin < seconds) {
    sent += static_cast<std::size_t>(
        std::max<ssize_t>(0, ::send(pair.writer, out.data(), out.size(), MSG_NOSIGNAL)));
  }
  ::shutdown(pair.writer, SHUT_WR);
  reader.join();
  return static_cast<double>(sent) / (SteadyTime().value() - begin);
}

}  // namespace limpet

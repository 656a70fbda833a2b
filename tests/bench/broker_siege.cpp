// SPDX-License-Identifier: MIT
// What a crowd of silent and half-sending connections costs a bystander, and the broker in memory.
// The broker runs as its own process; all is on loopback. Fails (exit code 1) if the bystander's
// median delay is three times its undisturbed one, or the broker holds 128 MB.
#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <arpa/inet.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "limpet/core/clock.hpp"
#include "limpet/pubsub/tcp_client.hpp"
#include "limpet/wire/little_endian.hpp"
#include "limpet/wire/packet_codec.hpp"
#include "tests/bench/broker_process.hpp"
#include "tests/bench/process_cost.hpp"

namespace {

using namespace std::chrono_literals;
using limpet::ByteBuffer;
using limpet::ByteView;
using limpet::SteadyTime;
using limpet::TcpClient;
using limpet::WireMessage;

constexpr std::uint16_t kPort = 19763;

/// A connection that never blocks; what it has to say goes out as the broker takes it.
class Besieger {
 public:
  /// Nothing to say: silent. Else a name, a packet's header, and `bytes` of it.
  Besieger(const std::string& name, std::size_t announced, std::size_t bytes)
      : name_(name), announced_(announced), left_(bytes) {
    Connect();
  }
  ~Besieger() { ::close(socket_); }
  Besieger(const Besieger&) = delete;
  Besieger& operator=(const Besieger&) = delete;

  /// Says some more; comes again if it was sent away and `comes_again`.
  void Go(bool comes_again) {
    std::array<char, 4096> ignored{};
    const ssize_t heard = ::recv(socket_, ignored.data(), ignored.size(), MSG_DONTWAIT);
    if (heard == 0 || (heard < 0 && errno != EAGAIN)) {
      ++losses;
      if (comes_again) {
        ::close(socket_);
        Connect();
      }
      return;
    }
    static const ByteBuffer block(std::size_t{256} << 10);
    const ByteView next =
        head_.empty() ? ByteView(block).first(std::min(block.size(), left_)) : ByteView(head_);
    const ssize_t sent = ::send(socket_, next.data(), next.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
    if (sent <= 0) {
      return;
    }
    if (head_.empty()) {
      left_ -= static_cast<std::size_t>(sent);
      total += static_cast<std::size_t>(sent);
    } else {
      head_.erase(head_.begin(), head_.begin() + sent);
    }
  }
  std::size_t total = 0;
  int losses = 0;

 private:
  void Connect() {
    socket_ = ::socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in place{};
    place.sin_family = AF_INET;
    place.sin_port = htons(kPort);
    place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    static_cast<void>(::connect(socket_, reinterpret_cast<sockaddr*>(&place), sizeof place));
    head_.clear();
    if (announced_ == 0) {
      return;
    }
    const auto* greeting = reinterpret_cast<const std::byte*>(limpet::kGreeting.data());
    head_.assign(greeting, greeting + limpet::kGreeting.size());
    const ByteBuffer hello = limpet::PacketOf({.type = limpet::wire_type::kHello,
                                               .data_type = limpet::wire_data::kString,
                                               .key = "asynchronous",
                                               .text = name_});
    head_.insert(head_.end(), hello.begin(), hello.end());
    ByteBuffer header(limpet::kPacketHeaderSize);
    limpet::EncodePacketHeader({announced_, 1}, header.data());
    head_.insert(head_.end(), header.begin(), header.end());
  }

  std::string name_;
  std::size_t announced_, left_;
  ByteBuffer head_;
  int socket_ = -1;
};

struct Delays {
  double p50 = 0.0, p99 = 0.0;  ///< [us]
  std::size_t count = 0;
};

/// Doubles at 200 Hz from one client to another for `seconds`, while `meanwhile` is called.
template <class Meanwhile>
Delays Bystander(double seconds, Meanwhile meanwhile) {
  std::vector<double> delays;
  delays.reserve(100'000);
  TcpClient reader({.port = kPort,
                    .name = "pReader",
                    .on_mail =
                        [&delays](const WireMessage& m) {
                          if (m.id != -1) {
                            delays.push_back(1e6 * (SteadyTime().value() - m.number));
                          }
                        },
                    .on_state = nullptr});
  reader.Subscribe("BYSTANDER", limpet::Seconds(0.0));
  TcpClient writer({.port = kPort, .name = "pWriter", .on_mail = nullptr, .on_state = nullptr});
  std::atomic<bool> is_over{false};
  std::thread siege([&] {
    while (!is_over) {
      meanwhile();
      std::this_thread::sleep_for(5ms);
    }
  });
  std::this_thread::sleep_for(300ms);
  for (double begin = SteadyTime().value(); SteadyTime().value() - begin < seconds;) {
    writer.Publish("BYSTANDER", SteadyTime().value());
    std::this_thread::sleep_for(5ms);
  }
  std::this_thread::sleep_for(300ms);
  is_over = true;
  siege.join();
  std::vector<double> sorted = delays;
  std::ranges::sort(sorted);
  const auto at = [&sorted](double q) {
    return sorted.empty()
               ? INFINITY
               : sorted[static_cast<std::size_t>(q * static_cast<double>(sorted.size() - 1))];
  };
  return {at(0.5), at(0.99), sorted.size()};
}

void Print(const char* what, const Delays& delays, pid_t broker) {
  fmt::print("{:<34} p50 {:6.0f}  p99 {:7.0f} us ({})   {:6.1f} MB, at most {:6.1f}\n", what,
             delays.p50, delays.p99, delays.count, limpet::Megabytes(broker, "VmRSS"),
             limpet::Megabytes(broker, "VmHWM"));
}

}  // namespace

/// broker_siege [PATH/LimpetDB] [SILENT HALF MIB [again]]: `SILENT` connections that say nothing
/// and `HALF` clients that send half of a packet of `MIB`; `again`: who is sent away comes back.
int main(int argc, char** argv) {
  std::vector<std::string> words(argv + 1, argv + argc);
  std::string program = std::filesystem::path(argv[0]).replace_filename("LimpetDB");
  if (!words.empty() && words.front().find('/') != std::string::npos) {
    program = words.front();
    words.erase(words.begin());
  }
  const auto number = [&words](std::size_t i, int otherwise) {
    return i < words.size() ? std::stoi(words[i]) : otherwise;
  };
  const int silent = number(0, 400), half = number(1, 100);
  const std::size_t size = static_cast<std::size_t>(number(2, 64)) << 20;
  const bool comes_again = words.size() > 3 && words[3] == "again";
  const pid_t broker = limpet::StartBroker(kPort, program);
  const Delays before = Bystander(4.0, [] {});
  Print("undisturbed", before, broker);
  std::vector<std::unique_ptr<Besieger>> crowd;
  for (int i = 0; i < silent; ++i) {
    crowd.push_back(std::make_unique<Besieger>("", 0, 0));
  }
  for (int i = 0; i < half; ++i) {
    crowd.push_back(std::make_unique<Besieger>(fmt::format("pHalf{}", i), size, size / 2));
  }
  double most = 0.0;
  const Delays during = Bystander(8.0, [&] {
    for (const auto& one : crowd) {
      one->Go(comes_again);
    }
    most = std::max(most, limpet::Megabytes(broker, "VmRSS"));
  });
  Print(fmt::format("{} silent, {} half-sending", silent, half).c_str(), during, broker);
  std::size_t total = 0;
  int losses = 0;
  for (const auto& one : crowd) {
    total += one->total;
    losses += one->losses > 0 ? 1 : 0;
  }
  crowd.clear();
  const Delays after = Bystander(2.0, [] {});
  Print("afterwards", after, broker);
  const double ratio = during.p50 / before.p50;
  fmt::print("p50 {:.2f} times the undisturbed one; {:.0f} MB sent, {} sent away\n", ratio,
             1e-6 * static_cast<double>(total), losses);
  most = std::max(most, limpet::Megabytes(broker, "VmHWM"));
  kill(broker, SIGTERM);
  waitpid(broker, nullptr, 0);
  return ratio < 3.0 && most < 128.0 ? 0 : 1;
}

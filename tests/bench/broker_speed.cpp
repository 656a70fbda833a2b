// SPDX-License-Identifier: MIT
// Speed of the broker, publisher -> LimpetDB -> subscriber on one machine, with our own client
// library: latency, rate, throughput, fan-out, connections. The broker runs as its own process.
// Prints one table with the machine's load, and what its bare loopback sockets do in the same run;
// nothing here passes or fails.
#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include "limpet/core/clock.hpp"
#include "limpet/core/statistics.hpp"
#include "limpet/pubsub/tcp_client.hpp"
#include "tests/bench/broker_process.hpp"
#include "tests/bench/loopback_limits.hpp"
#include "tests/bench/process_cost.hpp"

namespace {

using namespace std::chrono_literals;
using limpet::SteadyTime;
using limpet::TcpClient;
using limpet::WireMessage;

constexpr std::uint16_t kPort = 19753;
constexpr std::int32_t kLatched = -1;  ///< id of the value that a new subscriber finds

bool may_go_locally = true;  ///< set once, at the start

limpet::SocketKind Kind() {
  return may_go_locally ? limpet::SocketKind::kLocal : limpet::SocketKind::kTcp;
}

std::unique_ptr<TcpClient> Join(const std::string& name,
                                std::function<void(const WireMessage&)> on_mail = nullptr) {
  auto client =
      std::make_unique<TcpClient>(limpet::TcpClientOptions{.port = kPort,
                                                           .name = name,
                                                           .may_go_locally = may_go_locally,
                                                           .queue = std::size_t{256} << 20,
                                                           .on_mail = std::move(on_mail),
                                                           .on_state = nullptr});
  while (client->state() != TcpClient::State::kConnected) {
    std::this_thread::sleep_for(100us);
  }
  return client;
}

void Row(const std::string& what, const std::string& figure) {
  fmt::print("| {:<44} | {:<32} |\n", what, figure);
}

/// One publisher at `hz`; the value is the time of sending. `readers` subscribers; the last one's
/// latency counts; its median is given back [us].
double Latency(const std::string& what, double hz, int count, int readers, std::size_t bytes) {
  const std::string variable =
      bytes > 0 ? "LAT_BINARY" : "LAT_DOUBLE";  // the first write fixes the type
  std::vector<std::vector<double>> delays(static_cast<std::size_t>(readers));
  std::atomic<int> received{0};
  std::vector<std::unique_ptr<TcpClient>> clients;
  for (int i = 0; i < readers; ++i) {
    auto& mine = delays[static_cast<std::size_t>(i)];
    mine.reserve(static_cast<std::size_t>(count));
    clients.push_back(
        Join(fmt::format("pReader{}", i), [&mine, &received, bytes](const WireMessage& m) {
          if (m.id == kLatched) return;
          double sent = m.number;
          if (bytes > 0) {
            std::memcpy(&sent, m.text.data(), sizeof sent);
          }
          mine.push_back(1e6 * (SteadyTime().value() - sent));
          ++received;
        }));
    clients.back()->Subscribe(variable, limpet::Seconds(0.0));
  }
  const auto writer = Join("pWriter");
  std::this_thread::sleep_for(200ms);
  limpet::Value block = limpet::Binary(std::max<std::size_t>(bytes, 8));
  for (int i = 0; i < count; ++i) {
    const double now = SteadyTime().value();
    if (bytes > 0) {
      std::memcpy(std::get<limpet::Binary>(block).data(), &now, sizeof now);
      writer->PublishValue(variable, block);
    } else {
      writer->Publish(variable, now);
    }
    std::this_thread::sleep_for(std::chrono::duration<double>(1.0 / hz));
  }
  std::this_thread::sleep_for(200ms);
  std::vector<double> last;
  const std::size_t common = std::ranges::min(delays, {}, &std::vector<double>::size).size();
  for (std::size_t i = 0; i < common; ++i) {
    double worst = 0.0;
    for (const auto& one : delays) {
      worst = std::max(worst, one[i]);
    }
    last.push_back(worst);
  }
  const double median = limpet::Quantile(last, 0.5);
  Row(what, fmt::format("p50 {:.0f}  p99 {:.0f} us  ({} of {})", median,
                        limpet::Quantile(last, 0.99), common, count));
  return median;
}

/// As fast as it goes, with at most about half of what the broker keeps for a reader under way:
/// the figure is of mail that arrives.
void FlatOut(const std::string& what, std::size_t bytes, bool is_double, int readers,
             double seconds) {
  const std::string variable = is_double        ? "FLAT_DOUBLE"
                               : bytes > 10'000 ? "FLAT_BINARY"
                                                : "FLAT_STRING";
  std::vector<std::unique_ptr<TcpClient>> clients;
  std::vector<std::atomic<std::uint64_t>> received(static_cast<std::size_t>(readers));
  for (int i = 0; i < readers; ++i) {
    auto& mine = received[static_cast<std::size_t>(i)];
    clients.push_back(Join(fmt::format("pReader{}", i), [&mine](const WireMessage& m) {
      mine.fetch_add(m.id == kLatched ? 0 : 1, std::memory_order_relaxed);
    }));
    clients.back()->Subscribe(variable, limpet::Seconds(0.0));
  }
  const auto writer = Join("pWriter");
  std::this_thread::sleep_for(200ms);
  const std::string text(bytes, 'x');
  limpet::Value block = limpet::Binary(bytes);
  constexpr std::size_t kOnTheWire = 80;  // bytes of a message beside its text
  // Half of what the broker keeps for a reader: what is lost would be no throughput.
  const std::uint64_t window =
      std::max<std::uint64_t>(2, (std::size_t{3} << 19) / (bytes + kOnTheWire));
  const auto slowest = [&received] {
    std::uint64_t least = UINT64_MAX;
    for (const auto& one : received) {
      least = std::min(least, one.load(std::memory_order_relaxed));
    }
    return least;
  };
  const double begin = SteadyTime().value();
  std::uint64_t sent = 0;
  while (SteadyTime().value() - begin < seconds) {
    for (int i = 0; i < (bytes > 10'000 ? 1 : 100); ++i, ++sent) {
      if (is_double) {
        writer->Publish(variable, static_cast<double>(sent));
      } else if (bytes > 10'000) {
        writer->PublishValue(variable, block);
      } else {
        writer->Publish(variable, std::string_view(text));
      }
    }
    while (sent - slowest() >= window && SteadyTime().value() - begin < seconds + 1.0) {
      std::this_thread::sleep_for(20us);
    }
  }
  const double until = SteadyTime().value() + 2.0;
  while (slowest() < sent && SteadyTime().value() < until) {
    std::this_thread::sleep_for(1ms);
  }
  const double span = SteadyTime().value() - begin;
  std::uint64_t all = 0;
  for (const auto& one : received) {
    all += one.load();
  }
  const double rate = static_cast<double>(all) / span;
  const std::string lost = slowest() < sent ? fmt::format("  LOST {}", sent - slowest()) : "";
  Row(what, bytes > 10'000
                ? fmt::format("{:.0f} MB/s{}", 1e-6 * rate * static_cast<double>(bytes), lost)
                : fmt::format("{:.2f} M/s{}", 1e-6 * rate, lost));
}

void Connections() {
  const double one_begin = SteadyTime().value();
  Join("pOne");
  const double one = SteadyTime().value() - one_begin;
  std::vector<std::unique_ptr<TcpClient>> clients;
  const double begin = SteadyTime().value();
  for (int i = 0; i < 50; ++i) {
    clients.push_back(
        std::make_unique<TcpClient>(limpet::TcpClientOptions{.port = kPort,
                                                             .name = fmt::format("pMany{}", i),
                                                             .may_go_locally = may_go_locally,
                                                             .on_mail = nullptr,
                                                             .on_state = nullptr}));
  }
  for (const auto& client : clients) {
    while (client->state() != TcpClient::State::kConnected) {
      std::this_thread::sleep_for(100us);
    }
  }
  Row("connect, one; 50 at once",
      fmt::format("{:.1f} ms; {:.0f} ms", 1e3 * one, 1e3 * (SteadyTime().value() - begin)));
}

/// 64 MB in messages of `bytes` each to one reader, which is waited for if it counts what it takes;
/// what the broker then holds [MB].
double HeldAfterBurst(pid_t broker, std::size_t bytes,
                      std::function<void(const WireMessage&)> on_mail,
                      const std::atomic<std::size_t>* taken, std::function<void()> before_leaving) {
  constexpr std::size_t kWindow = std::size_t{256} << 10;
  const std::string variable = bytes > 10'000 ? "STOPPED_BINARY" : "STOPPED_STRING";
  auto reader = Join("pStopped", std::move(on_mail));
  reader->Subscribe(variable, limpet::Seconds(0.0));
  const auto writer = Join("pWriter");
  std::this_thread::sleep_for(200ms);
  const limpet::Value block = limpet::Binary(bytes);
  const std::string text(bytes, 'x');
  for (std::size_t sent = 0; sent < std::size_t{64} << 20; sent += bytes) {
    if (bytes > 10'000) {
      writer->PublishValue(variable, block);
    } else {
      writer->Publish(variable, std::string_view(text));
    }
    while (writer->unsent() > kWindow || (taken != nullptr && sent > taken->load() + kWindow)) {
      std::this_thread::sleep_for(50us);
    }
  }
  std::this_thread::sleep_for(200ms);
  const double held = limpet::Megabytes(broker);
  before_leaving();
  return held;
}

/// What a reader costs that takes nothing, beside one that takes all, and what is left of that when
/// it has gone.
void StoppedReader(pid_t broker, const std::string& what, std::size_t bytes) {
  std::atomic<std::size_t> taken{0};
  const double reading = HeldAfterBurst(
      broker, bytes, [&](const WireMessage& m) { taken += m.id == kLatched ? 0 : bytes; }, &taken,
      [] {});
  std::atomic<bool> may_read{false};
  const double stopped = HeldAfterBurst(
      broker, bytes, [&may_read](const WireMessage&) { may_read.wait(false); }, nullptr,
      [&may_read] {
        may_read = true;
        may_read.notify_all();
      });
  std::this_thread::sleep_for(3s);
  Row(what, fmt::format("{:+.1f} MB; {:+.1f} MB", stopped - reading,
                        limpet::Megabytes(broker) - reading));
}

void Idle(pid_t broker) {
  std::vector<std::unique_ptr<TcpClient>> clients;
  for (int i = 0; i < 50; ++i) {
    clients.push_back(Join(fmt::format("pIdle{}", i)));
  }
  const double begin = SteadyTime().value();
  const double used = limpet::ProcessorSeconds(broker);
  std::this_thread::sleep_for(5s);
  Row("50 idle clients, of one core",
      fmt::format(
          "{:.2f} %, {:.1f} MB",
          100.0 * (limpet::ProcessorSeconds(broker) - used) / (SteadyTime().value() - begin),
          limpet::Megabytes(broker)));
}

/// To ten readers at 1 kHz: the broker takes two hops, bare sockets one, just before and just
/// after.
void FanOut() {
  const auto bare = [] { return limpet::LoopbackHop(Kind(), 10, 1500, 1000.0).p50; };
  const double before = bare();
  const double ours = Latency("fan-out 1->10 at 1 kHz, last subscriber", 1000.0, 3000, 10, 0);
  const double after = bare();
  Row("  of that, bare sockets: one hop 1->10, last",
      fmt::format("p50 {:.0f}, {:.0f} us: {:.2f} of it", before, after,
                  0.5 * (before + after) / ours));
}

/// Of bare sockets, of the kind that the clients take: one hop; the broker takes two.
void Limits() {
  Row("bare sockets: round trip, TCP; local",
      fmt::format("{:.0f} us; {:.0f} us",
                  limpet::LoopbackRoundTrip(limpet::SocketKind::kTcp, 10'000),
                  limpet::LoopbackRoundTrip(limpet::SocketKind::kLocal, 10'000)));
  const limpet::HopDelay delay = limpet::LoopbackHop(Kind(), 1, 2000, 1000.0);
  Row("bare sockets: one hop 1->1 at 1 kHz",
      fmt::format("p50 {:.0f}  p99 {:.0f} us", delay.p50, delay.p99));
  for (const std::size_t block : {std::size_t{65536}, std::size_t{1} << 20}) {
    Row(fmt::format("bare sockets: one hop, blocks of {} KiB", block >> 10),
        fmt::format("{:.0f} MB/s", 1e-6 * limpet::LoopbackThroughput(Kind(), block, 1.0)));
  }
}

/// Keeps the cores from sleeping while it lives (the kernel's PM QoS): delays are then of programs
/// and system calls, without the time that a sleeping core takes to wake.
class AwakeCores {
 public:
  AwakeCores() : request_(::open("/dev/cpu_dma_latency", O_WRONLY | O_CLOEXEC)) {
    const std::int32_t longest = 0;  // [us]
    if (::write(request_, &longest, sizeof longest) != sizeof longest) {
      fmt::print(stderr, "/dev/cpu_dma_latency: {}\n", std::strerror(errno));
      std::exit(1);
    }
  }
  ~AwakeCores() { ::close(request_); }
  AwakeCores(const AwakeCores&) = delete;
  AwakeCores& operator=(const AwakeCores&) = delete;

 private:
  int request_;  ///< stands until it is closed
};

}  // namespace

/// broker_speed [PATH/LimpetDB] [tcp] [awake] [WORDS]: all figures, or those whose group is among
/// the words (latency flat fan flatfan clients bare). The LimpetDB beside this program if none is
/// given. `tcp`: clients do not take the local socket, as if they were on another machine. `awake`
/// (root): no core sleeps; not for the flat-out figures, where a waiting core costs its neighbour.
int main(int argc, char** argv) {
  std::vector<std::string_view> words(argv + 1, argv + argc);
  std::string program = std::filesystem::path(argv[0]).replace_filename("LimpetDB");
  if (!words.empty() && words.front().find('/') != std::string_view::npos) {
    program = words.front();
    words.erase(words.begin());
  }
  may_go_locally = std::erase(words, "tcp") == 0;
  std::optional<AwakeCores> awake;
  if (std::erase(words, "awake") > 0) {
    awake.emplace();
  }
  const auto is_wanted = [&](std::string_view group) {
    return words.empty() || std::ranges::find(words, group) != words.end();
  };
  const pid_t broker = limpet::StartBroker(kPort, program);
  std::array<double, 3> load{};
  static_cast<void>(getloadavg(load.data(), 3));
  fmt::print("load {:.2f} {:.2f}, {} cores{}, clients by {}\n\n", load[0], load[1],
             std::thread::hardware_concurrency(), awake ? " kept awake" : "",
             may_go_locally ? "local socket" : "TCP");
  Row("figure", "LimpetDB");
  Row("--------------------------------------------", "--------------------------------");
  Row("memory at start", fmt::format("{:.1f} MB", limpet::Megabytes(broker)));
  if (is_wanted("latency")) {
    Latency("1 kHz doubles 1->1", 1000.0, 4000, 1, 0);
    Latency("10 Hz doubles", 10.0, 30, 1, 0);
    Latency("1 MiB at 10 Hz", 10.0, 30, 1, 1 << 20);
  }
  if (is_wanted("flat")) {
    FlatOut("flat out, doubles", 0, true, 1, 2.0);
    FlatOut("flat out, 100 B strings", 100, false, 1, 2.0);
    FlatOut("64 KiB binaries flat out", 65536, false, 1, 2.0);
    FlatOut("1 MiB binaries flat out", 1 << 20, false, 1, 2.0);
  }
  if (is_wanted("fan")) {
    FanOut();
  }
  if (is_wanted("flatfan")) {
    FlatOut("fan-out 1->10 flat out, deliveries", 0, true, 10, 2.0);
  }
  if (is_wanted("clients")) {
    Connections();
    Idle(broker);
    StoppedReader(broker, "a reader of 64 KiB that stops; once gone", std::size_t{64} << 10);
    StoppedReader(broker, "a reader of 100 B that stops; once gone", 100);
  }
  if (is_wanted("bare")) {
    Limits();
  }
  std::this_thread::sleep_for(1s);
  Row("memory at most; at the end",
      fmt::format("{:.1f} MB; {:.1f} MB", limpet::Megabytes(broker, "VmHWM"),
                  limpet::Megabytes(broker)));
  kill(broker, SIGTERM);
  waitpid(broker, nullptr, 0);
  return 0;
}

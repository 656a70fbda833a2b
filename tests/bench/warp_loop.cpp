// SPDX-License-Identifier: MIT
// Four processes in a ring over LimpetDB at a high time warp: a beat that each hands on at once, as
// a sensor, an estimator, a helm and a pilot do. Does the ring keep the time it was given? usage:
// warp_loop [build/bin/LimpetDB] [warp=100] [AppTick=10] [seconds=10, real]
#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include "limpet/app/registry.hpp"
#include "limpet/app/run_app.hpp"
#include "limpet/core/number_text.hpp"

namespace limpet {
namespace {

constexpr int kRelays = 3;
constexpr int kPort = 19754;

std::string Stage(int stage) { return fmt::format("LOOP_{}", stage); }

struct NoParams {
  template <class V>
  void Describe(V&) {}
};

/// Hands on what the stage before says; its own stage is the digit that ends its name.
class Relay final : public App {
 public:
  using Params = NoParams;
  Relay(const AppContext& context, const Params&)
      : App(context), stage_(context.name.back() - '0') {
    SubscribeRaw(Stage(stage_ - 1),
                 [this](const MessagePtr& message) { PublishRaw(Stage(stage_), message->value); });
  }

 private:
  int stage_;
};

/// Beats at each tick, and hears its beats come round.
class Beat final : public App {
 public:
  using Params = NoParams;
  Beat(const AppContext& context, const Params&) : App(context) {
    SubscribeRaw(Stage(kRelays), [this](const MessagePtr& message) {
      const auto number = static_cast<std::size_t>(std::get<double>(message->value));
      if (number < sent_.size()) {
        delays_.push_back((this->now() - sent_[number]).value());
      }
    });
  }
  void Tick(Seconds now) override {
    sent_.push_back(now);
    PublishRaw(Stage(0), static_cast<double>(sent_.size() - 1));
  }
  void Finish(Seconds) override {
    if (sent_.size() < 10 || delays_.empty()) {
      fmt::print("the ring did not close: {} beats, {} came round\n", sent_.size(), delays_.size());
      return;
    }
    const double period = ParseNumber(std::getenv("WARP_LOOP_PERIOD")).value();
    const double span = (sent_.back() - sent_.front()).value();
    const double due = span / period;
    const auto beats = static_cast<double>(sent_.size() - 1);
    std::ranges::sort(delays_);
    const auto quantile = [this](double q) {
      return delays_[static_cast<std::size_t>(q * static_cast<double>(delays_.size() - 1))];
    };
    const auto in_time = std::ranges::lower_bound(delays_, period) - delays_.begin();
    fmt::print("beats                  {:.0f} of {:.0f} due: {:+.2f} %\n", beats, due,
               100.0 * (beats / due - 1.0));
    fmt::print("came round             {} of {}; within the period {:.2f} %\n", delays_.size(),
               sent_.size(),
               100.0 * static_cast<double>(in_time) / static_cast<double>(sent_.size()));
    fmt::print("round the ring, MOOS s p50 {:.4f}  p99 {:.4f}  (period {:g})\n", quantile(0.5),
               quantile(0.99), period);
  }

 private:
  std::vector<Seconds> sent_;
  std::vector<double> delays_;  ///< [MOOS s]
};

LIMPET_REGISTER_APP(Relay, "pRelay", 10.0);
LIMPET_REGISTER_APP(Beat, "pBeat", 10.0);

template <class Body>
pid_t Start(Body body) {
  const pid_t child = fork();
  if (child == 0) {
    body();
    std::fflush(stdout);
    _exit(0);
  }
  return child;
}

pid_t StartApp(const std::string& process, const std::string& name, double warp, double tick) {
  return Start([&] {
    const std::array<std::string, 5> words{
        process, "--moos_name=" + name, fmt::format("--moos_port={}", kPort),
        fmt::format("--moos_time_warp={:g}", warp), fmt::format("--moos_app_tick={:g}", tick)};
    std::array<const char*, 5> argv{};
    std::ranges::transform(words, argv.begin(), [](const std::string& w) { return w.c_str(); });
    static_cast<void>(RunApp(process, static_cast<int>(argv.size()), argv.data()));
  });
}

void Measure(const std::string& database, double warp, double tick, double seconds) {
  std::array<double, 3> load{};
  static_cast<void>(getloadavg(load.data(), 3));
  fmt::print("load {:.2f}, {} cores; warp {:g}, AppTick {:g}: {:g} beats a second, 4 processes\n",
             load[0], std::thread::hardware_concurrency(), warp, tick, warp * tick);
  std::fflush(stdout);
  setenv("WARP_LOOP_PERIOD", fmt::format("{}", 1.0 / tick).c_str(), 1);
  std::vector<pid_t> children;
  children.push_back(Start([&] {
    const std::string port = fmt::format("--moos_port={}", kPort);
    const std::string time_warp = fmt::format("--moos_time_warp={:g}", warp);
    execl(database.c_str(), "LimpetDB", port.c_str(), time_warp.c_str(), nullptr);
    _exit(127);
  }));
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  for (int i = 1; i <= kRelays; ++i) {
    children.push_back(StartApp("pRelay", fmt::format("pRelay{}", i), warp, tick));
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  children.push_back(StartApp("pBeat", "pBeat", warp, tick));
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
  for (auto child = children.rbegin(); child != children.rend(); ++child) {
    kill(*child, SIGTERM);
    waitpid(*child, nullptr, 0);
  }
}

}  // namespace
}  // namespace limpet

int main(int argc, char** argv) {
  const auto number = [&](int index, double otherwise) {
    return argc > index ? limpet::ParseNumber(argv[index]).value_or(otherwise) : otherwise;
  };
  limpet::Measure(argc > 1 ? argv[1] : "build/bin/LimpetDB", number(2, 100.0), number(3, 10.0),
                  number(4, 10.0));
  return 0;
}

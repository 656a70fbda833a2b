// SPDX-License-Identifier: MIT
// thrust_stops [HITS] [WARP...] [PROCESS...]: how long after the death or the hang of helm, pilot,
// navigation or database, or those named, the thrusters are off. Real processes under pLaunch, of a
// vehicle under way; each is hit HITS times (20) by SIGSTOP and as often by SIGKILL, in turn at the
// warps (1 2 5 10). Prints a table; fails if a thrust was in force longer than it may be.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include "limpet/core/number_text.hpp"
#include "tests/unit/launch/live_mission.hpp"

namespace limpet {
namespace {

/// Vehicle time from a hit to zero thrust.
constexpr double kZeroAfter = 1.2;
/// Age of a command that is obeyed [s of vehicle time], and what rounding adds.
constexpr double kOldestObeyed = 1.0 + 1e-6;
const std::vector<std::string> kVictims{"pHelm", "pPilot", "pNav", "LimpetDB"};

enum class Outcome {
  kZero,      ///< within kZeroAfter, and what the machine was late
  kReplaced,  ///< commanded again by the replaced process before commands were too old
  kLate,
  kNotHit,  ///< the vehicle was not under way any more
};

struct Tally {
  int zero = 0, replaced = 0, late = 0;
  double worst = 0.0;  ///< from hit to zero [s of vehicle time]
  double late_by_machine = 0.0;
};

/// Missions one after the other at one warp: there is always one whose vehicle is under way.
class Missions {
 public:
  explicit Missions(double warp) : warp_(warp) {}

  /// Under way, with thrust; nothing if that takes longer than it may.
  LiveMission* UnderWay() {
    for (int attempt = 0; attempt < 3; ++attempt) {
      if (mission_ && uses_ < kMostUses && IsUnderWay()) {
        ++uses_;
        return mission_.get();
      }
      uses_ = 1;
      mission_ = std::make_unique<LiveMission>();
      mission_->Launch(fmt::format("--MOOSTimeWarp={:g}", warp_));
      if (mission_->AwaitDive()) return mission_.get();
      fmt::print(stderr, "not under way within a minute:\n{}\n", mission_->Said());
    }
    return nullptr;
  }

 private:
  /// Each new life is waited for twice as long as the one before, and after some there is none.
  static constexpr int kMostUses = 4;

  bool IsUnderWay() {
    return mission_->Await([this] {
      if (IsOver()) return true;
      const auto thrust = mission_->Thrust();
      return thrust && thrust->greatest > 0.05;
    }) && !IsOver();
  }
  [[nodiscard]] bool IsOver() const {
    const std::string phase = mission_->Latest("SURVEY_PHASE");
    return (phase != "DIVE" && phase != "SURVEY") || !mission_->Latest("MISSION_END").empty();
  }

  double warp_;
  int uses_ = 0;  ///< of the mission that there is
  std::unique_ptr<LiveMission> mission_;
};

Outcome Hit(LiveMission& mission, const std::string& victim, int signal, double warp,
            Tally& tally) {
  constexpr double kTold = 2.0;  // real time in which a vehicle under way says its thrust [s]
  const pid_t pid = mission.PidOf(victim);
  if (pid == 0) return Outcome::kNotHit;
  const double hit = mission.Now().value();
  mission.ForgetLateness();
  ::kill(pid, signal);
  const auto zero_at = [&]() -> std::optional<double> {
    const auto thrust = mission.Thrust();
    return thrust && thrust->zero_at && *thrust->zero_at > hit ? thrust->zero_at : std::nullopt;
  };
  const bool is_replaced = mission.Await([&] {
    const pid_t now = mission.PidOf(victim);
    return now != 0 && now != pid;
  });
  const double told_at = mission.Now().value() + kTold * warp;
  const bool is_told =
      mission.Await([&] { return zero_at() || (is_replaced && mission.Now().value() > told_at); });
  const std::optional<double> zero = zero_at();
  if (!is_replaced || !is_told) return Outcome::kLate;
  if (!zero) {
    const bool none_too_old = mission.Thrust() && mission.Thrust()->oldest_obeyed <= kOldestObeyed;
    return none_too_old ? Outcome::kReplaced : Outcome::kLate;
  }
  const double late = 2.0 * warp * mission.lateness().value();
  tally.worst = std::max(tally.worst, *zero - hit);
  tally.late_by_machine = std::max(tally.late_by_machine, late);
  return *zero - hit <= kZeroAfter + late ? Outcome::kZero : Outcome::kLate;
}

void Count(Outcome outcome, Tally& tally) {
  tally.zero += outcome == Outcome::kZero ? 1 : 0;
  tally.replaced += outcome == Outcome::kReplaced ? 1 : 0;
  tally.late += outcome == Outcome::kLate ? 1 : 0;
}

int Run(int hits, const std::vector<double>& warps, const std::vector<std::string>& victims) {
  fmt::print("{:<12}{:<10}{:>6}{:>12}{:>12}{:>8}{:>12}{:>18}\n", "process", "signal", "warp",
             "zero", "replaced", "late", "worst [s]", "machine late [s]");
  int late = 0;
  for (const double warp : warps) {
    Missions missions(warp);
    for (const std::string& victim : victims) {
      for (const auto& [signal, name] : {std::pair{SIGSTOP, "SIGSTOP"}, {SIGKILL, "SIGKILL"}}) {
        Tally tally;
        const int wanted = std::max(1, hits / static_cast<int>(warps.size()));
        for (int i = 0; i < wanted;) {
          LiveMission* mission = missions.UnderWay();
          if (mission == nullptr) return EXIT_FAILURE;
          const Outcome outcome = Hit(*mission, victim, signal, warp, tally);
          Count(outcome, tally);
          i += outcome == Outcome::kNotHit ? 0 : 1;
        }
        late += tally.late;
        fmt::print("{:<12}{:<10}{:>6g}{:>12}{:>12}{:>8}{:>12.2f}{:>18.2f}\n", victim, name, warp,
                   tally.zero, tally.replaced, tally.late, tally.worst, tally.late_by_machine);
        std::fflush(stdout);
      }
    }
  }
  return late == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace
}  // namespace limpet

int main(int argc, char** argv) {
  const std::optional<int> hits = argc > 1 ? limpet::ParseInteger(argv[1]) : 20;
  std::vector<double> warps;
  std::vector<std::string> victims;
  bool is_known = hits.value_or(0) >= 1;
  for (int i = 2; i < argc; ++i) {
    const std::optional<double> warp = limpet::ParseNumber(argv[i]);
    if (warp) warps.push_back(*warp);
    if (!warp) victims.emplace_back(argv[i]);
    is_known =
        is_known && (warp ? *warp > 0.0 : std::ranges::count(limpet::kVictims, victims.back()) > 0);
  }
  if (!is_known) {
    fmt::print(stderr, "usage: thrust_stops [HITS, at least 1] [WARP...] [PROCESS...]; of {}\n",
               fmt::join(limpet::kVictims, ", "));
    return 2;
  }
  if (warps.empty()) warps = {1.0, 2.0, 5.0, 10.0};
  return limpet::Run(*hits, warps, victims.empty() ? limpet::kVictims : victims);
}

// SPDX-License-Identifier: MIT
// Does the change posterior mean what it says? Brier score and expected calibration error of each
// status over simulated places, with passes that fail as a whole, and with the detector 20 % worse
// or better than believed. Exit code 3 if a bound is missed.
//
// usage: change_calibration [places] [seed]
#include <cstdlib>

#include <fmt/format.h>

#include "tests/support/change_simulation.hpp"

namespace {

constexpr double kBrierBound = 0.05;
constexpr double kErrorBound = 0.03;

struct Case {
  const char* name;
  limpet::trial::ChangeWorld world;
};

bool Report(const Case& one, int places, std::uint64_t seed) {
  constexpr std::array<const char*, 4> kNames{"confirmed", "removed", "new", "nothing"};
  limpet::Random random(seed, one.name);
  const auto scores = limpet::trial::Calibrate(one.world, limpet::LookParams{}, places, random);
  bool is_good = true;
  for (std::size_t i = 0; i < scores.size(); ++i) {
    const bool fits = scores[i].brier <= kBrierBound && scores[i].expected_error <= kErrorBound;
    fmt::print("{:<28} {:<10} Brier {:.4f}  ECE {:.4f}{}\n", one.name, kNames[i], scores[i].brier,
               scores[i].expected_error, fits ? "" : "  OUT OF BOUNDS");
    is_good = is_good && fits;
  }
  return is_good;
}

}  // namespace

int main(int argc, char** argv) {
  const int places = argc > 1 ? std::atoi(argv[1]) : 20000;
  const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  using World = limpet::trial::ChangeWorld;
  const std::array<Case, 8> cases{{
      {"as believed", World{}},
      {"rate 20 % lower", World{.rate_factor = 0.8}},
      {"rate 10 % higher", World{.rate_factor = 1.1}},
      {"believed rate 20 % too low", World{.detects = 0.75, .rate_factor = 1.2}},
      {"poor detector", World{.detects = 0.6}},
      {"poor detector, 20 % lower", World{.detects = 0.6, .rate_factor = 0.8}},
      {"more failing passes", World{.pass_failure = 0.05}},
      {"more false alarms", World{.false_alarm = 0.01}},
  }};
  fmt::print("{} places, bounds: Brier {} ECE {}\n", places, kBrierBound, kErrorBound);
  bool is_good = true;
  for (const Case& one : cases) {
    is_good = Report(one, places, seed) && is_good;
  }
  return is_good ? 0 : 3;
}

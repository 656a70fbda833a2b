// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "limpet/tuning/parameter_space.hpp"
#include "limpet/tuning/student_t.hpp"

namespace limpet {

/// What one run was worth: its cost, to be minimised, if it has one, and whether it kept every
/// constraint.
struct RunOutcome {
  std::optional<double> cost;
  bool keeps_constraints = true;
};

/// A setting in the race, with what its runs gave: one per seed, all settings in the same order of
/// seeds. The mission as it stands (the default) is the first contender and is never eliminated.
struct Contender {
  SettingValues setting;  ///< of the default: what the mission says
  bool is_default = false;
  std::vector<RunOutcome> outcomes{};
  std::string eliminated{};  ///< why; empty: still in the race

  [[nodiscard]] bool is_in() const { return eliminated.empty(); }
  [[nodiscard]] std::vector<double> Costs() const;
  [[nodiscard]] std::size_t Failures() const;  ///< runs without cost or that broke a constraint
};

/// One run that is wanted.
struct Flight {
  std::size_t contender = 0;
  std::size_t seed_index = 0;
};

struct RaceRules {
  std::size_t runs = 10;        ///< of each setting, at most
  double share = 0.9;           ///< of its runs that must keep the constraints
  std::size_t first_block = 5;  ///< runs of every setting before any is eliminated
  double error_rate = 0.05;     ///< of one comparison round, shared out by Bonferroni
};

/// cost of a less cost of b, over seeds of which both have one.
[[nodiscard]] std::vector<double> PairedDifferences(const Contender& a, const Contender& b);

/// Flies settings seed by seed and eliminates losers: after each block of seeds, those that break
/// the constraints too often, and those that are surely worse than the leader by a one-sided paired
/// t-test.
class Race {
 public:
  /// Outcomes in the order of the flights. An empty list: interrupted.
  using Fly = std::function<std::vector<RunOutcome>(const std::vector<Contender>&,
                                                    const std::vector<Flight>&)>;
  Race(const RaceRules& rules, Contender by_default, Fly fly);

  void Enter(const std::vector<SettingValues>& settings);
  /// Runs until every contender is eliminated or has all its runs. False if interrupted.
  [[nodiscard]] bool Run();

  [[nodiscard]] const std::vector<Contender>& contenders() const { return contenders_; }
  /// The contender with all its runs, in the race and within the constraints, of the least mean
  /// cost; of several the first. Nothing if there is none but the default, unless it counts.
  [[nodiscard]] std::optional<std::size_t> Best(bool counts_default) const;

 private:
  [[nodiscard]] std::optional<std::size_t> Leader() const;
  void EliminateBreakers();
  void EliminateLosers();
  [[nodiscard]] std::size_t LeastRuns() const;

  RaceRules rules_;
  Fly fly_;
  std::vector<Contender> contenders_;
};

}  // namespace limpet

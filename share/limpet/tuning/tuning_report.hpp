// SPDX-License-Identifier: MIT
// What is told of a finished search: tune.json, the figure, the words.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "limpet/tuning/tuning_search.hpp"

namespace limpet {

/// What was searched for.
struct TuningTask {
  std::string mission;
  std::string objective;
  std::vector<std::string> constraints{};
  bool maximises = false;
  std::uint64_t first_seed = 1;
  TuningRules rules{};

  /// A cost as the objective has it.
  [[nodiscard]] double Objective(double cost) const { return maximises ? -cost : cost; }
};

/// The mean objective of a setting with its interval, in the objective's own sign; nothing if no
/// run has one.
[[nodiscard]] std::optional<MeanInterval> ObjectiveOf(const TuningTask& task,
                                                      const Contender& contender);
/// Winner less default, on held-out seeds.
[[nodiscard]] std::optional<MeanInterval> ObjectiveDifference(const TuningTask& task,
                                                              const TuningOutcome& outcome);

/// The judgement in one sentence, with the interval and how it was made.
[[nodiscard]] std::string VerdictText(const TuningTask& task, const ParameterSpace& space,
                                      const TuningOutcome& outcome);
/// `x=1, y=2`, in four digits.
[[nodiscard]] std::string ValuesText(const ParameterSpace& space, const SettingValues& values);
/// `410.2 [402.1, 418.3]`.
[[nodiscard]] std::string IntervalText(const std::optional<MeanInterval>& interval);

[[nodiscard]] std::string TuneJson(const TuningTask& task, const ParameterSpace& space,
                                   const TuningOutcome& outcome);
/// The search as SVG: the response over each parameter, and with several parameters their parallel
/// coordinates.
[[nodiscard]] std::string TuneFigure(const TuningTask& task, const ParameterSpace& space,
                                     const TuningOutcome& outcome);

}  // namespace limpet

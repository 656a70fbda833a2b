// SPDX-License-Identifier: MIT
#include "limpet/tuning/tuning_report.hpp"

#include <utility>

#include <fmt/format.h>

namespace limpet {
namespace {

MeanInterval WithSign(MeanInterval interval, bool is_turned) {
  if (!is_turned) return interval;
  interval.mean = -interval.mean;
  std::swap(interval.low, interval.high);
  if (interval.low) interval.low = -*interval.low;
  if (interval.high) interval.high = -*interval.high;
  return interval;
}

}  // namespace

std::optional<MeanInterval> ObjectiveOf(const TuningTask& task, const Contender& contender) {
  const std::vector<double> costs = contender.Costs();
  if (costs.empty()) return std::nullopt;
  return WithSign(IntervalOf(costs), task.maximises);
}

std::optional<MeanInterval> ObjectiveDifference(const TuningTask& task,
                                                const TuningOutcome& outcome) {
  const std::optional<MeanInterval> difference = outcome.Difference();
  if (!difference) return std::nullopt;
  return WithSign(*difference, task.maximises);
}

std::string ValuesText(const ParameterSpace& space, const SettingValues& values) {
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < values.size(); ++i)
    texts.push_back(fmt::format("{}={:.4g}", space.parameters()[i].name, values[i]));
  return fmt::format("{}", fmt::join(texts, ", "));
}

std::string IntervalText(const std::optional<MeanInterval>& interval) {
  if (!interval) return "none";
  if (!interval->low) return fmt::format("{:.4g}", interval->mean);
  return fmt::format("{:.4g} [{:.4g}, {:.4g}]", interval->mean, *interval->low, *interval->high);
}

std::string VerdictText(const TuningTask& task, const ParameterSpace& space,
                        const TuningOutcome& outcome) {
  if (!outcome.winner) {
    return "no setting but the default is left: all others are worse in the search, or break a "
           "constraint too often";
  }
  const std::optional<MeanInterval> difference = ObjectiveDifference(task, outcome);
  const std::string judged =
      fmt::format("paired over {} seeds held out from the search, 95 % interval by Student's t",
                  outcome.held_out->differences.size());
  const std::string other = ValuesText(space, outcome.contenders[*outcome.winner].setting);
  if (!difference || !difference->low) {
    return fmt::format(
        "too few runs have an objective to judge {}, the best setting beside the default in the "
        "search, on held-out seeds",
        other);
  }
  const std::string interval = fmt::format("{:.4g}, interval [{:.4g}, {:.4g}]", difference->mean,
                                           *difference->low, *difference->high);
  if (outcome.is_better) {
    return fmt::format("{} is better than the default: difference {} ({})", other, interval,
                       judged);
  }
  const bool breaks = outcome.Difference()->high < 0.0;
  return fmt::format(
      "no setting is better than the default: difference {} of {}, the best beside it in the "
      "search ({}){}",
      interval, other, judged, breaks ? "; it breaks a constraint too often there" : "");
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/helm/option_search.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

#include <Eigen/Geometry>

#include "limpet/planning/survey_blocks.hpp"

namespace limpet {
namespace {

/// Of an area that is surveyed block by block, objects far from this one wait for theirs; once all
/// that is left is slivers they do not.
void LeaveFarTargetsOut(const Ground& ground, std::vector<Target>& targets) {
  constexpr double kFar = 50.0;  // [m]
  const bool is_done = ground.SeenShare(Footprint::kTop) >= SurveyBlocks::kDoneShare;
  if (!ground.is_part() || is_done) return;
  const GridFrame& frame = ground.frame();
  const PlanePoint low(frame.north_min, frame.east_min);
  const PlanePoint high = low + PlanePoint(frame.rows * frame.cell_m, frame.columns * frame.cell_m);
  const Eigen::AlignedBox2d block(low, high);
  std::erase_if(targets, [&](const Target& target) {
    return block.exteriorDistance(PlanePoint(target.north, target.east)) > kFar;
  });
}

}  // namespace

SearchGoals OptionSearch::Goals(std::span<const WeightedBehavior> running, const Situation& now,
                                std::vector<BehaviorFailure>& failures) {
  SearchGoals goals;
  for (const WeightedBehavior& behavior : running) {
    SearchGoals shaped = goals;
    if (Hears(behavior, shapes_, failures,
              [&] { behavior.behavior->Shape(now, behavior.weight, shaped); })) {
      goals = std::move(shaped);
    }
  }
  LeaveFarTargetsOut(*now.ground, goals.objective.targets);
  return goals;
}

std::vector<Option> OptionSearch::Gather(std::span<const WeightedBehavior> running,
                                         const Situation& now,
                                         std::vector<BehaviorFailure>& failures) {
  const SearchGoals goals = Goals(running, now, failures);
  std::vector<Option> options;
  for (const auto& generator : generators_) {
    generator->Offer(now, goals, options);
  }
  for (const WeightedBehavior& behavior : running) {
    std::vector<Option> offered = options;
    if (Hears(behavior, offers_, failures, [&] { behavior.behavior->Offer(now, offered); })) {
      std::move(
          offered.begin() + static_cast<std::ptrdiff_t>(std::min(options.size(), offered.size())),
          offered.end(), std::back_inserter(options));
    }
  }
  for (const auto& generator : generators_) {
    generator->Complete(options);
  }
  return options;
}

void OptionSearch::TellChoice(const Option& option) {
  for (const auto& generator : generators_) {
    generator->OnChoice(option);
  }
}

}  // namespace limpet

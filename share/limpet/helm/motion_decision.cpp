// SPDX-License-Identifier: MIT
#include "limpet/helm/motion_decision.hpp"

#include <utility>

namespace limpet {

std::string MotionDecision::Missing() const {
  std::string names;
  const auto add = [&names](bool is_missing, const char* name) {
    if (is_missing) {
      names += (names.empty() ? "" : ",") + std::string(name);
    }
  };
  add(!course.has_value(), "course");
  add(!speed.has_value(), "speed");
  add(!depth.has_value(), "depth");
  return names;
}

MotionDecision DecideMotion(std::span<const WeightedBehavior> behaviors, const VehicleState& state,
                            const MotionDomain& domain) {
  MotionDecision decision;
  std::vector<WeightedPeak> course;
  std::vector<WeightedPeak> speed;
  std::vector<WeightedPeak> depth;
  double heaviest = 0.0;
  for (const WeightedBehavior& running : behaviors) {
    MotionBid bid = running.behavior->Move(state);
    decision.turns.push_back({running.name, std::move(bid.acts)});
    if (running.weight <= 0.0) {
      continue;  // it acts, and has no say
    }
    const auto add = [&running](std::vector<WeightedPeak>& peaks, const std::optional<Peak>& peak) {
      if (peak) {
        peaks.push_back({*peak, running.weight});
      }
    };
    add(course, bid.course);
    add(speed, bid.speed);
    add(depth, bid.depth);
    if (bid.course && running.weight > heaviest) {
      heaviest = running.weight;
      decision.turn_rate = bid.turn_rate;
    }
    if (bid.warning) {
      decision.warnings.push_back({.owner = running.name, .warning = *bid.warning});
    }
    if (bid.course || bid.speed || bid.depth) {
      decision.active.push_back(running.name);
    }
  }
  if (!course.empty()) {
    decision.course = MaximizeOverCircle(course);
  }
  if (!speed.empty()) {
    decision.speed = MaximizeOverInterval(speed, domain.speed_low, domain.speed_high);
  }
  if (!depth.empty()) {
    decision.depth = MaximizeOverInterval(depth, domain.depth_low, domain.depth_high);
  }
  return decision;
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/helm/motion_record.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "limpet/core/frames.hpp"

namespace limpet {
namespace {

constexpr Seconds kPeriod(1.0);

const std::optional<Peak>& PeakOn(MotionVariable variable, const MotionBid& bid) {
  return variable == MotionVariable::kCourse  ? bid.course
         : variable == MotionVariable::kSpeed ? bid.speed
                                              : bid.depth;
}

double DistanceBetween(double a, double b, MotionVariable variable) {
  return variable == MotionVariable::kCourse ? std::abs(WrapAngle(a - b)) : std::abs(a - b);
}

MotionOpinion OpinionOf(const OwnedMotionBid& owned, const Peak& peak, MotionVariable variable,
                        double chosen) {
  const bool is_course = variable == MotionVariable::kCourse;
  const double unit = is_course ? 180.0 / std::numbers::pi : 1.0;
  return {.behavior = owned.owner,
          .variables = NameOf(variable),
          .weight = owned.weight * peak.share,
          .value = PeakValue(peak, DistanceBetween(chosen, peak.summit, variable)),
          .summit = is_course ? MoosHeadingFromYaw(WrapAngle(peak.summit)) : peak.summit,
          .flat_half_width = peak.edge_value < 1.0 ? 0.0 : peak.flat_half_width * unit,
          .base_half_width = peak.base_half_width * unit};
}

/// The point of an axis that is nearest to a value.
std::size_t PointAt(double value, const MotionAxis& axis, MotionVariable variable) {
  int nearest = 0;
  for (int point = 1; point < axis.points; ++point) {
    if (DistanceBetween(axis.At(point), value, variable) <
        DistanceBetween(axis.At(nearest), value, variable)) {
      nearest = point;
    }
  }
  return static_cast<std::size_t>(nearest);
}

MotionOpinion OpinionOf(const OwnedMotionBid& owned, const MotionDecision& decision) {
  const MotionTable& table = *owned.bid.table;
  std::string variables;
  std::size_t at = 0;
  for (const MotionVariable variable : kMotionVariables) {
    const std::optional<double>& chosen = decision.value(variable);
    if (table.Covers(variable) && chosen) {
      variables += (variables.empty() ? "" : "+") + std::string(NameOf(variable));
      at += table.stride(variable) * PointAt(*chosen, *table.domain().axis(variable), variable);
    }
  }
  return {.behavior = owned.owner,
          .variables = variables,
          .weight = owned.weight,
          .value = static_cast<double>(table.values()[at]),
          .summit = {},
          .flat_half_width = {},
          .base_half_width = {}};
}

}  // namespace

HelmMotion RecordOf(const MotionArbiter& arbiter, const MotionDecision& decision) {
  HelmMotion motion{
      .course_deg = {}, .speed_mps = decision.speed, .depth_m = decision.depth, .opinions = {}};
  if (decision.course) {
    motion.course_deg = MoosHeadingFromYaw(*decision.course);
  }
  for (const OwnedMotionBid& owned : arbiter.bids()) {
    for (const MotionVariable variable : kMotionVariables) {
      const std::optional<double>& chosen = decision.value(variable);
      const std::optional<Peak>& peak = PeakOn(variable, owned.bid);
      if (peak && chosen) motion.opinions.push_back(OpinionOf(owned, *peak, variable, *chosen));
    }
    if (owned.bid.present_course && decision.course) {
      motion.opinions.push_back(
          OpinionOf(owned, *owned.bid.present_course, MotionVariable::kCourse, *decision.course));
    }
    if (owned.bid.table != nullptr) {
      motion.opinions.push_back(OpinionOf(owned, decision));
    }
  }
  return motion;
}

bool MotionRecordRate::IsDue(const MotionDecision& decision, Seconds now) {
  if (told_at_ && now - *told_at_ < kPeriod && told_ == decision.active) {
    return false;
  }
  told_ = decision.active;
  told_at_ = now;
  return true;
}

}  // namespace limpet

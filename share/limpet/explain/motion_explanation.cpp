// SPDX-License-Identifier: MIT
#include "limpet/explain/motion_explanation.hpp"

#include <algorithm>
#include <cmath>

#include "limpet/core/frames.hpp"

namespace limpet {
namespace {

/// How far two summits of one variable lie apart, in what is much of it.
double Difference(const std::string& variable, double a, double b) {
  constexpr double kMuchSpeed = 0.05, kMuchDepth = 0.1;  // [m/s], [m]
  if (variable == "speed") return std::abs(a - b) / kMuchSpeed;
  if (variable == "depth") return std::abs(a - b) / kMuchDepth;
  constexpr double kMuchCourse = 5.0;  // [deg]
  return std::abs(DegreesFromRadians(WrapAngle(RadiansFromDegrees(a - b)))) / kMuchCourse;
}

bool WantsMuchTheSame(const MotionOpinion& a, const MotionOpinion& b) {
  if (a.behavior != b.behavior || a.variables != b.variables || a.weight != b.weight) return false;
  if (a.summit.has_value() != b.summit.has_value()) return false;
  return !a.summit || Difference(a.variables, *a.summit, *b.summit) < 1.0;
}

}  // namespace

Explanation ExplainMotion(const LoggedMotion& logged) {
  Explanation explanation;
  explanation.time = logged.time;
  explanation.cause = "no behavior decides where next";
  explanation.motion = logged;
  return explanation;
}

std::vector<LoggedMotion> ChangesOfMotion(std::span<const LoggedMotion> motions) {
  std::vector<LoggedMotion> changes;
  for (const LoggedMotion& now : motions) {
    if (changes.empty() || !std::ranges::equal(now.motion.opinions, changes.back().motion.opinions,
                                               WantsMuchTheSame)) {
      changes.push_back(now);
    }
  }
  return changes;
}

}  // namespace limpet

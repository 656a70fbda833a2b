// SPDX-License-Identifier: MIT
// Why a vehicle moves as it does where no behavior decides where next: there is no survey, only
// behaviors that want a course, a speed or a depth; and when the helm drove nothing.
#pragma once

#include <string>
#include <vector>

#include "limpet/explain/decision_log.hpp"
#include "limpet/explain/explanation.hpp"

namespace limpet {

/// A time from which on the vehicle moves otherwise than before.
struct MotionChange {
  double time = 0.0;  ///< as LoggedDecision::time [s]
  std::string cause;
  LoggedMotion motion;  ///< from then on
};

/// One without options, of which nothing could be chosen.
[[nodiscard]] Explanation ExplainMotion(const LoggedMotion& logged);
[[nodiscard]] Explanation ExplainChange(const MotionChange& change);

/// Where the helm stopped, and where it went on. In order.
[[nodiscard]] std::vector<MotionChange> StopsOf(const DecisionLog& log);

/// StopsOf, and the words of the helm at which something else has changed since the last one: who
/// wants something, whose wish counts most on course, speed or depth, a mode, or what was chosen,
/// by more than 5 deg, 0.05 m/s or 0.1 m. In order.
[[nodiscard]] std::vector<MotionChange> ChangesOfMotion(const DecisionLog& log);

}  // namespace limpet

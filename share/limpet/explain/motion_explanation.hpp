// SPDX-License-Identifier: MIT
// Why a vehicle moves as it does where no behavior decides where next: there is no survey, only
// behaviors that want a course, a speed or a depth.
#pragma once

#include <span>

#include "limpet/explain/decision_log.hpp"
#include "limpet/explain/explanation.hpp"

namespace limpet {

/// One without options, of which nothing could be chosen.
[[nodiscard]] Explanation ExplainMotion(const LoggedMotion& logged);

/// Those of them at which something has changed: who has a say on what and with which weight, or
/// what one of them wants, by more than 5 deg, 0.05 m/s or 0.1 m since the last one. In order.
[[nodiscard]] std::vector<LoggedMotion> ChangesOfMotion(std::span<const LoggedMotion> motions);

}  // namespace limpet

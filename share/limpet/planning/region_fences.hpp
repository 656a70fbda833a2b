// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "limpet/core/units.hpp"
#include "limpet/planning/free_space.hpp"
#include "limpet/survey/survey_shape.hpp"

namespace limpet {

/// The border that the vehicle stays within: the operating region's, or the area's and `margin`
/// beyond; `allowance` inside the former.
[[nodiscard]] Fence HoldingFence(const SurveyShape& shape, Meters margin, Meters allowance);
/// The keep-out zones' borders, `allowance` outside.
[[nodiscard]] std::vector<Fence> ZoneFences(const SurveyShape& shape, Meters allowance);

}  // namespace limpet

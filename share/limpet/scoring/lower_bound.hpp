// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "limpet/scoring/report_settings.hpp"
#include "limpet/topics/mission.hpp"

namespace limpet {

/// The way below which no survey shows all of the band's top: area over swath, as if there were
/// neither turns nor overlap.
struct LowerBound {
  double area_m2 = 0.0;  ///< to be seen: of the area, in no zone
  double swath_m = 0.0;  ///< image at the band's top, across the track, from survey altitude
  /// Nothing where the band reaches up to the camera.
  [[nodiscard]] std::optional<double> path_m() const {
    return swath_m > 0.0 ? std::optional<double>(area_m2 / swath_m) : std::nullopt;
  }
};
[[nodiscard]] LowerBound LowerBoundOf(const SurveyArea& area, const ReportSettings& settings);

}  // namespace limpet

// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "limpet/recordings/recording.hpp"
#include "limpet/recordings/sample_figures.hpp"

namespace limpet {

/// How places, speeds and headings of a vehicle's own navigation go with one another. Places are
/// compared over 5 s and more, where the vehicle went at least 1 m and hardly turned.
struct OwnNavigationCheck {
  std::optional<SampleTimes> places, headings, speeds;
  double path_of_places = 0.0;  ///< [m]
  double path_of_speeds = 0.0;  ///< over pauses of less than 5 s [m]
  Differences speed;            ///< of the places' to the speed that is said [m/s]
  Differences course;           ///< of the places' to the heading [rad]
};

/// Nothing of a recording without such.
[[nodiscard]] std::optional<OwnNavigationCheck> CheckOwnNavigation(const OwnNavigation& own);

}  // namespace limpet

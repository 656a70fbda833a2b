// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "estimation/navigation/navigator.hpp"
#include "estimation/replay/sensor_stream.hpp"
#include "limpet/core/expected.hpp"
#include "limpet/core/units.hpp"
#include "limpet/recordings/recording.hpp"

namespace limpet {

/// What the estimator can make a track of: the vehicle as level, ahead at the speed that it says,
/// down as its depth changes. `heading_sigma` of each heading. The error says what lacks.
[[nodiscard]] Expected<SensorStream> StreamOf(const Recording& recording, Radians heading_sigma);

/// How far a track lies from the vehicle's own places, both from where they begin [m].
struct TrackDifference {
  double greatest = 0.0, at_end = 0.0;
  double path = 0.0;  ///< of the own places, up to the end
};
[[nodiscard]] TrackDifference CompareTracks(const std::vector<SmoothedPose>& track,
                                            const std::vector<TimedPlace>& own);

}  // namespace limpet

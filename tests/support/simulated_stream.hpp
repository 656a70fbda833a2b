// SPDX-License-Identifier: MIT
// Sessions of a simulated survey with truth, of the kind of the recorded streams, for any seed.
#pragma once

#include <cstdint>
#include <map>
#include <utility>

#include "estimation/replay/sensor_stream.hpp"
#include "tests/support/trajectory_error.hpp"

namespace limpet {

/// What is simulated. Defaults: ten minutes over four objects, as in the paper's Table 1.
struct StreamScene {
  std::uint64_t seed = 1;
  double duration_s = 600.0;
  double half_size_m = 16.0;  ///< of the square that is surveyed
  double leg_spacing_m = 4.0;
  int objects = 4;
  int classes = 1;
  bool has_twins = false;    ///< every second object stands 1.1 m beside the one before
  int look_alikes = 0;       ///< things on the seabed that now and then are taken for objects
  bool is_rough = false;     ///< slope and bumps instead of a flat seabed
  double tilt_deg = 30.0;    ///< of the camera, forward from nadir
  double altitude_m = 4.0;   ///< that is flown at
  double false_share = 0.1;  ///< of all boxes
  double yaw_bias_degph = 2.0;
  int long_dropouts = 0;  ///< of the DVL, 25 to 60 s each
  double resurface_every_s = 0.0;
  std::uint64_t place = 0;  ///< seed of the seabed and what stands on it; 0: `seed`
  int gone = 0, came = 0;   ///< of the place's objects, the first are gone, and others came since
};

struct SimulatedStream {
  SensorStream stream;
  StreamTruth truth;  ///< an object's id is the place's: gone ones leave gaps
  /// The object that a box (frame, index) shows; others show none.
  std::map<std::pair<int, int>, int> shown;
};

/// Same scene, same bits.
[[nodiscard]] SimulatedStream SimulateStream(const StreamScene& scene);

}  // namespace limpet

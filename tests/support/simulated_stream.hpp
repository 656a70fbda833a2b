// SPDX-License-Identifier: MIT
// Sessions of a simulated survey with truth, of the kind of the recorded streams, for any seed.
#pragma once

#include <cstdint>
#include <map>
#include <utility>

#include "estimation/replay/sensor_stream.hpp"
#include "tests/support/simulated_survey.hpp"
#include "tests/support/trajectory_error.hpp"

namespace limpet {

struct SimulatedStream {
  SensorStream stream;
  StreamTruth truth;  ///< an object's id is the place's: gone ones leave gaps
  /// The object that a box (frame, index) shows; others show none.
  std::map<std::pair<int, int>, int> shown;
};

/// Same scene, same bits.
[[nodiscard]] SimulatedStream SimulateStream(const StreamScene& scene);

}  // namespace limpet

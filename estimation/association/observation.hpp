// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "estimation/association/box_reading.hpp"
#include "estimation/smoothing/camera_errors.hpp"
#include "estimation/smoothing/chain_graph.hpp"

namespace limpet {

/// One box that was taken to show an object.
struct Observation {
  int frame = 0;
  int detection = 0;  ///< index of the box in its frame
  int node = 0;       ///< pose of the chain at the exposure
  double t = 0.0;
  BoxReading reading;
  std::string color;
  double confidence = 0.0;
  BodyMotion motion{};             ///< of the vehicle then
  std::optional<double> altitude;  ///< of the body origin above the seabed then [m]
  std::vector<TermId> terms;       ///< of the graph, once the object is in it
};

}  // namespace limpet

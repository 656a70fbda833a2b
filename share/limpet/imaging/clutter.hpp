// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "limpet/imaging/solid.hpp"
#include "limpet/vision/seabed_relief.hpp"

namespace limpet {

enum class GrowthKind { kStone, kPlant, kStarfish, kUrchin, kShell };

/// Something flat or low that lies on the seabed.
struct Growth {
  GrowthKind kind = GrowthKind::kStone;
  double north = 0.0, east = 0.0;  ///< middle [m]
  double radius = 0.1;             ///< of what it covers [m]
  float turn = 0.0F;               ///< [rad]
  float form = 0.0F;               ///< 0 to 1: what tells it from others of its kind
  Eigen::Array3f color;            ///< linear blue, green, red, 0 to 1
};

/// What lies on the seabed and is no object: stones, plants, starfish, urchins and shells, and what
/// people lost. It lies where it lies for as long as the seed is the same, whoever looks.
class Clutter {
 public:
  /// Of all that lies there: what a scenario asks for (ImageParams::Clutter, whose defaults are
  /// what a scenario says by saying nothing) and, as litter, what stands in for a detector's false
  /// boxes.
  struct Density {
    double natural_per_m2 = 0.0;
    double litter_per_m2 = 0.0;
  };
  Clutter(const Density& density, std::uint64_t seed) : density_(density), seed_(seed) {}

  struct Area {
    double south = 0.0, north = 0.0, west = 0.0, east = 0.0;  ///< [m]
  };
  /// Appends everything whose middle is in the cells of 1 m that `area` touches.
  void Collect(const Area& area, SeabedRelief& relief, std::vector<Growth>& growth,
               std::vector<Solid>& litter) const;

 private:
  Density density_;
  std::uint64_t seed_;
};

}  // namespace limpet

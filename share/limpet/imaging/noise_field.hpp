// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "limpet/core/random.hpp"
#include "limpet/imaging/seabed_ground.hpp"

namespace limpet {

/// Smooth noise in -1 .. 1 at every texel of a seabed's tile: a sum of octaves, each twice as fine.
class NoiseField {
 public:
  enum class Form { kSmooth, kRidged };  ///< ridged: crests where the smooth one passes 0, as rock
  /// `first_cells` per side, a power of two; `decay`: weight of an octave over that before it.
  NoiseField(int first_cells, int octaves, Random& random, Form form = Form::kSmooth,
             float decay = 0.5F);

  [[nodiscard]] float At(int column, int row) const {
    return values_[SeabedGround::Index(column, row)];
  }

 private:
  void Add(int cells, float weight, Form form, Random& random);
  std::vector<float> values_;
};

}  // namespace limpet

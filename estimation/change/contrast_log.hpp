// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "limpet/survey/visibility_belief.hpp"
#include "limpet/topics/mapping.hpp"
#include "limpet/topics/sensors.hpp"

namespace limpet {

/// What the contrast of the ground, seen from several distances, says of the water. It falls as
/// exp(-3 d / visibility) (5 % are left at the visibility), from what it would be close by, of
/// which little is known; from where it does not stand out of the noise any more, only that is
/// known. Images from like distances are one witness together: ground varies from place to place.
class ContrastLog {
 public:
  /// One image from `range` metres above the ground.
  void Add(double range, const GroundContrast& image);
  /// What is kept, by distance, nearest first.
  [[nodiscard]] const std::vector<ContrastBin>& bins() const { return bins_; }
  /// Replaces what is kept by what another log kept; bins that no log can have are left out.
  void Set(std::vector<ContrastBin> bins);

  /// ln P(contrasts | visibility), up to a constant.
  [[nodiscard]] PerVisibility LogLikelihood() const;

 private:
  [[nodiscard]] ContrastBin& BinAt(double range);

  std::vector<ContrastBin> bins_;
};

}  // namespace limpet

// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "estimation/navigation/navigator.hpp"
#include "limpet/topics/navigation.hpp"

namespace limpet {

/// Notices when the smoother has moved the way already travelled. Poses are noted as they are when
/// they are new, as others learn them, and again with every shift.
class TrackWatch {
 public:
  /// Notes poses at the track's new end; soon after they are new, before a fix can move them.
  void Note(const std::vector<SmoothedPose>& newer);
  [[nodiscard]] int noted() const { return static_cast<int>(told_.size()); }
  /// The shift of the noted poses, if any of them moved further than `kNoticed`.
  /// REQUIRES: `track` holds all noted poses.
  [[nodiscard]] std::optional<TrackShift> Compare(const std::vector<SmoothedPose>& track);
  static constexpr double kNoticed = 0.1;  ///< [m]

 private:
  std::vector<Pose> told_;
};

}  // namespace limpet

// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "limpet/core/units.hpp"
#include "limpet/planning/pose2.hpp"
#include "limpet/topics/mission.hpp"

namespace limpet {

/// Arc, line or arc, arc: one of the six words of [Dubins 1957] between two poses.
struct DubinsWord {
  std::array<PathSegment, 3> segments{};  ///< some may have no length
  double length = 0.0;                    ///< [m]
};

/// The words that exist between two poses, in the order LSL, RSR, LSR, RSL, LRL, RLR. One for
/// inner loops: it allocates nothing.
class DubinsWords {
 public:
  /// REQUIRES: radius > 0.
  DubinsWords(const Pose2& from, const Pose2& to, Meters radius);

  [[nodiscard]] std::span<const DubinsWord> all() const { return {words_.data(), count_}; }
  /// The shortest word; of several of one length the first.
  [[nodiscard]] const DubinsWord& shortest() const;

 private:
  std::array<DubinsWord, 6> words_;
  std::size_t count_ = 0;
};

}  // namespace limpet

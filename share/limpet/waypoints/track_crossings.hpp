// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "limpet/shapes/shape.hpp"

namespace limpet {

/// How often a vehicle has crossed its own track; it forgets the track with each crossing, so that
/// a loop counts once.
class TrackCrossings {
 public:
  /// The vehicle is at `at`: a metre or more from the last place that counted is one more.
  void Move(const MapPoint& at);
  /// Begins anew, with none.
  void Reset() { *this = {}; }

  [[nodiscard]] int count() const { return count_; }

 private:
  [[nodiscard]] bool Crosses(const MapPoint& at) const;

  std::vector<MapPoint> track_;
  int count_ = 0;
};

}  // namespace limpet

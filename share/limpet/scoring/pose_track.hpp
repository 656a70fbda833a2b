// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <deque>
#include <optional>

#include "limpet/core/frames.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

/// Poses over time as columns: NED [m], angles [rad], MOOS time [s], in order of time.
class PoseTrack {
 public:
  /// Appends a pose; one that is not later than the last is ignored.
  void Add(Seconds time, const Pose& X_WB);

  [[nodiscard]] std::size_t size() const { return time_.size(); }
  [[nodiscard]] bool empty() const { return time_.empty(); }
  [[nodiscard]] double time(std::size_t i) const { return time_[i]; }
  [[nodiscard]] double north(std::size_t i) const { return north_[i]; }
  [[nodiscard]] double east(std::size_t i) const { return east_[i]; }
  [[nodiscard]] double down(std::size_t i) const { return down_[i]; }
  [[nodiscard]] Eigen::Vector3d position(std::size_t i) const {
    return {north_[i], east_[i], down_[i]};
  }
  /// Length of the way from the first pose to pose `i` [m].
  [[nodiscard]] double path(std::size_t i) const { return path_[i]; }

  /// Pose at `time`, interpolated; nothing outside the track.
  [[nodiscard]] std::optional<Pose> At(double time) const;
  /// Length of the way up to `time` [m], held at the ends.
  [[nodiscard]] double PathAt(double time) const;

 private:
  /// Index of the last pose at or before `time`. REQUIRES: time(0) <= time.
  [[nodiscard]] std::size_t IndexBefore(double time) const;
  // Hours of them: a vector that grows holds twice as much for nothing.
  std::deque<double> time_, north_, east_, down_, roll_, pitch_, yaw_, path_;
};

}  // namespace limpet

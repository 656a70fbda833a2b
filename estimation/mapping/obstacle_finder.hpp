// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "estimation/mapping/echo_cells.hpp"
#include "estimation/mapping/ground_slope.hpp"
#include "limpet/topics/mapping.hpp"
#include "limpet/topics/navigation.hpp"

namespace limpet {

/// What stands in the vehicle's way, as echoes of a sonar that looks ahead and of DVL beams show
/// it. An echo counts that comes from no deeper than a metre below the vehicle and from well above
/// the seabed there. What belongs together is an obstacle with a convex outline; one that is long
/// or bends is several.
class ObstacleFinder {
 public:
  explicit ObstacleFinder(const DvlBeams& dvl = {}) : dvl_(dvl) {}

  void AddBeams(double t, const PosedBeams& ping);
  void AddSonar(double t, const PosedSonar& sonar);
  void Shift(const TrackShift& shift);
  /// True if what is known has changed by more than echoes scatter; `obstacles()` is then new.
  bool Update();

  [[nodiscard]] const std::vector<Obstacle>& obstacles() const { return obstacles_; }
  [[nodiscard]] const EchoCells& cells() const { return cells_; }

 private:
  [[nodiscard]] bool StandsUp(const Eigen::Vector3d& end_W, double vehicle_down) const;
  /// The obstacle of `known` that `now` is, which is taken out; nothing if there is none.
  [[nodiscard]] std::optional<Obstacle> TakeFormer(const Obstacle& now,
                                                   std::vector<Obstacle>& known) const;

  DvlBeams dvl_;
  GroundSlope ground_;
  EchoCells cells_{0.25};
  bool has_news_ = false;
  int next_id_ = 1;
  std::vector<Obstacle> obstacles_;
};

}  // namespace limpet

// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "limpet/core/units.hpp"
#include "limpet/recordings/recording.hpp"

namespace limpet {

/// How a DVL's four beams stand in its axes, as its own arithmetic betrays it: a velocity v gives
/// the speeds b = D v along the beams, and the instrument makes v = M b of four of them. M is
/// fitted to pings, D is its pseudoinverse.
class BeamGeometry {
 public:
  /// Nothing from fewer pings than 20 with four beams and a velocity, or if these do not move along
  /// all three axes.
  [[nodiscard]] static std::optional<BeamGeometry> Estimate(const std::vector<DvlPing>& pings);

  /// Velocity by a ping with three or four good beams [m/s].
  [[nodiscard]] std::optional<Eigen::Vector3d> Velocity(const DvlPing& ping) const;
  /// By how much four beams contradict one another: the length of what of their speeds no velocity
  /// explains [m/s]. An error of one beam alone shows as half of it.
  [[nodiscard]] std::optional<double> Contradiction(const DvlPing& ping) const;

  /// Angles of the beams from the instrument's vertical.
  [[nodiscard]] std::array<Radians, 4> tilts() const;
  /// About its third axis, from the first towards the second; where beam speeds count towards the
  /// instrument, or its third axis points away from where the beams do, of the opposite direction.
  [[nodiscard]] std::array<Radians, 4> azimuths() const;
  /// Ratio of a speed along each beam to that of its direction; 1 if the instrument scales nothing.
  [[nodiscard]] std::array<double, 4> lengths() const;
  [[nodiscard]] int pings() const { return pings_; }

 private:
  Eigen::Matrix<double, 4, 3> D_ = Eigen::Matrix<double, 4, 3>::Zero();
  int pings_ = 0;
};

}  // namespace limpet

// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include <Eigen/Core>

#include "limpet/core/params.hpp"
#include "limpet/core/random.hpp"

namespace limpet {

/// What goes wrong with single beams of a DVL.
struct BeamErrorParams {
  double loss_share = 0.0;
  double slope_bias = 0.0;

  template <class V>
  void Describe(V& visit) {
    visit("beam_loss_share", loss_share,
          "Chance that a beam meets nothing at a ping; with fewer than three there is no lock",
          InRange(0.0, 1.0));
    visit("beam_slope_bias", slope_bias,
          "Share by which a beam overstates its velocity, per metre that the seabed falls along it "
          "over a metre",
          InRange(-1.0, 1.0));
  }
  [[nodiscard]] bool is_off() const { return loss_share == 0.0 && slope_bias == 0.0; }
};

/// Four beams at 45, 135, 225 and 315 deg about the DVL's down axis.
class BeamError {
 public:
  static constexpr int kBeams = 4;
  using Lost = std::array<bool, kBeams>;
  using Slopes = std::array<double, kBeams>;  ///< of the seabed along each beam, falling positive

  /// `beam_angle` from the vertical [rad].
  BeamError(const BeamErrorParams& params, double beam_angle, Random random);

  [[nodiscard]] Lost DrawLost();
  /// What the beams that are left make of a velocity in the DVL's axes, or nothing if they are
  /// fewer than three.
  [[nodiscard]] std::optional<Eigen::Vector3d> Velocity(const Eigen::Vector3d& v_D,
                                                        const Slopes& slopes,
                                                        const Lost& lost) const;
  /// Unit vector of a beam in the DVL's axes.
  [[nodiscard]] Eigen::Vector3d Direction(int beam) const { return directions_.row(beam); }

 private:
  BeamErrorParams params_;
  Random random_;
  Eigen::Matrix<double, kBeams, 3> directions_;
};

}  // namespace limpet

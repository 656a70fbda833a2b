// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "limpet/core/params.hpp"
#include "limpet/core/random.hpp"
#include "limpet/core/units.hpp"
#include "limpet/simulation/random_intervals.hpp"

namespace limpet {

/// Bursts in which a DVL says one wrong velocity, as valid: a shoal, a side lobe, another sounder.
struct FalseVelocityParams {
  double per_h = 0.0;
  Seconds shortest{2.0}, longest{4.0};
  MetersPerSecond least{0.25}, most{1.0};

  template <class V>
  void Describe(V& visit) {
    using namespace literals;
    visit("false_velocity_per_h", per_h, "Bursts of a false velocity that is said as valid",
          InRange(0.0, 3600.0));
    visit("false_velocity_shortest_s", shortest, "How long the shortest burst lasts",
          InRange(0.0_s, 600.0_s));
    visit("false_velocity_longest_s", longest, "How long the longest burst lasts",
          InRange(0.0_s, 600.0_s));
    visit("false_velocity_least_mps", least, "Horizontal part of the smallest false velocity",
          InRange(0.0_mps, 10.0_mps));
    visit("false_velocity_most_mps", most, "Horizontal part of the greatest",
          InRange(0.0_mps, 10.0_mps));
  }
};

class FalseVelocity {
 public:
  FalseVelocity(const FalseVelocityParams& params, Random random);
  /// What the velocity is off [m/s] at `now`, in the DVL's axes; `now` does not go back.
  [[nodiscard]] Eigen::Vector3d At(Seconds now);

 private:
  FalseVelocityParams params_;
  Random random_;
  RandomIntervals bursts_;
  int drawn_ = 0;  ///< bursts that have their velocity
  Eigen::Vector3d off_ = Eigen::Vector3d::Zero();
};

}  // namespace limpet

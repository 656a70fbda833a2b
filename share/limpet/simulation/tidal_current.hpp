// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "limpet/core/params.hpp"
#include "limpet/core/random.hpp"
#include "limpet/core/units.hpp"
#include "limpet/simulation/gauss_markov.hpp"

namespace limpet {

/// How the current differs from its mean: with the tide, at random, and with depth.
struct TidalCurrentParams {
  Seconds tide_period{0.0};
  Radians tide_swing{0.0};
  double tide_share = 0.0;
  double unrest_share = 0.0;
  Seconds unrest{600.0};
  double shear_per_m = 0.0;
  double turn_deg_per_m = 0.0;

  template <class V>
  void Describe(V& visit) {
    using namespace literals;
    visit("tide_period_s", tide_period, "Period of the tide; 0: no tide",
          InRange(0.0_s, 1000000.0_s));
    visit("tide_swing_deg", tide_swing, "The direction swings by so much to either side",
          InRange(0.0_deg, 180.0_deg));
    visit("tide_share", tide_share,
          "The speed grows and falls by this share; above 1 the current turns back",
          InRange(0.0, 3.0));
    visit("unrest_share", unrest_share, "1-sigma of what comes and goes at random, over the mean",
          InRange(0.0, 2.0));
    visit("unrest_s", unrest, "Correlation time of what comes and goes at random",
          InRange(1.0_s, 100000.0_s));
    visit("shear_per_m", shear_per_m,
          "Share of the surface's current that every metre of depth takes away, down to none",
          InRange(0.0, 1.0));
    visit("turn_deg_per_m", turn_deg_per_m,
          "The current turns with depth, clockwise from above [deg/m]", InRange(-30.0, 30.0));
  }
};

/// The water's own motion over ground, in W: a mean that a tide swings, unrest disturbs and depth
/// weakens. One value for the whole area.
class TidalCurrent {
 public:
  /// `mean_W`: north and east [m/s], at the surface. Where in the tide a session begins is drawn.
  TidalCurrent(const TidalCurrentParams& params, const Eigen::Vector2d& mean_W, Random random);

  /// North and east [m/s] at `now`, which does not go back, `depth` below the surface [m].
  [[nodiscard]] Eigen::Vector2d At(Seconds now, double depth);

 private:
  TidalCurrentParams params_;
  Eigen::Vector2d mean_W_;
  Random random_;
  double phase_ = 0.0;
  GaussMarkov north_, east_;
};

}  // namespace limpet

// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "limpet/core/params.hpp"
#include "limpet/core/random.hpp"
#include "limpet/core/units.hpp"
#include "limpet/simulation/gauss_markov.hpp"
#include "limpet/simulation/random_intervals.hpp"

namespace limpet {

/// What reflections from waves, hull and cliffs do to fixes that state the usual accuracy.
struct GpsErrorParams {
  Meters walk{0.0};
  Seconds walk_time{60.0};
  double jumps_per_h = 0.0;
  Meters jump{10.0};
  Seconds shortest_jump{2.0}, longest_jump{20.0};

  template <class V>
  void Describe(V& visit) {
    using namespace literals;
    visit("walk_m", walk, "1-sigma of each axis of an error that wanders", InRange(0.0_m, 100.0_m));
    visit("walk_time_s", walk_time, "Correlation time of the error that wanders",
          InRange(0.1_s, 3600.0_s));
    visit("jumps_per_h", jumps_per_h, "Jumps of all fixes of a while to another place",
          InRange(0.0, 3600.0));
    visit("jump_m", jump, "1-sigma of each axis of a jump", InRange(0.0_m, 1000.0_m));
    visit("jump_shortest_s", shortest_jump, "How long the shortest jump lasts",
          InRange(0.0_s, 3600.0_s));
    visit("jump_longest_s", longest_jump, "How long the longest jump lasts",
          InRange(0.0_s, 3600.0_s));
  }
};

class GpsError {
 public:
  GpsError(const GpsErrorParams& params, Random random)
      : params_(params),
        random_(random),
        jumps_({.per_second = params.jumps_per_h / 3600.0,
                .shortest = params.shortest_jump,
                .longest = params.longest_jump}),
        north_(params.walk.value(), params.walk_time),
        east_(params.walk.value(), params.walk_time) {}

  /// What a fix at `now`, which does not go back, is off north and east [m].
  [[nodiscard]] Eigen::Vector2d At(Seconds now) {
    Eigen::Vector2d off = Eigen::Vector2d::Zero();
    if (params_.walk > Meters(0.0)) {
      off.x() = north_.Sample(now, random_);
      off.y() = east_.Sample(now, random_);
    }
    if (!jumps_.Contain(now, random_)) return off;
    if (drawn_ != jumps_.count()) {
      drawn_ = jumps_.count();
      jump_W_.x() = random_.Normal(params_.jump.value());
      jump_W_.y() = random_.Normal(params_.jump.value());
    }
    return off + jump_W_;
  }

 private:
  GpsErrorParams params_;
  Random random_;
  RandomIntervals jumps_;
  GaussMarkov north_, east_;
  int drawn_ = 0;  ///< jumps that have their place
  Eigen::Vector2d jump_W_ = Eigen::Vector2d::Zero();
};

}  // namespace limpet

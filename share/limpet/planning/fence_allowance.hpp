// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/core/units.hpp"
#include "limpet/planning/pose2.hpp"
#include "limpet/planning/region.hpp"
#include "limpet/topics/mission.hpp"

namespace limpet {

/// How far paths keep inside the operating region and off the keep-out zones: for the pilot's
/// error, and for three sigmas of the vehicle's place. As far as there is room: no allowance takes
/// ground of the area away from the region, takes more than a seventh of the room to turn (a
/// passage that closes takes all behind it), or leaves the vehicle no turn from where it is. Where
/// sigmas want more, BHV_OpRegion says so.
class FenceAllowance {
 public:
  /// An allowance is a multiple of this more than `tracking` [m], so that it changes seldom.
  static constexpr double kStep = 0.25;
  /// Of the vehicle's place; whoever judges whether borders are kept takes as many.
  static constexpr double kSigmas = 3.0;

  /// REQUIRES: no ProblemOf(area).
  FenceAllowance(const SurveyArea& area, Meters tracking, Meters turn_radius);

  /// For a vehicle at `here` that knows its place with this 1-sigma, where `held` is kept so far.
  /// Where sigmas get less, it falls once it can by two steps.
  [[nodiscard]] Meters For(const Pose2& here, Meters place_sigma, Meters held) const;
  [[nodiscard]] Meters most() const { return tracking_ + Meters(kStep * steps_); }

 private:
  /// So many steps leave a full turn to port or starboard from `here` inside.
  [[nodiscard]] int StepsFrom(const Pose2& here) const;

  Meters tracking_, turn_radius_;
  Region region_;  ///< with the pilot's allowance alone
  int steps_ = 0;  ///< for which there is room
};

}  // namespace limpet

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
/// passage that closes takes all behind it), or leaves the vehicle no way to where it can turn. Of
/// keep-out zones paths keep as far off as no passage closes and their ground stays in sight: a few
/// small ones take much room without being in the way. Where sigmas want more, BHV_OpRegion says
/// so.
class FenceAllowance {
 public:
  /// An allowance is a multiple of this more than `tracking` [m], so that it changes seldom.
  static constexpr double kStep = 0.25;
  /// Sigmas of the vehicle's place that borders are kept off by; whoever judges whether they are
  /// kept takes as many.
  static constexpr double kSigmas = 3.0;

  /// REQUIRES: no ProblemOf(area).
  FenceAllowance(const SurveyArea& area, Meters tracking, Meters turn_radius);

  /// For a vehicle at `here` that knows its place with this 1-sigma, where `held` is kept so far.
  /// Where sigmas get less, it falls once it can by two steps. From farther off than `sight` the
  /// ground along a zone is not seen.
  [[nodiscard]] KeptOff For(const Pose2& here, Meters place_sigma, const KeptOff& held,
                            Meters sight) const;
  [[nodiscard]] KeptOff most() const { return {.border = At(steps_), .zones = At(zone_steps_)}; }

 private:
  [[nodiscard]] Meters At(double steps) const { return tracking_ + Meters(kStep * steps); }
  void FindSteps();
  void FindZoneSteps(const SurveyArea& area);
  /// Steps that a sigma wants.
  [[nodiscard]] static double Wanted(Meters place_sigma);
  [[nodiscard]] double StepsOf(Meters allowance) const;
  /// Of `possible` steps those `wanted`, or what is `held` if that is hardly more.
  [[nodiscard]] Meters Kept(double wanted, Meters held, double possible) const;

  Meters tracking_, turn_radius_;
  Region region_;       ///< with the pilot's allowance alone
  int steps_ = 0;       ///< off the border, for which there is room
  int zone_steps_ = 0;  ///< off zones, for which there is room; no fewer
};

}  // namespace limpet

// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "limpet/planning/pose2.hpp"
#include "limpet/planning/search_term.hpp"
#include "limpet/planning/seen_along.hpp"
#include "limpet/survey/look.hpp"

namespace limpet {

/// A place worth looking at, e.g. an object of the former session.
struct Target {
  double north = 0.0, east = 0.0;  ///< NED [m]
  LookWindow window{};             ///< where it must lie below the vehicle
  double value = 0.0;              ///< for seeing it now [m of path]
  /// Whether the vehicle at `pose` and survey altitude looks at it.
  [[nodiscard]] bool IsSeenFrom(const Pose2& pose) const;
  /// Worth of the first look at it, `s` metres from now: falls to nothing at `decay`.
  [[nodiscard]] double WorthAt(double s, Meters decay) const;
};

/// What newly seen ground is worth, in metres of path.
struct GroundWorth {
  double useful = 0.0;  ///< of the new area
  double ragged = 0.0;  ///< cost of the border that is left between seen and unseen
};
/// The exchange rates between new ground and path; of who wants none, all 0.
struct GroundRates {
  double cover = 0.0;     ///< metres of path per metre of fully useful track
  double frontier = 0.0;  ///< metres of path per metre of new border
  /// Metres of path per metre of path before new ground is seen, mean over the area.
  double early = 0.0;
  /// Metres of path per metre of path before most of bottom and band has been seen.
  double most = 0.0;
  /// `swath` is the ground's [m].
  [[nodiscard]] GroundWorth Of(const NewlySeen& seen, double swath) const {
    return {.useful = cover * seen.new_area / swath, .ragged = frontier * seen.frontier_growth};
  }
};
/// Those of surveys that say nothing: BHV_CoverArea bids by them and tours are made by them.
inline constexpr GroundRates kSurveyRates{.cover = 1.0, .frontier = 0.5, .early = 1.5, .most = 5.0};

/// What a path is worth, in metres of path (docs/references.md):
///   U = cover newArea / swath - frontier dFrontier - length + sum value_i (1 - s_i / decay)
///     + sum of what behaviors add.
struct Objective {
  GroundRates ground;
  std::vector<Target> targets;
  double target_decay_m = 100.0;
  std::vector<std::shared_ptr<const SearchTerm>> terms;  ///< of behaviors; never null

  /// False if there is nothing to search for.
  [[nodiscard]] bool SeeksAnything() const {
    return ground.cover > 0.0 || !targets.empty() || !terms.empty();
  }
};

/// The objective of a whole path from the present ground.
[[nodiscard]] double ValueOf(const DubinsPath& path, const Objective& objective,
                             const Ground& ground, SeenAlong& seen);
/// The targets' part alone: sum of value_i (1 - s_i / decay), s_i where the path first looks at it.
[[nodiscard]] double TargetValueOf(const DubinsPath& path, const Objective& objective);
/// Length of `path` at which it first looks at `target` [m]; nothing if it never does.
[[nodiscard]] std::optional<double> FirstLook(const DubinsPath& path, const Target& target);

}  // namespace limpet

// SPDX-License-Identifier: MIT
// Snapshots that behaviors judge: one for how to move now, one for where to go next.
#pragma once

#include <cmath>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/core/message.hpp"
#include "limpet/core/units.hpp"
#include "limpet/helm/heard_variable.hpp"
#include "limpet/helm/motion_domain.hpp"
#include "limpet/planning/ground.hpp"
#include "limpet/planning/objective.hpp"
#include "limpet/planning/option.hpp"
#include "limpet/planning/region.hpp"
#include "limpet/planning/seen_along.hpp"
#include "limpet/shapes/shape.hpp"
#include "limpet/survey/look.hpp"
#include "limpet/topics/energy.hpp"
#include "limpet/topics/mapping.hpp"
#include "limpet/topics/mission.hpp"
#include "limpet/topics/navigation.hpp"

namespace limpet {

/// What path following asks for now.
struct Guidance {
  double course = 0.0;       ///< [rad]
  double turn_rate = 0.0;    ///< feed-forward [rad/s], starboard positive
  double cross_track = 0.0;  ///< starboard of the path positive [m]
  double remaining = 0.0;    ///< path left [m]
  std::string purpose{};     ///< source of the option that the path was, e.g. home
};

/// What is known of the vehicle when "how now" is decided.
struct VehicleState {
  Seconds now;
  NavState nav;
  std::optional<Guidance> guidance;  ///< absent without a path
  std::optional<SurveyArea> area;
  std::optional<HomePoint> home{};  ///< once it is known
  MotionDomain domain{};            ///< what the helm decides on
  std::string_view ownship{};       ///< the vehicle's name
  /// What conditions, updates and behaviors asked for; null: nothing heard.
  const HeardValues* heard = nullptr;

  /// The last value of a variable that somebody asked for, or null.
  [[nodiscard]] const Stamped<Value>* Heard(std::string_view name) const {
    if (heard == nullptr) return nullptr;
    const auto found = heard->find(name);
    return found == heard->end() ? nullptr : &found->second.last();
  }
  /// Each mail of it since the last iteration, oldest first.
  [[nodiscard]] std::span<const Stamped<Value>> Recent(std::string_view name) const {
    if (heard == nullptr) return {};
    const auto found = heard->find(name);
    if (found == heard->end()) return {};
    return found->second.recent();
  }
  /// Where the vehicle is, as a point of the viewer's map.
  [[nodiscard]] MapPoint place() const { return MapPointOf({nav.north, nav.east}); }
  /// Speed over ground [m/s].
  [[nodiscard]] double speed() const { return std::hypot(nav.u, nav.v); }
};

/// An object as the helm weighs it.
struct WatchedObject {
  OpiBelief belief{};
  /// Where it must lie below the vehicle to be looked at; absent: not seen from survey altitude.
  std::optional<LookWindow> window{};
  int fruitless = 0;  ///< looks planned and flown since the belief last changed
};

/// What is known when "where next" is decided. Pointers are never null and outlive the decision.
struct Situation {
  Seconds now;
  Pose2 pose;                      ///< where options start
  const Ground* ground = nullptr;  ///< of a large area the block that is due
  const Region* region = nullptr;
  Meters turn_radius{3.0};
  HomePoint home;
  std::vector<WatchedObject> objects;
  Coverage coverage;
  double travelled = 0.0;  ///< path since the helm first decided [m]
  /// Path that the battery allows from now on, way home and reserve kept; absent: nobody says.
  std::optional<Meters> reach{};
  /// Where the survey goes on when this ground is done, NED [m]; absent: it is over then.
  std::optional<PlanePoint> onward_W{};
  CourseCost course_cost{};  ///< in the current there is

  /// Where the way leads when this ground is done: on, or home.
  [[nodiscard]] PlanePoint next() const {
    return onward_W.value_or(PlanePoint(home.north, home.east));
  }
};

/// An option with what it would newly show.
struct Prospect {
  const Option* option = nullptr;
  NewlySeen seen;  ///< by its whole motion, the plan's part included
  DubinsPath own{};

  Prospect(const Option& of, const NewlySeen& shown)
      : option(&of), seen(shown), own(of.path.Prefix(of.own_length())) {}

  /// What the option itself offers to fly next.
  [[nodiscard]] const DubinsPath& path() const { return own; }
  [[nodiscard]] double length() const { return own.length(); }
  /// The path with all that would follow to the end of the survey, if the option was completed;
  /// else path().
  [[nodiscard]] const DubinsPath& whole() const { return option->path; }
};

/// A place where paths may end for good.
struct Destination {
  double north = 0.0, east = 0.0;  ///< NED [m]
};

/// What the running behaviors want options for.
struct SearchGoals {
  Objective objective{};
  std::vector<Destination> destinations{};  ///< e.g. home
  bool leads_into_region = false;  ///< a vehicle outside the operating region is to come in
};

}  // namespace limpet

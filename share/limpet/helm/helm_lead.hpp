// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "limpet/core/message.hpp"
#include "limpet/helm/motion_decision.hpp"
#include "limpet/planning/dubins_path.hpp"

namespace limpet {

/// The variables in which behaviors of the helm that is led take updates; one that is empty is not
/// told.
struct LeadVariables {
  std::string waypoints;  ///< of its BHV_Waypoint; empty: nobody is led
  std::string depth;      ///< of its BHV_ConstantDepth
  std::string course;     ///< of its BHV_ConstantHeading, while there is no way
  std::string speed;      ///< of its BHV_ConstantSpeed, likewise
};

/// Steers by way of another helm in the same community: tells its behaviors, by updates, which way
/// to go, how fast and how deep, and says in HELM_LEAD which of them are to steer.
class HelmLead {
 public:
  using Post = std::function<void(std::string variable, Value value)>;
  HelmLead(LeadVariables variables, Post post)
      : variables_(std::move(variables)), post_(std::move(post)) {}

  [[nodiscard]] bool leads() const { return !variables_.waypoints.empty(); }
  /// A path was chosen: it is told with the next `Steer`.
  void Follow(const DubinsPath& path) { new_path_ = path; }
  /// Once per iteration: what is new of way, or course, and of speed and depth.
  void Steer(bool has_path, const MotionDecision& motion);
  /// Nobody wants anything of the vehicle, or all is to stop: no way, and up.
  void Stop();

 private:
  /// What was told last of one number.
  struct Told {
    const char* key;  ///< of the behavior's block
    double step;      ///< what is worth an update
    std::optional<double> value{};
  };
  void TellWay(const std::optional<double>& speed);
  void Tell(const std::string& variable, Told& told, double value);
  void TellState(const std::string& state);

  LeadVariables variables_;
  Post post_;
  std::optional<DubinsPath> new_path_;  ///< not told yet
  std::string told_state_;
  std::optional<double> told_way_speed_;  ///< [m/s]
  Told depth_{"depth", 0.05}, speed_{"speed", 0.01};
  Told course_{"heading", 0.5};  ///< [deg] as MOOS has it
};

/// Points of a path for a follower of way points [m, x east, y north]: its start, ends of straight
/// legs, and arcs by chords that leave them by at most 0.1 m.
[[nodiscard]] std::string WaypointsText(const DubinsPath& path);

}  // namespace limpet

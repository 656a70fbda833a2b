// SPDX-License-Identifier: MIT
// A point in the plane that a behavior file steers: behaviors, host and decision as the helm has
// them, on a vehicle whose turns, speeds and depths are limited in their rates.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "limpet/core/frames.hpp"
#include "limpet/helm/behavior_host.hpp"
#include "limpet/helm/flag_macros.hpp"
#include "limpet/helm/motion_decision.hpp"
#include "limpet/mission/behavior_file.hpp"

namespace limpet {

/// A post as `NAME=value`, with its time.
struct FlownPost {
  double time = 0.0;
  std::string variable, value;
};

class HelmFlight {
 public:
  explicit HelmFlight(const std::string& behaviors)
      : host_({ParseBehaviors(behaviors, "flight.bhv")}) {
    domain_.speed_high = 5.0;
    state_.now = Seconds(1000.0);
    state_.ownship = "alpha";
    state_.heard = &host_.heard();
    for (const HelmPost& post : host_.InitialPosts())
      Take(post);
  }

  void Say(const std::string& variable, const Value& value) {
    host_.SetVariable(variable, value, state_.now);
  }
  void PlaceAt(double x, double y, double heading_deg) {
    state_.nav.east = x, state_.nav.north = y, state_.nav.yaw = YawFromMoosHeading(heading_deg);
  }
  /// One iteration of a tenth of a second.
  void Tick() {
    for (const HelmPost& post : host_.Update(state_))
      Take(post);
    decision_ = DecideMotion(host_.running(), state_, domain_);
    const std::vector<std::string_view> active(decision_.active.begin(), decision_.active.end());
    const auto posts = host_.Settle({.turns = decision_.turns, .active = active}, state_);
    for (const HelmPost& post : posts)
      Take(post);
    Fly();
  }
  void Fly(double seconds) {
    for (int i = 0; i < static_cast<int>(std::lround(10.0 * seconds)); ++i)
      Tick();
  }
  /// False if it was not so within the time.
  bool FlyUntil(const std::function<bool()>& is_done, double seconds) {
    for (int i = 0; i < static_cast<int>(std::lround(10.0 * seconds)); ++i) {
      Tick();
      if (is_done()) return true;
    }
    return false;
  }

  [[nodiscard]] double x() const { return state_.nav.east; }
  [[nodiscard]] double y() const { return state_.nav.north; }
  [[nodiscard]] double depth() const { return state_.nav.down; }
  [[nodiscard]] double speed() const { return state_.nav.u; }
  [[nodiscard]] double heading_deg() const { return MoosHeadingFromYaw(state_.nav.yaw); }
  [[nodiscard]] double time() const { return state_.now.value() - 1000.0; }
  [[nodiscard]] double travelled() const { return travelled_; }
  [[nodiscard]] const MotionDecision& decision() const { return decision_; }
  [[nodiscard]] BehaviorHost& host() { return host_; }
  VehicleState& state() { return state_; }
  /// All values posted of a variable, in order.
  [[nodiscard]] std::vector<std::string> Posts(const std::string& variable) const {
    std::vector<std::string> values;
    for (const FlownPost& post : posts_) {
      if (post.variable == variable) values.push_back(post.value);
    }
    return values;
  }
  /// Names of these variables in the order in which they were posted.
  [[nodiscard]] std::vector<std::string> OrderOf(const std::vector<std::string>& variables) const {
    std::vector<std::string> names;
    for (const FlownPost& post : posts_) {
      if (std::ranges::find(variables, post.variable) != variables.end()) {
        names.push_back(post.variable);
      }
    }
    return names;
  }
  [[nodiscard]] std::string Last(const std::string& variable) const {
    const std::vector<std::string> values = Posts(variable);
    return values.empty() ? "" : values.back();
  }

  double turn_rate = 0.35;    ///< [rad/s]
  double acceleration = 0.5;  ///< [m/s^2]
  double depth_rate = 0.3;    ///< [m/s]

 private:
  void Take(const HelmPost& post) {
    const auto* number = std::get_if<double>(&post.value);
    posts_.push_back(
        {time(), post.variable,
         number != nullptr ? MacroNumber(*number) : std::get<std::string>(post.value)});
    Say(post.variable, post.value);  // as the database does
  }
  void Fly() {
    constexpr double kStep = 0.1;
    const double course = decision_.course.value_or(state_.nav.yaw);
    const double turn = WrapAngle(course - state_.nav.yaw);
    state_.nav.yaw =
        WrapAngle(state_.nav.yaw + std::clamp(turn, -turn_rate * kStep, turn_rate * kStep));
    const double wanted = decision_.speed.value_or(0.0);
    state_.nav.u += std::clamp(wanted - state_.nav.u, -acceleration * kStep, acceleration * kStep);
    const double sink = decision_.depth.value_or(0.0) - state_.nav.down;
    state_.nav.down += std::clamp(sink, -depth_rate * kStep, depth_rate * kStep);
    state_.nav.north += kStep * state_.nav.u * std::cos(state_.nav.yaw);
    state_.nav.east += kStep * state_.nav.u * std::sin(state_.nav.yaw);
    travelled_ += kStep * state_.nav.u;
    state_.now += Seconds(kStep);
  }

  BehaviorHost host_;
  MotionDomain domain_;
  VehicleState state_;
  MotionDecision decision_;
  std::vector<FlownPost> posts_;
  double travelled_ = 0.0;
};

}  // namespace limpet

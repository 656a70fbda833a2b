// SPDX-License-Identifier: MIT
#include "limpet/helm/helm_lead.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "limpet/core/decimal_text.hpp"
#include "limpet/core/frames.hpp"
#include "limpet/helm/path_chords.hpp"
#include "limpet/topics/mission.hpp"
#include "limpet/waypoints/point_list.hpp"

namespace limpet {
namespace {

constexpr double kWaySagitta = 0.1;  ///< [m] by which way points may cut a turn

bool Differs(const std::optional<double>& told, double value, double step) {
  return !told || std::abs(value - *told) >= step;
}

}  // namespace

std::string WaypointsText(const DubinsPath& path) {
  return PointsText(MapPointsOf(path, kWaySagitta));
}

void HelmLead::Steer(bool has_path, const MotionDecision& motion) {
  if (motion.depth) Tell(variables_.depth, depth_, *motion.depth);
  if (has_path) {
    TellWay(motion.speed);
    TellState("way");
    return;
  }
  new_path_.reset();
  const bool hears_courses = !variables_.course.empty() && !variables_.speed.empty();
  if (hears_courses && motion.course && motion.speed) {
    Tell(variables_.course, course_, MoosHeadingFromYaw(*motion.course));
    Tell(variables_.speed, speed_, *motion.speed);
    TellState("course");
  } else {
    TellState("hold");
  }
}

void HelmLead::TellWay(const std::optional<double>& speed) {
  constexpr double kStep = 0.01;  // [m/s]
  const bool is_new_speed = speed && Differs(told_way_speed_, *speed, kStep);
  if (!new_path_ && !is_new_speed) return;
  std::string text;
  if (new_path_) text = "points = " + WaypointsText(*std::exchange(new_path_, std::nullopt));
  if (speed) {
    text += (text.empty() ? "" : " # ") + fmt::format("speed = {}", DecimalText(*speed, 3));
    told_way_speed_ = speed;
  }
  post_(variables_.waypoints, std::move(text));
}

void HelmLead::Tell(const std::string& variable, Told& told, double value) {
  if (variable.empty() || !Differs(told.value, value, told.step)) return;
  told.value = value;
  post_(variable, fmt::format("{} = {}", told.key, DecimalText(value, 2)));
}

void HelmLead::TellState(const std::string& state) {
  if (told_state_ == state) return;
  told_state_ = state;
  post_(topics::kHelmLead.name, state);
}

void HelmLead::Stop() {
  new_path_.reset();
  TellState("none");
  Tell(variables_.depth, depth_, 0.0);
}

}  // namespace limpet

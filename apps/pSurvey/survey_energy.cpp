// SPDX-License-Identifier: MIT
// What the battery allows.
#include <algorithm>
#include <cmath>
#include <utility>

#include "apps/pSurvey/survey_app.hpp"
#include "limpet/vehicle_file/vehicle_file.hpp"

namespace limpet {
namespace {

/// Plans are weighed anew when what a metre takes has changed by so much somewhere.
constexpr double kNoticeable = 0.03;

bool DiffersNoticeably(const CourseCost& a, const CourseCost& b) {
  return !std::ranges::equal(a.metres, b.metres, [](double one, double other) {
    return std::abs(one - other) <= kNoticeable;
  });
}

}  // namespace

void SurveyApp::MakeEnergyEstimate() {
  const std::string named = context().Global(kVehicleFileGlobal);
  if (named.empty()) return;  // a mission that says of no vehicle what it is
  const VehicleFile vehicle = LoadMissionVehicle(named, context().mission_folder);
  if (!vehicle.battery.is_present) return;
  energy_.emplace(vehicle.params, vehicle.battery);
  SubscribeIfWritten(topics::kBattery, &SurveyApp::OnBattery);
  SubscribeIfWritten(topics::kNavCurrent, &SurveyApp::OnCurrent);
}

void SurveyApp::OnNav(const Stamped<NavState>& nav) {
  if (!nav.value.is_usable()) return;
  nav_ = nav;
  if (energy_) energy_->Hear(nav.value, nav.time);
}

void SurveyApp::OnBattery(const Stamped<BatteryState>& battery) {
  energy_->Hear(battery.value, battery.time);
  const bool is_place_known = nav_ && home_;
  const std::optional<EnergyState> state =
      energy_->At({.distance = Meters(is_place_known ? DistanceHome() : 0.0),
                   .depth = Meters(nav_ ? nav_->value.down : 0.0),
                   .at_surface = params_.last_fix,
                   .reserve_share = 0.01 * params_.energy_reserve_percent,
                   .course = is_place_known ? CourseHome() : 0.0});
  energy_state_ = state;
  Publish(topics::kEnergyState, *state);
}

void SurveyApp::OnCurrent(const Stamped<WaterCurrent>& current) {
  energy_->Hear(current.value);
  CourseCost costs = energy_->CostsByCourse();
  if (!DiffersNoticeably(costs, course_cost_)) return;
  course_cost_ = std::move(costs);
  Publish(topics::kCourseCost, course_cost_);
}

}  // namespace limpet

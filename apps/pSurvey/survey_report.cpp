// SPDX-License-Identifier: MIT
// What an operator sees of the mission.
#include <algorithm>

#include <fmt/format.h>

#include "apps/pSurvey/survey_app.hpp"

namespace limpet {

/// Time to the target by the mean rate of coverage so far. The last few percent take longer than
/// that says.
std::optional<Seconds> SurveyApp::TimeToTarget() const {
  const double seconds = (now() - phase_since_).value();
  const double share = CoveredShare(coverage_);
  if (phase_ != SurveyPhase::kSurvey || share < 0.05 || seconds <= 0.0) {
    return std::nullopt;
  }
  return Seconds(std::max(0.0, params_.coverage_target - share) * seconds / share);
}

void SurveyApp::Report(ReportLines& report) const {
  report.Pair("Phase",
              fmt::format("{} for {:.0f} s", NameOf(phase_), (now() - phase_since_).value()));
  report.Pair("Area", fmt::format("{}north {:g} to {:g}, east {:g} to {:g} m, margin {:g} m",
                                  area_.outline ? "a polygon within " : "", area_.north_min,
                                  area_.north_max, area_.east_min, area_.east_max, area_.margin));
  if (deployed_) {
    report.Pair("Under way", fmt::format("{:.0f} s of at most {:.0f} s",
                                         (now() - *deployed_).value(), params_.max_time.value()));
  }
  report.Pair("Covered", fmt::format("{:.1f} % of {:.1f} % ({})", 100.0 * CoveredShare(coverage_),
                                     100.0 * params_.coverage_target, params_.coverage_kind));
  if (phase_ == SurveyPhase::kSurvey && transit_.is_under_way()) {
    report.Pair("Transit", fmt::format("{:.0f} m to the area", transit_.to_go_m()));
  }
  const auto left = TimeToTarget();
  report.Pair("To go", left ? fmt::format("about {:.0f} s at the mean rate so far", left->value())
                            : "not known");
  report.Pair("Objects",
              fmt::format("{}, {} still want a look", revisits_.objects.size(), OpenRevisits()));
  if (home_ && nav_) {
    report.Pair("Home", fmt::format("north {:.1f}, east {:.1f} m, {:.1f} m away", home_->north,
                                    home_->east, DistanceHome()));
  }
  if (energy_state_) {
    const EnergyState& energy = *energy_state_;
    report.Pair("Energy",
                fmt::format("{:.0f} Wh left, {:.0f} to go home and {:.0f} in reserve; {:.0f} used",
                            energy.left_wh, energy.home_wh, energy.reserve_wh, energy.used_wh));
  }
  if (!course_cost_.metres.empty()) {
    const auto [least, most] = std::ranges::minmax(course_cost_.metres);
    report.Pair("Current", fmt::format("a metre takes {:.2f} to {:.2f} of one in still water, by "
                                       "course",
                                       least, most));
  }
  if (phase_ == SurveyPhase::kDone) {
    report.Pair("Ended", ended_);
  }
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
// The area may be set by the operator until the vehicle dives.
#include <utility>

#include <fmt/format.h>

#include "apps/pSurvey/area_request.hpp"
#include "apps/pSurvey/survey_app.hpp"
#include "apps/pSurvey/survey_warnings.hpp"
#include "limpet/core/number_text.hpp"
#include "limpet/survey/grid_frame.hpp"
#include "limpet/topics/area_request.hpp"

namespace limpet {

bool SurveyApp::IsAtSurface() const {
  const bool is_before_the_dive = phase_ == SurveyPhase::kIdle || phase_ == SurveyPhase::kAlign;
  return is_before_the_dive && (!nav_ || nav_->value.down < params_.surface_depth.value());
}

void SurveyApp::OnAreaRequest(const Stamped<std::string>& request) {
  const std::string hash = HashOfRequest(request.value);
  AreaSetting setting{.area = area_, .params = params_};
  setting.object_radius = Meters(ParseNumber(context().Global("object_radius_m")).value_or(0.0));
  if (nav_) setting.vehicle_W.emplace(nav_->value.north, nav_->value.east);
  Expected<SurveyArea> area =
      IsAtSurface() ? AreaRequested(request.value, setting)
                    : Expected<SurveyArea>(Error{fmt::format(
                          "the area can be set at the surface before the dive alone; phase {}",
                          NameOf(phase_))});
  if (!area) {
    ReportEvent(events::kAreaRequest, "refused: " + area.error().text);
    Publish(
        topics::kSurveyAreaAnswer,
        SurveyAreaAnswer{.hash = hash, .is_accepted = false, .why = "{" + area.error().text + "}"});
    return;
  }
  SetArea(*std::move(area));
  ReportEvent(events::kAreaRequest, "accepted: " + hash);
  Publish(topics::kSurveyAreaAnswer, SurveyAreaAnswer{.hash = hash, .is_accepted = true});
  PublishArea();
  Remember();
}

void SurveyApp::RecallArea(const std::string& kept) {
  if (kept.size() < 2) return;
  const auto area = DecodeRecord<SurveyArea>(kept.substr(1, kept.size() - 2));
  if (area && !ProblemOf(*area)) SetArea(*area);
}

void SurveyApp::SetArea(SurveyArea area) {
  area_ = std::move(area);
  region_ = Region(area_);
  transit_ = Transit();
  coverage_ = Coverage();
  best_share_ = 0.0;
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "apps/pSurvey/survey_app.hpp"

#include <algorithm>
#include <cmath>

#include "limpet/app/registry.hpp"

namespace limpet {
namespace {

constexpr double kProgressStep = 0.002;  // coverage must grow by this much to count as progress

}  // namespace

SurveyApp::SurveyApp(const AppContext& context, const Params& params)
    : App(context), params_(params) {
  if (params.north_max <= params.north_min || params.east_max <= params.east_min) {
    throw ConfigError({{},
                       context.name,
                       "the area is empty: its north_max_m and east_max_m must exceed its minima"});
  }
  Subscribe(topics::kNavState, &SurveyApp::OnNav);
  Subscribe(topics::kDeploy, &SurveyApp::OnDeploy);
  Subscribe(topics::kReturn, &SurveyApp::OnReturn);
  Subscribe(topics::kMapCoverage, &SurveyApp::OnCoverage);
  Subscribe(topics::kMapOpis, &SurveyApp::OnOpis);
}

void SurveyApp::OnDeploy(const Stamped<bool>& deploy) {
  if (deploy.value && phase_ == Phase::kIdle) {
    deployed_ = deploy.time;
    Publish(topics::kSurveyArea,
            SurveyArea{.north_min = params_.north_min.value(),
                       .north_max = params_.north_max.value(),
                       .east_min = params_.east_min.value(),
                       .east_max = params_.east_max.value(),
                       .margin = params_.margin.value(),
                       .object_height_max = params_.object_height_max.value()});
    Enter(Phase::kAlign, deploy.time);
  }
}

void SurveyApp::OnReturn(const Stamped<bool>& request) {
  const bool is_under_way = phase_ == Phase::kDive || phase_ == Phase::kSurvey;
  if (request.value && is_under_way) {
    GoHome("operator asked", "aborted", request.time);
  }
}

double SurveyApp::CoveredShare(const Coverage& coverage) const {
  if (params_.coverage_kind == "seabed") {
    return coverage.seabed;
  }
  return params_.coverage_kind == "band" ? coverage.band : coverage.band_top;
}

void SurveyApp::OnCoverage(const Stamped<Coverage>& coverage) {
  coverage_ = coverage.value;
  if (CoveredShare(coverage_) > best_share_ + kProgressStep) {
    best_share_ = CoveredShare(coverage_);
    last_progress_ = coverage.time;
  }
}

bool SurveyApp::WantsRevisit(const OpiBelief& opi) const {
  return opi.entropy > params_.settled_entropy && opi.looks < params_.settled_looks;
}

bool SurveyApp::HasOpenRevisit() const {
  return std::ranges::any_of(opis_.opis,
                             [this](const OpiBelief& opi) { return WantsRevisit(opi); });
}

double SurveyApp::DistanceHome() const {
  return std::hypot(nav_->north - home_->north, nav_->east - home_->east);
}

const char* SurveyApp::NameOf(Phase phase) {
  static constexpr const char* kNames[] = {"IDLE",   "ALIGN",  "DIVE", "SURVEY",
                                           "RETURN", "ASCEND", "FIX",  "DONE"};
  return kNames[static_cast<int>(phase)];
}

void SurveyApp::Enter(Phase phase, Seconds now) {
  phase_ = phase;
  phase_since_ = now;
  last_progress_ = now;
  ReportEvent(std::string("phase ") + NameOf(phase));
  Publish(topics::kSurveyPhase, std::string(NameOf(phase)));
}

void SurveyApp::GoHome(const std::string& reason, const std::string& ended, Seconds now) {
  ended_ = ended;
  ReportEvent("going home: " + reason);
  Publish(topics::kSessionSave, reason);
  Enter(Phase::kReturn, now);
}

void SurveyApp::AlignAtSurface(Seconds now) {
  if (now - phase_since_ < params_.align) {
    return;
  }
  home_ = HomePoint{.north = nav_->north, .east = nav_->east};
  Publish(topics::kSurveyHome, *home_);
  Enter(Phase::kDive, now);
}

void SurveyApp::Survey(Seconds now) {
  if (CoveredShare(coverage_) >= params_.coverage_target && !HasOpenRevisit()) {
    GoHome("coverage target reached", "home", now);
  } else if (now - *deployed_ > params_.max_time) {
    GoHome("out of time", "timeout", now);
  } else if (now - last_progress_ > params_.stall) {
    Warn("COVERAGE_STALLED", "coverage has not grown for stall_s; going home short of the target");
    GoHome("coverage stalled", "timeout", now);
  }
}

void SurveyApp::EndMission(Seconds now) {
  Enter(Phase::kDone, now);
  Publish(topics::kSessionSave, std::string("mission ended"));
  Publish(topics::kMissionEnd, ended_);
}

void SurveyApp::Tick(Seconds now) {
  if (!nav_) {
    return;
  }
  switch (phase_) {
    case Phase::kIdle:
    case Phase::kDone:
      break;
    case Phase::kAlign:
      AlignAtSurface(now);
      break;
    case Phase::kDive: {
      const bool is_at_altitude =
          nav_->altitude &&
          std::abs(*nav_->altitude - params_.altitude.value()) < params_.altitude_tolerance.value();
      if (is_at_altitude) {
        Enter(Phase::kSurvey, now);
      }
      break;
    }
    case Phase::kSurvey:
      Survey(now);
      break;
    case Phase::kReturn:
      if (DistanceHome() < params_.home_radius.value()) {
        Enter(Phase::kAscend, now);
      }
      break;
    case Phase::kAscend:
      if (nav_->down < params_.surface_depth.value()) {
        Enter(Phase::kFix, now);
      }
      break;
    case Phase::kFix:
      if (now - phase_since_ >= params_.last_fix) {
        EndMission(now);
      }
      break;
  }
}

LIMPET_REGISTER_APP(SurveyApp, "pSurvey", 4.0);

}  // namespace limpet

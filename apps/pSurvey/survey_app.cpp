// SPDX-License-Identifier: MIT
#include "apps/pSurvey/survey_app.hpp"

#include <algorithm>
#include <cmath>

#include "apps/pSurvey/fix_wait.hpp"
#include "apps/pSurvey/survey_memory.hpp"
#include "apps/pSurvey/survey_warnings.hpp"
#include "limpet/app/registry.hpp"
#include "limpet/planning/home_path.hpp"
#include "limpet/survey/grid_frame.hpp"
#include "limpet/survey/look.hpp"
#include "limpet/survey/mission_area.hpp"
#include "limpet/survey/survey_grid.hpp"
#include "limpet/topics/area_request.hpp"

namespace limpet {
namespace {

/// Live, the database and whoever listens may have been started again meanwhile.
constexpr Seconds kTellPeriod(10.0);
/// Coverage must grow by this share to count as progress, or by so much of a large area.
constexpr double kProgressShare = 0.002, kProgress_m2 = 200.0;
/// Where this water shows so little that nothing is planned for, what is seen is by chance: so much
/// is to come of it in `stall_s`.
constexpr double kChanceShare = 0.1;
/// Coverage falls by so much when the water turns out murkier: what comes then is new.
constexpr double kTakenBack = 0.05;

SurveyArea AreaOrThrow(const SurveyParams& params, const AppContext& context) {
  Expected<SurveyArea, AreaProblem> area =
      AreaOf(params, {.folder = context.mission_folder,
                      .latitude = context.Global("LatOrigin"),
                      .longitude = context.Global("LongOrigin")});
  if (!area) throw ConfigError({{}, area.error().key, area.error().text});
  if (const auto problem = ProblemOf(*area)) {
    throw ConfigError({{}, "area", "the area " + *problem});
  }
  return *std::move(area);
}

}  // namespace

SurveyApp::SurveyApp(const AppContext& context, const Params& params)
    : App(context),
      params_(params),
      area_(AreaOrThrow(params, context)),
      region_(area_),
      keeper_(context.run_folder, *context.disk, context.runs_live) {
  if (context.is_restarted) {
    Recall();  // first: a DEPLOY that is known already must not start the mission anew
  }
  MakeEnergyEstimate();
  Subscribe(topics::kNavState, &SurveyApp::OnNav);
  Subscribe(topics::kDeploy, &SurveyApp::OnDeploy);
  Subscribe(topics::kReturn, &SurveyApp::OnReturn);
  Subscribe(topics::kSurveyAreaRequest, &SurveyApp::OnAreaRequest);
  SubscribeIfWritten(topics::kSafetyAction, &SurveyApp::OnSafety);
  Subscribe(topics::kMapCoverage, &SurveyApp::OnCoverage);
  Subscribe(topics::kMapLook, &SurveyApp::OnLook);
  Subscribe(topics::kMissionEnd, &SurveyApp::OnMissionEnd);
  Subscribe(topics::kHelmRevisits, &SurveyApp::OnRevisits);
  SubscribeIfWritten(topics::kHelmPath, &SurveyApp::OnPath);
  SubscribeIfWritten(topics::kHelmGivesUp, &SurveyApp::OnGivesUp);
  Subscribe(topics::kHelmState, &SurveyApp::OnHelmState);
  Subscribe(topics::kHelmAllStop, &SurveyApp::OnAllStop);
  SubscribeIfWritten(topics::kSessionPrior, &SurveyApp::OnPrior);
}

void SurveyApp::OnDeploy(const Stamped<bool>& deploy) {
  if (deploy.value && phase_ == SurveyPhase::kIdle) {
    deployed_ = deploy.time;
    PublishArea();
    Enter(SurveyPhase::kAlign, deploy.time);
  }
}

void SurveyApp::PublishArea() { Publish(topics::kSurveyArea, area_); }

void SurveyApp::Remember() {
  if (!context().runs_live) {
    return;
  }
  SurveyMemory memory{.phase = std::string(NameOf(phase_)),
                      .phase_since = phase_since_.value(),
                      .deployed = deployed_.value_or(Seconds(0.0)).value(),
                      .home_north = {},
                      .home_east = {},
                      .ended = ended_,
                      .area = "{" + EncodeRecord(area_) + "}"};
  if (home_) {
    memory.home_north = home_->north;
    memory.home_east = home_->east;
  }
  keeper_.Keep(memory);
}

void SurveyApp::TellWhatIsKept(Seconds now) {
  const std::optional<SurveyKeeper::Outcome> outcome = keeper_.TakeOutcome();
  if (outcome && outcome->trouble) {
    Warn(warnings::kStateNotKept, outcome->trouble->text);
    not_kept_ = now;
  } else if (outcome) {
    ClearWarning(warnings::kStateNotKept);
    not_kept_.reset();
  } else if (not_kept_ && now - *not_kept_ > kTellPeriod) {
    not_kept_ = now;
    Remember();
  }
}

void SurveyApp::Recall() {
  const std::optional<SurveyMemory> memory = RecallSurvey(context().run_folder);
  if (memory && memory->area) RecallArea(*memory->area);
  const SurveyPhase phase =
      memory ? SurveyPhaseOf(memory->phase).value_or(SurveyPhase::kIdle) : SurveyPhase::kIdle;
  if (!memory || phase == SurveyPhase::kIdle) {
    return;  // never deployed
  }
  phase_ = phase;
  phase_since_ = Seconds(memory->phase_since);
  deployed_ = Seconds(memory->deployed);
  last_progress_ = now();
  ended_ = memory->ended;
  if (memory->home_north && memory->home_east) {
    home_ = HomePoint{.north = *memory->home_north, .east = *memory->home_east};
  }
  TellAgain(now());
  // The former life may have ended with the mission, before anybody heard of it.
  if (phase_ == SurveyPhase::kDone) Publish(topics::kMissionEnd, ended_);
}

void SurveyApp::TellAgain(Seconds now) {
  told_ = now;
  PublishArea();
  if (home_) {
    Publish(topics::kSurveyHome, *home_);
  }
  Publish(topics::kSurveyPhase, std::string(NameOf(phase_)));
}

void SurveyApp::OnReturn(const Stamped<bool>& request) {
  if (!request.value) {
    return;
  }
  switch (phase_) {
    case SurveyPhase::kIdle:
    case SurveyPhase::kDone:
      ReportEvent(events::kReturnRequest, "RETURN is left out: no mission is under way");
      break;
    case SurveyPhase::kAlign:  // still at the surface: there it is to stay
      ended_ = "aborted";
      ReportEvent(events::kReturnRequest, "asked to return before the dive");
      EndMission(request.time);
      break;
    case SurveyPhase::kDive:
    case SurveyPhase::kSurvey:
      GoHome("asked to return", "aborted", request.time);
      break;
    case SurveyPhase::kReturn:
    case SurveyPhase::kAscend:
    case SurveyPhase::kFix:
      ReportEvent(events::kReturnRequest, "RETURN: on the way home already");
      break;
  }
}

void SurveyApp::OnSafety(const Stamped<std::string>& action) {
  const SafetyAction asked = SafetyActionNamed(action.value).value_or(SafetyAction::kNone);
  if (asked < SafetyAction::kSurface || !IsUnderWay()) {
    return;
  }
  ended_ = "aborted";
  if (phase_ == SurveyPhase::kAlign) {
    EndMission(action.time);
  } else if (phase_ != SurveyPhase::kAscend && phase_ != SurveyPhase::kFix) {
    ReportEvent(events::kSurfacing, "SAFETY_ACTION is " + action.value);
    Publish(topics::kSessionSave, "safety: " + action.value);
    Enter(SurveyPhase::kAscend, action.time);
  }
}

void SurveyApp::OnMissionEnd(const Stamped<std::string>& end) {
  if (IsUnderWay()) {
    ended_ = end.value;
    ReportEvent(events::kMissionEnd, ended_);
    Enter(SurveyPhase::kDone, now());
  }
}

double SurveyApp::CoveredShare(const Coverage& coverage) const {
  // What plans take for done, since no path is planned to the rest.
  if (params_.coverage_kind == "seabed") {
    return coverage.done_seabed.value_or(coverage.seabed);
  }
  return params_.coverage_kind == "band" ? coverage.done_band.value_or(coverage.band)
                                         : coverage.done_band_top.value_or(coverage.band_top);
}

void SurveyApp::OnPath(const Stamped<HelmPath>& path) {
  if (phase_ == SurveyPhase::kSurvey && path.value.purpose == kHomeSource) {
    GoHome("no more than the way home is in reach", "timeout", now());
  }
}

double SurveyApp::ProgressStep() const {
  if (!(AttainableShare() > 0.0)) return kChanceShare;
  const double extent = (area_.north_max - area_.north_min) * (area_.east_max - area_.east_min);
  return std::min(kProgressShare, kProgress_m2 / extent);
}

void SurveyApp::OnCoverage(const Stamped<Coverage>& coverage) {
  coverage_ = coverage.value;
  if (CoveredShare(coverage_) < best_share_ - kTakenBack) best_share_ = CoveredShare(coverage_);
  if (CoveredShare(coverage_) > best_share_ + ProgressStep()) {
    best_share_ = CoveredShare(coverage_);
    last_progress_ = now();
  }
}

void SurveyApp::OnLook(const Stamped<MapLook>& look) {
  const LookModel model = ToLookModel(look.value);
  footprint_.emplace(SurveyHeights{.altitude = params_.altitude.value(),
                                   .object_height_max = params_.object_height_max.value()},
                     model.camera, HalfRange(model.detection));
}

double SurveyApp::AttainableShare() const {
  const int lowest = footprint_ ? footprint_->widest_layer() : 0;
  if (!footprint_ || (lowest == 0 && footprint_->is_in_reach(0))) {
    return 1.0;
  }
  const bool is_any_in_reach = lowest > 0;
  if (params_.coverage_kind == "band_top") {
    return is_any_in_reach ? 1.0 : 0.0;
  }
  if (params_.coverage_kind == "seabed" || !is_any_in_reach) {
    return 0.0;
  }
  const double top = params_.object_height_max.value();
  const double bottom = std::min(SurveyGrid::kObjectRadius, top);
  return top > bottom ? (top - std::max(bottom, footprint_->height(lowest))) / (top - bottom) : 1.0;
}

std::ptrdiff_t SurveyApp::OpenRevisits() const {
  return std::ranges::count(revisits_.objects, "open", &RevisitInterest::state);
}

double SurveyApp::DistanceHome() const {
  return std::hypot(nav_->value.north - home_->north, nav_->value.east - home_->east);
}

double SurveyApp::CourseHome() const {
  return std::atan2(home_->east - nav_->value.east, home_->north - nav_->value.north);
}

void SurveyApp::Enter(SurveyPhase phase, Seconds now) {
  phase_ = phase;
  phase_since_ = now;
  last_progress_ = now;
  ReportEvent(events::kPhase, std::string(NameOf(phase)));
  Publish(topics::kSurveyPhase, std::string(NameOf(phase)));
  Remember();
}

void SurveyApp::GoHome(const std::string& reason, const std::string& ended, Seconds now) {
  ended_ = ended;
  ReportEvent(events::kGoingHome, reason);
  Publish(topics::kSessionSave, reason);
  Enter(SurveyPhase::kReturn, now);
}

void SurveyApp::AlignAtSurface(Seconds now) {
  if (!FixWait::BeforeDive(params_, has_former_).IsOver(now - phase_since_, nav_->value)) {
    return;
  }
  home_ = HomePoint{.north = nav_->value.north, .east = nav_->value.east};
  Publish(topics::kSurveyHome, *home_);
  Enter(SurveyPhase::kDive, now);
}

void SurveyApp::TrackTransit(Seconds now) {
  if (transit_.is_over()) {
    return;
  }
  const bool was_outside = transit_.is_under_way();
  if (transit_.Track(nav_->value, region_)) {
    last_progress_ = now;
  }
  if (was_outside && transit_.is_over()) {
    ReportEvent(events::kAreaReached, "the area is reached");
  }
}

void SurveyApp::EndMission(Seconds now) {
  ReportEvent(events::kMissionEnd, ended_);
  Enter(SurveyPhase::kDone, now);
  Publish(topics::kSessionSave, std::string("mission ended"));
  Publish(topics::kMissionEnd, ended_);
}

bool SurveyApp::IsUnderWay() const {
  return phase_ != SurveyPhase::kIdle && phase_ != SurveyPhase::kDone;
}

bool SurveyApp::EndsHopeless(Seconds now) {
  const Seconds heard = std::max(nav_ ? nav_->time : phase_since_, *deployed_);
  const bool is_passage = phase_ == SurveyPhase::kDive || phase_ == SurveyPhase::kReturn ||
                          phase_ == SurveyPhase::kAscend;
  if (now - heard > params_.lost) {
    Warn(warnings::kNavLost, "no NAV_STATE within lost_s; the mission ends here");
    ended_ = "lost";
  } else if (is_passage && now - phase_since_ > params_.give_up) {
    Warn(warnings::kGaveUp, "diving, returning or ascending took longer than give_up_s");
    ended_ = "timeout";
  } else {
    return false;
  }
  EndMission(now);
  return true;
}

void SurveyApp::WatchHelm(Seconds now) {
  const auto complaint = IsUnderWay() ? helm_.Complaint(*deployed_, now) : std::nullopt;
  if (complaint) {
    Warn(warnings::kHelmInactive, *complaint);
  } else {
    ClearWarning(warnings::kHelmInactive);
  }
}

void SurveyApp::Tick(Seconds now) {
  WatchHelm(now);
  if (IsUnderWay() && !EndsHopeless(now) && nav_) {
    WalkOn(now);
  }
  if (context().runs_live && IsUnderWay() && now - told_ > kTellPeriod) {
    TellAgain(now);
  }
  TellWhatIsKept(now);
}

void SurveyApp::WalkOn(Seconds now) {
  switch (phase_) {
    case SurveyPhase::kIdle:
    case SurveyPhase::kDone:
      break;
    case SurveyPhase::kAlign:
      AlignAtSurface(now);
      break;
    case SurveyPhase::kDive: {
      const bool is_at_altitude =
          nav_->value.altitude && std::abs(*nav_->value.altitude - params_.altitude.value()) <
                                      params_.altitude_tolerance.value();
      if (is_at_altitude) {
        Enter(SurveyPhase::kSurvey, now);
        TrackTransit(now);
      }
      break;
    }
    case SurveyPhase::kSurvey:
      Survey(now);
      break;
    case SurveyPhase::kReturn:
      if (DistanceHome() < params_.home_radius.value()) {
        Enter(SurveyPhase::kAscend, now);
      }
      break;
    case SurveyPhase::kAscend:
      if (nav_->value.down < params_.surface_depth.value()) {
        Enter(SurveyPhase::kFix, now);
      }
      break;
    case SurveyPhase::kFix:
      if (FixWait::AtTheEnd(params_).IsOver(now - phase_since_, nav_->value)) {
        EndMission(now);
      }
      break;
  }
}

LIMPET_REGISTER_APP(SurveyApp, "pSurvey", 4.0);

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "apps/pHelm/helm_app.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "apps/pHelm/behavior_loading.hpp"
#include "apps/pHelm/helm_warnings.hpp"
#include "limpet/app/registry.hpp"
#include "limpet/core/clock.hpp"
#include "limpet/core/frames.hpp"
#include "limpet/helm/motion_domain.hpp"
#include "limpet/mission/shared_settings.hpp"
#include "limpet/survey/grid_frame.hpp"
#include "limpet/survey/survey_area_warnings.hpp"
#include "limpet/topics/viewer.hpp"

namespace limpet {
namespace {

/// Who listens hears of a helm that cannot be made, before its process ends.
template <class Make>
auto OrMalconfig(const AppContext& context, const HelmParams& params, const Make& make) {
  try {
    return make();
  } catch (const ConfigError&) {
    if (params.lead.empty()) {  // else the state is the other helm's
      context.link->Publish(topics::kHelmState.name, std::string("MALCONFIG"), "");
    }
    throw;
  }
}

MotionDomain DomainOf(const HelmParams& params) {
  std::vector<ConfigEntry> lines;
  for (const std::string& line : params.domain) {
    lines.push_back({.key = "domain", .value = line, .where = {.file = "pHelm", .line = 0}});
  }
  MotionDomain domain;
  const auto problems = ReadMotionDomain(lines, {.file = "pHelm", .line = 0}, domain);
  if (!problems.empty()) {
    throw ConfigError(problems);
  }
  return domain;
}

}  // namespace

HelmApp::HelmApp(const AppContext& context, const Params& params)
    : App(context),
      params_(params),
      ownship_(context.Global("Community")),
      host_(OrMalconfig(
          context, params,
          [&] { return BehaviorHost(LoadBehaviorFiles(context, params), ClockOf(context)); })),
      planner_(params.views, MakeRandom("views"), ClockOf(context)),
      arbiter_(OrMalconfig(context, params, [&] { return DomainOf(params); }), ClockOf(context),
               params.at_points),
      app_wait_(context.runs_live ? params.hold_on_app : std::vector<std::string>()),
      mail_skew_(params.ok_skew),
      journal_(params.domain,
               [this](std::string variable, Value value) {
                 // Those of a helm that is led are read as the vehicle's.
                 if (!lead_.leads()) PublishRaw(std::move(variable), std::move(value));
               }),
      drawing_(ownship_,
               [this](std::string variable, std::string text) {
                 PublishRaw(std::move(variable), std::move(text));
               }),
      lead_({.waypoints = params.lead,
             .depth = params.lead_depth,
             .course = params.lead_course,
             .speed = params.lead_speed},
            [this](std::string variable, Value value) {
              if (variable != topics::kHelmLead.name) led_answers_.Sent(variable, now());
              PublishRaw(std::move(variable), std::move(value));
            }) {
  is_parked_ = !params_.start_in_drive;
  made_at_ = now();
  is_restart_untold_ = context.is_restarted;
  SubscribeToNavigation();
  SubscribeToOverride();
  SubscribeIfWritten(topics::kSafetyAction, &HelmApp::OnSafety);
  HearSurvey();
  SubscribeRaw(topics::kHelmRejournal.name, [this](const MessagePtr&) { journal_.Rejournal(); });
  SubscribeRaw(topics::kHelmMapClear.name, [this](const MessagePtr&) { host_.ForgetPosts(); });
  SubscribeRaw(topics::kHelmRestart.name,
               [this](const MessagePtr& message) { OnRestart(*message); });
  if (lead_.leads()) {
    SubscribeRaw(topics::kHelmUpdateResult.name, [this](const MessagePtr& message) {
      if (const auto* text = std::get_if<std::string>(&message->value)) led_answers_.Hear(*text);
    });
  }
  SubscribeForBehaviors();
}

void HelmApp::HearSurvey() {
  // Behaviors that steer without a path need neither area nor map.
  const auto hear = [this, needs_it = host_.WantsView()](const auto& topic, auto handler) {
    needs_it ? Subscribe(topic, handler) : SubscribeIfWritten(topic, handler);
  };
  hear(topics::kSurveyArea, &HelmApp::OnArea);
  hear(topics::kSurveyHome, &HelmApp::OnHome);
  SubscribeIfWritten(topics::kEnergyState, &HelmApp::OnEnergy);
  SubscribeIfWritten(topics::kCourseCost, &HelmApp::OnCourseCost);
  hear(topics::kMapDelta, &HelmApp::OnDelta);
  hear(topics::kMapCoverage, &HelmApp::OnCoverage);
  hear(topics::kMapOpis, &HelmApp::OnOpis);
  SubscribeIfWritten(topics::kMapObstacles, &HelmApp::OnObstacles);
  hear(topics::kMapLook, &HelmApp::OnLook);
}

void HelmApp::SubscribeToNavigation() {
  using Quantity = StockNav::Quantity;
  Subscribe(topics::kNavState, &HelmApp::OnNav);
  SubscribeIfWritten(topics::kNavX, &HelmApp::OnStockNav<Quantity::kX>);
  SubscribeIfWritten(topics::kNavY, &HelmApp::OnStockNav<Quantity::kY>);
  SubscribeIfWritten(topics::kNavHeading, &HelmApp::OnStockNav<Quantity::kHeading>);
  SubscribeIfWritten(topics::kNavSpeed, &HelmApp::OnStockNav<Quantity::kSpeed>);
  SubscribeIfWritten(topics::kNavDepth, &HelmApp::OnStockNav<Quantity::kDepth>);
  SubscribeIfWritten(topics::kNavAltitude, &HelmApp::OnStockNav<Quantity::kAltitude>);
}

void HelmApp::TakeStockNav(Seconds now) {
  if (hears_nav_state_) return;
  // Under a time warp mail comes in bursts of real time.
  const Seconds grace = std::max(params_.nav_grace, Seconds(context().warp));
  nav_ = stock_nav_.At(now, grace, arbiter_.domain().depth.has_value());
}

void HelmApp::OnArea(const Stamped<SurveyArea>& area) {
  if (const auto problem = ProblemOf(area.value)) {
    Warn(warnings::kAreaRefused, "SURVEY_AREA " + *problem);
    return;
  }
  ClearWarning(warnings::kAreaRefused);
  if (planner_.SetArea(area.value) && context().is_restarted) {
    Publish(topics::kMapGridRequest, std::string("pHelm has been restarted"));
  }
  if (!planner_.survey().SeesWholeBand()) {
    Warn(
        warnings::kBandAboveView,
        fmt::format("objects {:g} m above the seabed cannot be covered from survey_altitude_m {:g}",
                    area.value.object_height_max, params_.views.survey_altitude.value()));
  } else {
    ClearWarning(warnings::kBandAboveView);
  }
  drawing_.DrawArea(area.value);
}

void HelmApp::OnObstacles(const Stamped<Obstacles>& obstacles) {
  planner_.SetObstacles(obstacles.value.obstacles);
  if (const int shapeless = planner_.survey().shapeless_obstacles(); shapeless > 0) {
    Warn(warnings::kObstacleRefused,
         fmt::format("{} of {} obstacles have no outline: nothing keeps off them", shapeless,
                     obstacles.value.obstacles.size()));
  } else {
    ClearWarning(warnings::kObstacleRefused);
  }
}

void HelmApp::OnSafety(const Stamped<std::string>& action) {
  safety_ = SafetyActionNamed(action.value).value_or(safety_);
}

bool HelmApp::IsOverruled() const {
  return safety_ == SafetyAction::kHold || safety_ >= SafetyAction::kSurface;
}

void HelmApp::OnHome(const Stamped<HomePoint>& home) {
  planner_.survey().SetHome(home.value);
  drawing_.DrawHome(home.value);
}

void HelmApp::Post(const std::vector<HelmPost>& posts) {
  for (const HelmPost& post : posts) {
    if (post.aux == "HELM_MODE" && std::holds_alternative<std::string>(post.value)) {
      ReportEvent(events::kMode, post.variable + " = " + std::get<std::string>(post.value));
      if (lead_.leads()) continue;  // the other helm has modes of that name
    }
    PublishRaw(post.variable, post.value, post.aux);
  }
}

std::vector<WeightedBehavior> HelmApp::Bidders() {
  std::vector<WeightedBehavior> bidders = host_.running();
  if (params_.views.gain == "coverage") {  // [Bucci 2025] eq. (17): objects have no say
    std::erase_if(bidders, [this](const WeightedBehavior& running) {
      bool is_about_objects = false;
      return !Heard(running.name, call_failures_, [&] {
        is_about_objects = running.behavior->IsAboutObjects();
      }) || is_about_objects;
    });
  }
  return bidders;
}

void HelmApp::Tick(Seconds now) {
  const Seconds began = SteadyTime();
  Iterate(now);
  if (context().runs_live && !lead_.leads()) {  // embedded, equal runs say the same
    Publish(topics::kHelmCreateTime, arbiter_.asked_for().value());
    Publish(topics::kHelmLoopTime, (SteadyTime() - began).value());
    TellLoad();
  }
}

void HelmApp::Iterate(Seconds now) {
  Introduce();
  PostRequests();
  if (std::exchange(is_updated_, false)) SubscribeForBehaviors();
  ++helm_iteration_;
  motion_ = {};
  TakeStockNav(now);
  if (!nav_) {
    const bool is_old =
        !hears_nav_state_ && stock_nav_.IsComplete(arbiter_.domain().depth.has_value());
    AllStop(is_old ? "StaleNav" : "MissingNav");
    PublishState(now);
    return;
  }
  VehicleState state = StateAt(now);
  if (is_parked_) {
    StandStill("ManualOverride");  // behaviors stand, too: no duration runs, no flag is posted
  } else {
    Drive(state);
  }
  if (lead_.leads()) JudgeLedHelm(now);
  GatherFailures();
  TellFailures();
  TellBehaviorWarnings();
  if (planner_.path().segments().empty()) {
    drawing_.ErasePath();
  }
  PublishState(now);
}

VehicleState HelmApp::StateAt(Seconds now) {
  const NavState nav = nav_.value_or(NavState());
  return {.now = now,
          .nav = nav,
          .guidance = planner_.Guide(nav),
          .area = planner_.survey().area(),
          .home = planner_.survey().home(),
          .domain = arbiter_.domain(),
          .ownship = ownship_,
          .heard = &host_.heard()};
}

void HelmApp::Drive(VehicleState& state) {
  Post(host_.Update(state));
  if (IsOverruled()) {
    StandStill("Safety:" + std::string(NameOf(safety_)));
  } else {
    TellRestart();
    DecideView(state.now);
    TellRevisits(state.now);
    state.guidance = planner_.Guide(*nav_);
    Steer(state);
    if (params_.park_on_allstop && allstop_text_ != topics::kNoAllStop) Park(true);
  }
  SettleBehaviors(state);
}

void HelmApp::StandStill(const std::string& why) {
  planner_.DropPath();
  view_failures_.clear();
  view_late_.clear();
  AllStop(why);
}

void HelmApp::DecideView(Seconds now) {
  const std::vector<WeightedBehavior> bidders = Bidders();
  const Seconds began = SteadyTime();
  const std::optional<ViewDecision> decision = planner_.DecideIfDue(bidders, *nav_, now);
  std::vector<BehaviorFailure> failures = planner_.TakeFailures();
  std::vector<OwnedWarning> late = planner_.TakeLate();
  if (!decision) {
    if (planner_.path().segments().empty()) {  // nobody wants a view
      view_failures_.clear();
      view_late_.clear();
    }
    call_late_ = std::move(late);
    std::ranges::move(failures, std::back_inserter(call_failures_));
    return;
  }
  if (context().runs_live) {  // embedded, equal runs say the same
    Publish(topics::kPlanTime, (SteadyTime() - began).value());
  }
  if (const std::size_t blocks = planner_.survey().blocks_passed_over(); blocks > 0) {
    Warn(
        warnings::kBlocksPassedOver,
        fmt::format("{} blocks of the area took far too long, or had no way that was worth it, and "
                    "were left with more than slivers unseen",
                    blocks));
  }
  if (const bool gives_up = planner_.survey().gives_up(); gives_up != gives_up_) {
    gives_up_ = gives_up;
    Publish(topics::kHelmGivesUp, gives_up);
  }
  view_failures_ = std::move(failures);
  view_late_ = std::move(late);
  Publish(topics::kHelmBids, decision->bids);
  bids_ = Stamped<HelmBids>{now, decision->bids};
  if (decision->chosen) {
    ClearWarning(warnings::kNoOption);
    Publish(topics::kHelmPath,
            ToHelmPath(decision->chosen->path, decision->bids.path_id, decision->chosen->source));
    drawing_.DrawDecision(*decision);
    lead_.Follow(decision->chosen->path);
    ReportEvent(events::kPath, fmt::format("path {}: {}, {:.0f} m, because: {}",
                                           decision->bids.path_id, decision->chosen->source,
                                           decision->chosen->path.length(), decision->bids.cause));
  } else {
    Warn(warnings::kNoOption, "no option is left: all vetoed or none offered");
  }
}

void HelmApp::SettleBehaviors(const VehicleState& state) {
  const std::vector<std::string_view> active =
      is_parked_ ? std::vector<std::string_view>() : ActiveBehaviors();
  Post(host_.Settle({.turns = motion_.turns, .active = active}, state));
  const std::vector<LifeEvent> events = host_.TakeLifeEvents();
  journal_.PostLifeEvents(events, helm_iteration_, state.now);
  if (!events.empty()) {
    SubscribeForBehaviors();
    journal_.PostVariables(host_);
  }
}

std::vector<std::string_view> HelmApp::ActiveBehaviors() const {
  std::vector<std::string_view> active(motion_.active.begin(), motion_.active.end());
  if (bids_ && !planner_.path().segments().empty() && !bids_->value.options.empty()) {
    for (const WeightedBid& bid : bids_->value.options.front().bids) {
      active.emplace_back(bid.behavior);
    }
  }
  return active;
}

void HelmApp::PublishState(Seconds now) {
  if (!lead_.leads()) {
    Publish(topics::kHelmState, std::string(StateText()));
    if (published_allstop_ != allstop_text_) {
      published_allstop_ = allstop_text_;
      Publish(topics::kHelmAllStop, allstop_text_);
    }
  }
  journal_.PostIteration({.number = helm_iteration_,
                          .now = now,
                          .course_deg = last_course_deg(),
                          .speed = motion_.speed,
                          .depth = motion_.depth,
                          .is_halted = allstop_text_ != topics::kNoAllStop,
                          .functions = static_cast<int>(motion_.active.size()),
                          .warnings = static_cast<int>(warnings().size()),
                          .modes = host_.modes(),
                          .behaviors = host_.statuses(),
                          .active = ActiveBehaviors()});
}

LIMPET_REGISTER_APP(HelmApp, "pHelm", 10.0);

}  // namespace limpet

// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "apps/pHelm/app_wait.hpp"
#include "apps/pHelm/helm_drawing.hpp"
#include "apps/pHelm/helm_journal.hpp"
#include "apps/pHelm/led_answers.hpp"
#include "apps/pHelm/mail_skew.hpp"
#include "apps/pHelm/stock_nav.hpp"
#include "limpet/app/app.hpp"
#include "limpet/app/app_status.hpp"
#include "limpet/helm/behavior_host.hpp"
#include "limpet/helm/helm_lead.hpp"
#include "limpet/helm/helm_params.hpp"
#include "limpet/helm/motion_decision.hpp"
#include "limpet/helm/motion_record.hpp"
#include "limpet/helm/view_planner.hpp"
#include "limpet/helm/warning_book.hpp"
#include "limpet/topics/energy.hpp"
#include "limpet/topics/safety.hpp"

namespace limpet {

/// Hosts behaviors and arbitrates their bids: which view next (HELM_PATH, explained in HELM_BIDS),
/// and how to move now (DESIRED_HEADING, DESIRED_SPEED, DESIRED_DEPTH). Parks on
/// MOOS_MANUAL_OVERRIDE. With `lead` it says neither, but tells another helm's behaviors.
class HelmApp final : public App {
 public:
  using Params = HelmParams;
  HelmApp(const AppContext& context, const Params& params);
  void Tick(Seconds now) override;
  void Report(ReportLines& report) const override;

 private:
  void OnNav(const Stamped<NavState>& nav) {
    nav_ = nav.value.is_usable() ? std::optional<NavState>(nav.value) : std::nullopt;
    hears_nav_state_ = true;
  }
  template <StockNav::Quantity kQuantity>
  void OnStockNav(const Stamped<double>& value) {
    stock_nav_.Hear(kQuantity, value.value, now());
  }
  /// What there is to steer by where nobody writes NAV_STATE.
  void TakeStockNav(Seconds now);
  void SubscribeToNavigation();
  void OnOverride(const Stamped<bool>& parked) { Park(parked.value); }
  void Park(bool is_parked) {
    if (!is_parked || params_.allow_park) is_parked_ = is_parked;
  }
  /// MOOS_MANUAL_OVERRIDE, its other spelling, and what the mission calls it besides.
  void SubscribeToOverride();
  /// Whether mail of a variable is to be heard; says so if not, for its stamp. Who takes the
  /// vehicle over is heard whatever the clocks say.
  [[nodiscard]] bool IsInTime(const std::string& variable, Seconds stamp);
  /// What behaviors ask for as the helm begins, once all are there that it waits for.
  void PostRequests();
  void OnSafety(const Stamped<std::string>& action);
  /// Safety has taken the decision away: hold, surface, abort.
  [[nodiscard]] bool IsOverruled() const;
  void OnArea(const Stamped<SurveyArea>& area);
  void OnHome(const Stamped<HomePoint>& home);
  void OnEnergy(const Stamped<EnergyState>& energy) {
    planner_.survey().SetReach(Meters(energy.value.reach_m));
  }
  void OnCourseCost(const Stamped<CourseCost>& cost) {
    planner_.survey().SetCourseCost(cost.value);
  }
  void OnDelta(const Stamped<GridDelta>& delta) { planner_.survey().Apply(delta.value); }
  void OnCoverage(const Stamped<Coverage>& coverage) {
    planner_.survey().SetCoverage(coverage.value);
  }
  void OnOpis(const Stamped<OpiBeliefs>& opis) { planner_.SetObjects(opis.value.opis); }
  void OnObstacles(const Stamped<Obstacles>& obstacles);
  void OnLook(const Stamped<MapLook>& look) { planner_.survey().SetLookModel(look.value); }

  void HearSurvey();
  /// Subscribes to every variable that the behaviors want by now.
  void SubscribeForBehaviors();
  /// Once, before the first iteration.
  void Introduce();
  /// What `initialize` lines say; notes what behaviors ask of apps (PostRequests).
  void PostInitial(BehaviorHost::Initials which);
  /// Once, as the first decision is due of a helm whose process was replaced, or that was told to
  /// begin anew.
  void TellRestart();
  /// RESTART_HELM: type1, type2.
  void OnRestart(const Message& message);
  /// Makes all behaviors anew from the files as they are now; what was heard stays known. If they
  /// cannot be made, those that there are go on.
  void BeginAnew(BehaviorHost::Initials posted);
  /// IVPHELM_CPU, once a second.
  void TellLoad();
  void Post(const std::vector<HelmPost>& posts);
  void Iterate(Seconds now);
  /// What behaviors are told of the vehicle; its `nav` is all zeros where nothing is known of it.
  [[nodiscard]] VehicleState StateAt(Seconds now);
  void Drive(VehicleState& state);
  /// Stops all, and forgets the path.
  void StandStill(const std::string& why);
  void DecideView(Seconds now);
  void JudgeLedHelm(Seconds now);
  /// Says which objects still want a look, and which will get none.
  void TellRevisits(Seconds now);
  [[nodiscard]] std::string RevisitText() const;
  void TellFruitless(const HelmRevisits& revisits);
  /// Raised while `ids` are not empty; says which.
  void WarnOfObjects(const WarningId& id, const std::string& ids, const std::string& what);
  void Steer(const VehicleState& state);
  /// What was decided of the motion goes to the pilot, or to the helm that is led.
  void Drive();
  void Lead();
  /// BHV_IPF: the bids of this iteration.
  void PublishFunctions();
  /// Who failed or took long in this iteration, wherever, with the warnings of it.
  void GatherFailures();
  /// BHV_ERROR, whenever others fail than before, or for other reasons.
  void TellFailures();
  /// Carries out what behaviors did beside bidding.
  void SettleBehaviors(const VehicleState& state);
  /// Raises what behaviors raise now, and clears what none raises any more.
  void TellBehaviorWarnings();
  void Ask(const Topic<double>& topic, double value);
  void AskForNothing();
  void AllStop(const std::string& why);
  void ClearAllStop();
  void PublishState(Seconds now);
  [[nodiscard]] const char* StateText() const { return is_parked_ ? "PARK" : "DRIVE"; }
  [[nodiscard]] std::optional<double> last_course_deg() const;
  /// Running behaviors that had an opinion on the motion or on the path in force.
  [[nodiscard]] std::vector<std::string_view> ActiveBehaviors() const;
  [[nodiscard]] std::vector<WeightedBehavior> Bidders();

  Params params_;
  std::string ownship_;  ///< the vehicle's name
  BehaviorHost host_;
  bool is_updated_ = false;                ///< some behavior, since the last iteration
  std::set<std::string> heard_variables_;  ///< that behaviors want
  ViewPlanner planner_;
  MotionArbiter arbiter_;
  MotionRecordRate motion_rate_;
  std::optional<NavState> nav_;
  bool hears_nav_state_ = false;  ///< it counts alone, once heard
  StockNav stock_nav_;
  bool is_parked_ = false;
  SafetyAction safety_ = SafetyAction::kNone;
  bool is_introduced_ = false;
  AppWait app_wait_;
  std::vector<HelmPost> requests_;  ///< of behaviors, that wait for apps
  MailSkew mail_skew_;
  Seconds made_at_;                 ///< vehicle time
  bool is_restart_untold_ = false;  ///< it is to be told with the next decision
  ProcessUse told_use_;             ///< of the machine, when that was last told
  Seconds told_use_at_;             ///< real time
  std::string allstop_text_;        ///< clear, or why all is stopped
  std::string published_allstop_;   ///< as last posted
  std::string stopped_for_;         ///< why the vehicle was last told to stop
  int empty_decisions_ = 0;         ///< iterations in a row
  std::int64_t helm_iteration_ = 0;
  WarningBook warning_book_;
  std::string told_failures_;                   ///< as last posted in BHV_ERROR
  MotionDecision motion_;                       ///< of this iteration
  std::optional<Stamped<HelmBids>> bids_;       ///< of the last view decision
  std::vector<BehaviorFailure> view_failures_;  ///< of the last view decision
  std::vector<OwnedWarning> view_late_;         ///< of the last view decision
  std::vector<OwnedWarning> call_late_;         ///< of this iteration, where nothing is decided
  std::vector<BehaviorFailure> call_failures_;  ///< of this iteration, where nothing is decided
  HelmRevisits revisits_;                       ///< as last told
  bool gives_up_ = false;                       ///< as last told
  HelmJournal journal_;
  HelmDrawing drawing_;
  HelmLead lead_;
  LedAnswers led_answers_;
};

}  // namespace limpet

// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "apps/pSurvey/helm_watch.hpp"
#include "apps/pSurvey/survey_memory.hpp"
#include "apps/pSurvey/transit.hpp"
#include "limpet/app/app.hpp"
#include "limpet/energy/energy_estimate.hpp"
#include "limpet/planning/ground.hpp"
#include "limpet/planning/region.hpp"
#include "limpet/survey/survey_params.hpp"
#include "limpet/topics/energy.hpp"
#include "limpet/topics/mapping.hpp"
#include "limpet/topics/mission.hpp"
#include "limpet/topics/navigation.hpp"
#include "limpet/topics/safety.hpp"
#include "limpet/topics/survey_phase.hpp"

namespace limpet {

/// The mission manager: announces the area, walks through the phases (align at the surface, dive,
/// survey, return, ascend, last fix) and ends the mission. The survey ends when the coverage target
/// is reached and the helm wants no further look at any object (HELM_REVISITS). Live, it keeps
/// where it is in a file of the run folder, and goes on from there if it is started again.
class SurveyApp final : public App {
 public:
  using Params = SurveyParams;

  SurveyApp(const AppContext& context, const Params& params);
  void Tick(Seconds now) override;
  void Report(ReportLines& report) const override;

 private:
  /// Of what pNav does not vouch for only the silence counts.
  void OnNav(const Stamped<NavState>& nav);
  /// Learns from it what the way home takes, and says so.
  void OnBattery(const Stamped<BatteryState>& battery);
  /// Learns from it what a metre takes by course, and says so.
  void OnCurrent(const Stamped<WaterCurrent>& current);
  void OnDeploy(const Stamped<bool>& deploy);
  void OnReturn(const Stamped<bool>& request);
  void OnAreaRequest(const Stamped<std::string>& request);
  /// The way up is all that is left: the mission ends at the surface.
  void OnSafety(const Stamped<std::string>& action);
  /// Somebody else has ended the mission: the launcher, for want of an app.
  void OnMissionEnd(const Stamped<std::string>& end);
  void OnCoverage(const Stamped<Coverage>& coverage);
  void OnHelmState(const Stamped<std::string>& state) { helm_.HearState(state.value, now()); }
  void OnAllStop(const Stamped<std::string>& why) { helm_.HearAllStop(why.value, now()); }
  void OnLook(const Stamped<MapLook>& look);
  /// Where the helm finds nothing worth flying to but home, the survey is over.
  void OnPath(const Stamped<HelmPath>& path);
  /// Two objects tie two sessions' frames; one alone could be a mistake.
  void OnPrior(const Stamped<SessionPrior>& prior) {
    has_former_ = prior.value.former.objects.size() >= 2;
  }
  void OnRevisits(const Stamped<HelmRevisits>& revisits) { revisits_ = revisits.value; }
  void OnGivesUp(const Stamped<bool>& gives_up) {
    given_up_since_ = gives_up.value ? std::optional(now()) : std::nullopt;
  }

  void Enter(SurveyPhase phase, Seconds now);
  void GoHome(const std::string& reason, const std::string& ended, Seconds now);
  void AlignAtSurface(Seconds now);
  void Survey(Seconds now);
  /// On the way to the area coming nearer to it is progress, as new ground is inside.
  void TrackTransit(Seconds now);
  /// Warns while nobody steers.
  void WatchHelm(Seconds now);
  void EndMission(Seconds now);
  void WalkOn(Seconds now);
  [[nodiscard]] bool IsUnderWay() const;
  /// Ends what can no longer end well. True if it did.
  [[nodiscard]] bool EndsHopeless(Seconds now);
  [[nodiscard]] bool IsAtSurface() const;
  void SetArea(SurveyArea area);
  /// The area of the former life, as a record in braces.
  void RecallArea(const std::string& kept);
  /// Makes the estimate of energy, if the vehicle's file has a battery.
  void MakeEnergyEstimate();
  void PublishArea();
  void Remember();
  /// What could not be kept is tried again in a while.
  void TellWhatIsKept(Seconds now);
  void Recall();
  /// Area, home and phase, for those who have come or come back.
  void TellAgain(Seconds now);
  /// Objects that the helm still wants to look at.
  [[nodiscard]] std::ptrdiff_t OpenRevisits() const;
  [[nodiscard]] std::optional<Seconds> TimeToTarget() const;
  /// The helm finds nothing more that is worth its way, and next to nothing is lacking.
  [[nodiscard]] bool IsGivenUp(Seconds now) const;
  /// Growth of coverage that counts as progress.
  [[nodiscard]] double ProgressStep() const;
  [[nodiscard]] double CoveredShare(const Coverage& coverage) const;
  [[nodiscard]] double DistanceHome() const;
  [[nodiscard]] double CourseHome() const;
  /// What coverage comes to when all that this water shows from survey altitude has been seen.
  [[nodiscard]] double AttainableShare() const;

  Params params_;
  SurveyArea area_;
  Region region_;
  SurveyPhase phase_ = SurveyPhase::kIdle;
  Seconds phase_since_;
  Seconds told_;
  std::optional<Seconds> deployed_;
  Seconds last_progress_;
  Transit transit_;
  HelmWatch helm_;
  double best_share_ = 0.0;
  std::optional<Stamped<NavState>> nav_;
  std::optional<HomePoint> home_;
  Coverage coverage_;
  std::optional<Footprint> footprint_;  ///< in this water
  HelmRevisits revisits_;
  std::optional<Seconds> given_up_since_;  ///< by the helm
  bool has_former_ = false;                ///< session, with objects that tie this one to it
  std::string ended_ = "home";
  std::optional<EnergyEstimate> energy_;  ///< of a vehicle that has a battery
  std::optional<EnergyState> energy_state_;
  CourseCost course_cost_;  ///< as last said
  SurveyKeeper keeper_;
  std::optional<Seconds> not_kept_;  ///< since when
};

}  // namespace limpet

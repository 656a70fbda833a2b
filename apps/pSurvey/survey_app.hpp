// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>
#include <string>

#include "apps/pSurvey/helm_watch.hpp"
#include "apps/pSurvey/transit.hpp"
#include "limpet/app/app.hpp"
#include "limpet/core/params.hpp"
#include "limpet/topics/mapping.hpp"
#include "limpet/topics/mission.hpp"
#include "limpet/topics/navigation.hpp"

namespace limpet {

/// The mission manager: announces the area, walks through the phases (align at the surface, dive,
/// survey, return, ascend, last fix) and ends the mission. The survey ends when the coverage target
/// is reached and the helm wants no further look at any object (HELM_REVISITS). Live, it keeps
/// where it is in a file of the run folder, and goes on from there if it is started again.
class SurveyApp final : public App {
 public:
  struct Params {
    Meters north_min{-15.0}, north_max{15.0}, east_min{-18.0}, east_max{18.0};
    Meters margin{2.0};
    Meters object_height_max{2.0};
    Meters altitude{4.0};
    Meters altitude_tolerance{0.3};
    Seconds align{300.0};
    Seconds last_fix{300.0};
    double coverage_target = 0.975;
    std::string coverage_kind = "band_top";
    Meters home_radius{1.0};
    Meters surface_depth{0.35};
    Seconds stall{240.0};
    Seconds max_time{5400.0};
    Seconds lost{300.0};
    Seconds give_up{1800.0};
    template <class Visitor>
    void Describe(Visitor& visit) {
      visit("area_north_min_m", north_min, "South edge of the area");
      visit("area_north_max_m", north_max, "North edge of the area");
      visit("area_east_min_m", east_min, "West edge of the area");
      visit("area_east_max_m", east_max, "East edge of the area");
      visit("margin_m", margin, "Strip around the area that the vehicle may use",
            InRange(Meters(0.0), Meters(100.0)));
      visit("object_height_max_m", object_height_max,
            "Objects float up to this height above the seabed; 0 covers the bottom alone",
            InRange(Meters(0.0), Meters(10.0)));
      visit("altitude_m", altitude,
            "Survey altitude; the dive ends within altitude_tolerance_m of it",
            InRange(Meters(0.5), Meters(50.0)));
      visit("altitude_tolerance_m", altitude_tolerance, "How near the altitude must be",
            InRange(Meters(0.05), Meters(5.0)));
      visit("align_s", align, "Time at the surface to collect GPS fixes before the dive",
            InRange(Seconds(0.0), Seconds(3600.0)));
      visit("last_fix_s", last_fix,
            "Time at the surface at the end: later GPS fixes are independent of the first ones",
            InRange(Seconds(0.0), Seconds(3600.0)));
      visit("coverage_target", coverage_target, "Share of the area to see before going home",
            InRange(0.0, 1.0));
      visit.Choice(
          "coverage_kind", coverage_kind,
          "What the target counts: the bottom, the mean over the band, or its greatest height",
          {"seabed", "band", "band_top"});
      visit("home_radius_m", home_radius, "Home is reached within this distance",
            InRange(Meters(0.2), Meters(50.0)));
      visit("surface_depth_m", surface_depth, "Shallower than this is at the surface",
            InRange(Meters(0.0), Meters(5.0)));
      visit("stall_s", stall,
            "Go home when coverage has not grown, or on the way to the area that has not come "
            "nearer, for this long",
            InRange(Seconds(10.0), Seconds(86400.0)));
      visit("max_time_s", max_time, "Go home after this time under way",
            InRange(Seconds(10.0), Seconds(864000.0)));
      visit("lost_s", lost, "End the mission, lost, after this time under way without NAV_STATE",
            InRange(Seconds(10.0), Seconds(86400.0)));
      visit("give_up_s", give_up,
            "End the mission where it is if diving, returning or ascending takes longer",
            InRange(Seconds(10.0), Seconds(86400.0)));
    }
    /// No mission takes longer, whatever happens: each phase ends by itself, and after `max_time`
    /// the vehicle goes home. From DEPLOY to MISSION_END.
    [[nodiscard]] Seconds Longest() const {
      const Seconds dive_ends = align + give_up;
      return std::max(max_time, dive_ends) + 2.0 * give_up + lost + last_fix;
    }
  };

  SurveyApp(const AppContext& context, const Params& params);
  void Tick(Seconds now) override;
  void Report(ReportLines& report) const override;

 private:
  enum class Phase { kIdle, kAlign, kDive, kSurvey, kReturn, kAscend, kFix, kDone };

  void OnNav(const Stamped<NavState>& nav) { nav_ = nav; }
  void OnDeploy(const Stamped<bool>& deploy);
  void OnReturn(const Stamped<bool>& request);
  void OnCoverage(const Stamped<Coverage>& coverage);
  void OnHelmState(const Stamped<std::string>& state) { helm_.HearState(state.value, now()); }
  void OnAllStop(const Stamped<std::string>& why) { helm_.HearAllStop(why.value, now()); }
  void OnRevisits(const Stamped<HelmRevisits>& revisits) { revisits_ = revisits.value; }

  void Enter(Phase phase, Seconds now);
  void GoHome(const std::string& reason, const std::string& ended, Seconds now);
  void AlignAtSurface(Seconds now);
  void Survey(Seconds now);
  /// On the way to the area coming nearer to it is progress, as new ground is inside.
  void TrackTransit(Seconds now);
  /// Warns while nobody steers.
  void WatchHelm(Seconds now);
  [[nodiscard]] SurveyArea Area() const;
  void EndMission(Seconds now);
  void WalkOn(Seconds now);
  [[nodiscard]] bool IsUnderWay() const;
  /// Ends what can no longer end well. True if it did.
  [[nodiscard]] bool EndsHopeless(Seconds now);
  void PublishArea();
  void Remember();
  void Recall();
  /// Area, home and phase, for those who have come or come back.
  void TellAgain(Seconds now);
  [[nodiscard]] static const char* NameOf(Phase phase);
  /// Objects that the helm still wants to look at.
  [[nodiscard]] std::ptrdiff_t OpenRevisits() const;
  [[nodiscard]] std::optional<Seconds> TimeToTarget() const;
  [[nodiscard]] double CoveredShare(const Coverage& coverage) const;
  [[nodiscard]] double DistanceHome() const;

  Params params_;
  Phase phase_ = Phase::kIdle;
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
  HelmRevisits revisits_;
  std::string ended_ = "home";
};

}  // namespace limpet

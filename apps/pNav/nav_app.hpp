// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/pNav/refusal_watch.hpp"
#include "apps/pNav/source_watch.hpp"
#include "estimation/attitude/attitude_filter.hpp"
#include "estimation/navigation/measurement_source.hpp"
#include "estimation/navigation/navigator.hpp"
#include "estimation/navigation/place_sigmas.hpp"
#include "estimation/navigation/source_block.hpp"
#include "estimation/navigation/track_watch.hpp"
#include "limpet/app/app.hpp"
#include "limpet/core/camera_params.hpp"
#include "limpet/core/lens_model.hpp"
#include "limpet/core/long_ago.hpp"
#include "limpet/core/params.hpp"
#include "limpet/topics/mapping.hpp"
#include "limpet/topics/mission.hpp"
#include "limpet/topics/navigation.hpp"
#include "limpet/topics/sensors.hpp"
#include "limpet/vehicle_file/vehicle_file.hpp"

namespace limpet {

/// Says where the vehicle is and where the objects are: attitude filter and semantic smoother.
/// Silent until the heading is aligned and a GPS fix has been seen. While nothing tells how the
/// vehicle moves, NAV_STATE says so and NAV_X and its kin are silent.
class NavApp final : public App {
 public:
  static constexpr bool kReplaysMail = true;  ///< what it knows is what it heard
  struct Params {
    Seconds alignment{5.0};
    MetersPerSecond dvl_jump = VelocityGateParams{}.jump;
    Seconds frame_wait{0.4};  // less than a recording is given: what steers lags behind by it
    Seconds stale_after{2.0};
    MetersPerSecond strongest_current{0.5};
    Meters opi_radius{0.5};
    double opi_radius_spread = kSizeSpread;
    std::string opi_radius_by_class = "none";
    double min_confidence = ObjectTrackerParams{}.min_confidence;
    double wrong_color_share = BoxGateParams{}.confused_class_share;
    int looks_to_confirm = ObjectTrackerParams{}.looks_to_confirm;
    double confirm_log_odds = ObjectTrackerParams{}.confirm_log_odds;
    Seconds node_period = NavigatorParams{}.node_period;
    Meters node_distance = NavigatorParams{}.node_distance;
    MatchingParams session;
    CameraParams camera;
    bool compass_aids = true;
    std::string sensors = kUsualSensors, sources = "none";

    template <class Visitor>
    void Describe(Visitor& visit) {
      using namespace literals;
      visit("alignment_s", alignment, "The heading is averaged this long at the start",
            InRange(0.0_s, 120.0_s));
      visit("dvl_jump_mps", dvl_jump, "Change of velocity that is no outlier",
            InRange(0.01_mps, 5.0_mps));
      visit("frame_wait_s", frame_wait, "Boxes are waited for this long after the exposure",
            InRange(0.0_s, 3.0_s));
      visit("stale_after_s", stale_after,
            "A sensor silent for longer is not valid and raises a warning", InRange(0.1_s, 60.0_s));
      visit("strongest_current_mps", strongest_current,
            "What the water can do: while nothing measures the velocity, sigma grows by it and by "
            "the vehicle's top speed",
            InRange(0.0_mps, 5.0_mps));
      visit.Required("opi_radius_m", opi_radius, "Radius of the objects; 0: unknown",
                     InRange(0.0_m, 5.0_m));
      visit("opi_radius_spread", opi_radius_spread,
            "1-sigma of the share by which radii differ from that, until objects seen tell; 0: all "
            "are alike",
            InRange(0.0, 2.0));
      visit("opi_radius_by_class", opi_radius_by_class,
            "Classes with a radius of their own, e.g. yellow:0.5, orange:0.3");
      visit("min_confidence", min_confidence, "Boxes below are not used", InRange(0.0, 1.0));
      visit("wrong_color_share", wrong_color_share,
            "Share of boxes whose class is not the object's", InRange(0.001, 0.45));
      visit("looks_to_confirm", looks_to_confirm, "Boxes that make an object", InRange(2, 100));
      visit("confirm_log_odds", confirm_log_odds,
            "Sum of ln(c / (1 - c)) over their confidences that makes an object");
      visit("node_period_s", node_period, "Longest time between poses of the smoother",
            InRange(0.1_s, 10.0_s));
      visit("node_distance_m", node_distance, "Longest way between poses of the smoother",
            InRange(0.05_m, 10.0_m));
      session.Describe(visit);
      camera.Describe(visit);
      visit("compass_aids", compass_aids,
            "The magnetic heading is used during the dive, too, and its deviation estimated; not "
            "beside the source magnetic_heading, which does so itself");
      visit("sensors", sensors,
            "Sensors that dead reckoning stands on; each brings keys of its own, behind its name");
      visit("sources", sources,
            "Further sensors that are heard, e.g. acoustic_fix, magnetic_heading; each brings keys "
            "of its own, behind its name");
    }
  };

  /// Throws ConfigError without the vehicle's file.
  NavApp(const AppContext& context, const Params& params);
  /// A sensor, of dead reckoning or a further one; before the first mail.
  void Hear(const std::string& name, std::unique_ptr<MeasurementSource> source);
  void Tick(Seconds now) override;
  void Report(ReportLines& report) const override;

 private:
  void HearMotion(std::unique_ptr<MotionSensor> sensor);
  void HearAiding(const std::string& name, std::unique_ptr<MeasurementSource> source);
  /// Hands on what `source` makes of each message that it hears; `use` says whether that makes
  /// sense.
  void SubscribeTo(const MeasurementSource& source,
                   std::function<bool(std::shared_ptr<mrpt::obs::CObservation>)> use);
  void On(const InertialInput& sample);
  void On(const YawRate& turning);
  void On(const BottomTrack& ping);
  void On(const SlantRanges& ping);
  void On(const DepthReading& reading);
  void On(const PositionFix& fix);
  void On(const Detections& frame);
  void On(const ThrusterShares& command);
  void OnSonar(const Stamped<SonarPing>& ping);
  /// Each echo of the ping is the former ping's: noise lets a sound sonar say no such.
  [[nodiscard]] bool RepeatsEchoes(const SonarPing& ping);
  void OnPrior(const Stamped<SessionPrior>& prior);
  void OnSnapshotRequest(const Stamped<std::string>& why);

  void PublishScalars(const NavigatorEstimate& estimate);
  void PublishState(double now);
  void PublishDeadReckoning(double now);
  void PublishCurrent(double now);
  void PublishFrames();
  /// Poses of the chain that are new.
  void NoteTrack();
  /// How sure the newest pose's place is.
  [[nodiscard]] PlaceSigma NewestSigma();
  /// How sure the whole track is now, in steps.
  [[nodiscard]] std::vector<std::array<double, 3>> TrackSigmas() const;
  void PublishLandmarks(double now);
  void WatchSensors(double now);
  [[nodiscard]] bool IsFresh(const SourceWatch& source, double now) const {
    return source.IsFresh(now, stale_after_);
  }
  [[nodiscard]] bool HasFreshGps(double now) const;
  /// Something has told lately how the vehicle moves.
  [[nodiscard]] bool IsValid(double now) const;
  void AddSources(double now, NavState& state) const;
  void ReportSources(ReportLines& report) const;
  void ReportAiding(ReportLines& report) const;
  void WatchAiding(double now);
  void WatchAgreement();
  void WatchUnplaced();

  NavApp(const AppContext& context, const Params& params, const VehicleFile& vehicle);

  DvlSheet dvl_sheet_;
  Eigen::Vector3d p_BS_;  ///< of the sonar that looks ahead
  Eigen::Matrix3d R_BD_;  ///< body from the DVL's own frame
  /// Force ahead and abeam of each thruster at full command [N].
  Seconds stale_after_;  ///< as the mission says, and at least half a second of real time
  LensModel lens_;       ///< boxes are rectified where they come in; what follows is a pinhole's
  AttitudeFilter attitude_;
  Navigator navigator_;
  struct AidingWatch {
    std::string name;
    SourceWatch heard;
  };
  std::vector<std::unique_ptr<MotionSensor>> sensors_;  ///< that dead reckoning stands on
  std::vector<AidingWatch> aiding_;                     ///< the further ones
  std::optional<double> aiding_awaited_;                ///< since when [s]
  TrackWatch track_watch_;
  PlaceSigmas place_sigmas_;
  std::optional<int> sigma_node_;  ///< of which newest_sigma_ is
  PlaceSigma newest_sigma_;        ///< as of the last frame
  double last_attitude_t_ = kLongAgo;
  SourceWatch imu_, fog_, dvl_, lock_, depth_, gps_, camera_, sonar_, refused_fix_;
  RefusalWatch imu_refusals_, velocity_refusals_;
  std::vector<double> former_echoes_;  ///< of the sonar that looks ahead [m]
  int refused_fixes_ = 0;              ///< as of the last tick
  int gps_fixes_ = 0, dvl_pings_ = 0, dvl_pings_without_lock_ = 0;  ///< for the report
  int landmark_version_ = 0;
  double landmarks_t_ = kLongAgo, current_t_ = kLongAgo;
};

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/safety/safety_signs.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "limpet/core/frames.hpp"
#include "limpet/survey/grid_frame.hpp"

namespace limpet {
namespace {

using SafetyId = SafetyRuleId;

constexpr Seconds kFreshNavigation(2.0);
constexpr Seconds kPulse(10.0);         ///< an event counts as so for this long
constexpr double kCameraIdles_m = 1.0;  ///< up here a camera may make no images
constexpr double kFullThrust = 0.99;
constexpr double kFrameShare = 0.05;  ///< of the newest frame in the mean of boxes
constexpr double kFastest_mps = 2.0;  ///< a vehicle at the surface drifts and swims no faster

std::optional<double>& MeasureOf(SafetyMeasures& measures, SafetyId id) {
  return measures[static_cast<std::size_t>(id)];
}

double FlagOf(bool is_so) { return is_so ? 1.0 : 0.0; }

std::optional<double> SinceOrZero(std::optional<Seconds> since, Seconds now) {
  return since ? (now - *since).value() : 0.0;
}

}  // namespace

void SafetySigns::HearPhase(std::string_view survey_phase, Seconds now) {
  const SafetyPhase phase = SafetyPhaseOf(survey_phase);
  if (phase == SafetyPhase::kDive && phase_ != SafetyPhase::kDive) submerged_since_ = now;
  surveys_since_ =
      phase == SafetyPhase::kSurvey ? surveys_since_.value_or(now) : std::optional<Seconds>();
  phase_ = phase;
}

SafetyPhase SafetySigns::phase() const {
  return phase_.value_or(helm_.has_steered() ? SafetyPhase::kSurvey : SafetyPhase::kIdle);
}

void SafetySigns::Hear(const SurveyArea& area) {
  const bool is_news = !area_ || *area_ != area;
  if (!is_news || ProblemOf(area)) return;  // who flies it refuses such an area, and says so
  area_ = area;
  region_.emplace(area);
  zones_ = ZoneWatch(area);
}

void SafetySigns::Hear(const NavState& nav, Seconds now) {
  if (!nav.is_usable()) return;
  nav_ = {now, nav};
  if (nav.down < kCameraIdles_m) surfaced_ = now;
  seabed_.Hear(nav, now);
}

void SafetySigns::Hear(const DvlSample& dvl, Seconds now) {
  if (dvl.u && dvl.v && dvl.w) {
    velocity_heard_ = now;
    velocity_.Hear({*dvl.u, *dvl.v, *dvl.w}, now);
  }
  if (dvl.altitude) altitude_.Hear({*dvl.altitude}, now);
}

void SafetySigns::Hear(const ImuSample& imu, Seconds now) {
  imu_.Hear({imu.fx, imu.fy, imu.fz, imu.p, imu.q, imu.r}, now);
}

void SafetySigns::HearDepth(double depth_m, Seconds now) {
  depth_m_ = depth_m;
  pressure_heard_ = now;
  if (!IsNavigationFresh(now)) descent_.Excuse();  // the pilot stops without
  descent_.Hear(depth_m, now);
  pressure_.Hear({depth_m}, now);
}

void SafetySigns::Hear(const GpsFix& fix, Seconds now) {
  if (fix_) {
    const double way = std::hypot(fix.north - fix_->value.north, fix.east - fix_->value.east);
    const double noise = 3.0 * std::hypot(fix.sd, fix_->value.sd);
    jump_m_ = std::max(0.0, way - noise - kFastest_mps * (now - fix_->time).value());
  }
  if (submerged_since_ && IsNavigationFresh(now)) {
    // After a dive: against what navigation has come to expect of it.
    const NavState& nav = nav_->value;
    const double off = std::hypot(fix.north - nav.north, fix.east - nav.east);
    const double noise = 3.0 * std::hypot(fix.sd, std::max(nav.sd_north, nav.sd_east));
    jump_m_ = std::max(jump_m_, off - noise);
  }
  fix_ = {now, fix};
}

void SafetySigns::Hear(const ThrusterCommand& command, Seconds now) {
  const std::array thrusts = command.Shares();
  const bool is_full =
      std::ranges::any_of(thrusts, [](double thrust) { return std::abs(thrust) >= kFullThrust; });
  saturated_since_ = is_full ? saturated_since_.value_or(now) : std::optional<Seconds>();
  command_heard_ = now;
}

void SafetySigns::HearDetections(const Detections& frame, Seconds now) {
  detections_heard_ = now;
  boxes_ += kFrameShare * (static_cast<double>(frame.boxes.size()) - boxes_);
}

void SafetySigns::HearProcesses(std::string_view status, Seconds now) {
  const bool is_one_down = status.find("state=waiting") != std::string_view::npos ||
                           status.find("state=given_up") != std::string_view::npos;
  down_since_ = is_one_down ? down_since_.value_or(now) : std::optional<Seconds>();
}

void SafetySigns::HearClockSteps(int steps, Seconds now) {
  if (clock_steps_ && steps != *clock_steps_) clock_stepped_ = now;
  clock_steps_ = steps;
}

std::optional<double> SafetySigns::Silence(std::optional<Seconds> heard, Seconds now) const {
  if (!under_way_since_) return std::nullopt;
  return (now - std::max(heard.value_or(*under_way_since_), *under_way_since_)).value();
}

bool SafetySigns::IsNavigationFresh(Seconds now) const {
  return nav_ && now - nav_->time <= kFreshNavigation;
}

std::optional<double> SafetySigns::VelocitySilence(Seconds now) const {
  std::optional<double> silence = Silence(std::max(velocity_heard_, submerged_since_), now);
  if (silence && IsNavigationFresh(now)) {
    const double refused = nav_->value.velocity_age.value_or(0.0);
    const double submerged = Silence(submerged_since_, now).value_or(0.0);
    silence = std::max(*silence, std::min(refused, submerged));
  }
  return silence;
}

std::optional<double> SafetySigns::ProgressLack(Seconds now) const {
  const bool is_wanted = wanted_speed_ && now - wanted_speed_->time <= kFreshNavigation;
  if (!is_wanted || !wanted_course_deg_ || !IsNavigationFresh(now) || nav_->value.velocity_age) {
    return std::nullopt;
  }
  const NavState& nav = nav_->value;
  const double off = YawFromMoosHeading(*wanted_course_deg_) - nav.yaw;
  return wanted_speed_->value - (nav.u * std::cos(off) + nav.v * std::sin(off));
}

void SafetySigns::MeasurePlace(SafetyMeasures& measures, Seconds now) {
  if (!IsNavigationFresh(now)) return;
  const NavState& nav = nav_->value;
  if (region_) {
    const double outside = region_->Outside({.north = nav.north, .east = nav.east, .yaw = nav.yaw});
    was_inside_ = was_inside_ || (outside == 0.0 && phase() == SafetyPhase::kSurvey);
    if (was_inside_) MeasureOf(measures, SafetyId::kOutsideRegion) = outside;
    const std::optional<double> share = zones_.ShareAt({nav.north, nav.east});
    if (share) MeasureOf(measures, SafetyId::kInsideZone) = 100.0 * *share;
  }
  if (home_) {
    MeasureOf(measures, SafetyId::kFarFromHome) =
        std::hypot(nav.north - home_->north, nav.east - home_->east);
  }
  const double sigma = std::max(nav.sd_north, nav.sd_east);
  MeasureOf(measures, SafetyId::kSigmaHigh) = sigma;
  MeasureOf(measures, SafetyId::kSigmaOverLimit) = sigma;
  MeasureOf(measures, SafetyId::kAltitudeLow) = nav.altitude;
  MeasureOf(measures, SafetyId::kDepthAgainstAltitude) = seabed_.step();
}

void SafetySigns::MeasureSensors(SafetyMeasures& measures, Seconds now) const {
  std::optional<double>& depth = MeasureOf(measures, SafetyId::kDepthOverLimit);
  depth = depth_m_;
  if (IsNavigationFresh(now)) depth = std::max(nav_->value.down, depth.value_or(nav_->value.down));
  // In the water alone: there the DVL has something to see.
  if (submerged_since_ || !phase_) {
    const std::optional<double> silence = VelocitySilence(now);
    MeasureOf(measures, SafetyId::kDvlSilent) = silence;
    MeasureOf(measures, SafetyId::kDvlLost) = silence;
  }
  if (pressure_heard_) {
    MeasureOf(measures, SafetyId::kDepthSilent) = (now - *pressure_heard_).value() / warp_;
  }
  if (IsNavigationFresh(now)) {
    const auto percent = [](std::optional<double> share) {
      return share ? std::optional(100.0 * *share) : std::nullopt;
    };
    MeasureOf(measures, SafetyId::kDvlOutliers) = percent(nav_->value.dvl.refused);
    MeasureOf(measures, SafetyId::kImuOutliers) = percent(nav_->value.imu.refused);
  }
  MeasureOf(measures, SafetyId::kDvlStuck) = velocity_.duration();
  MeasureOf(measures, SafetyId::kAltitudeStuck) = altitude_.duration();
  MeasureOf(measures, SafetyId::kDepthStuck) = pressure_.duration();
  MeasureOf(measures, SafetyId::kImuStuck) = imu_.duration();
  if (fix_) MeasureOf(measures, SafetyId::kGpsJump) = jump_m_;
  if (const auto silence = Silence(sonar_.heard(), now); has_sonar_ && silence) {
    MeasureOf(measures, SafetyId::kSonarSilent) = *silence / warp_;
  }
  MeasureOf(measures, SafetyId::kSonarStuck) = sonar_.stuck_for();
}

void SafetySigns::MeasureDetector(SafetyMeasures& measures, Seconds now) const {
  if (detections_heard_) MeasureOf(measures, SafetyId::kDetectorStorm) = boxes_;
  // Before the survey nobody needs images, and a camera at the surface makes none.
  const std::optional<Seconds> since = detections_heard_ ? detections_heard_ : surveys_since_;
  if (!since) return;
  const double silence = (now - std::max(*since, surfaced_.value_or(*since))).value() / warp_;
  MeasureOf(measures, SafetyId::kDetectorSilent) = silence;
  MeasureOf(measures, SafetyId::kDetectorLost) = silence;
}

void SafetySigns::MeasureProcesses(SafetyMeasures& measures, Seconds now) const {
  const auto real = [this](std::optional<double> seconds) {
    return seconds ? std::optional(*seconds / warp_) : std::nullopt;
  };
  const std::optional<Seconds> nav_heard = nav_ ? std::optional(nav_->time) : std::nullopt;
  MeasureOf(measures, SafetyId::kNavigationSilent) = real(Silence(nav_heard, now));
  MeasureOf(measures, SafetyId::kHelmSilent) = real(Silence(helm_.heard(), now));
  MeasureOf(measures, SafetyId::kPilotSilent) = real(Silence(command_heard_, now));
  MeasureOf(measures, SafetyId::kAppDown) = real(SinceOrZero(down_since_, now));
  const std::optional<Seconds> idle = helm_.idle_since();
  MeasureOf(measures, SafetyId::kHelmIdle) = idle ? Silence(idle, now) : 0.0;
  const auto is_recent = [now](std::optional<Seconds> event) {
    return FlagOf(event && now - *event < kPulse);
  };
  MeasureOf(measures, SafetyId::kBehaviorFailed) = is_recent(behavior_failed_);
  MeasureOf(measures, SafetyId::kClockStepped) = is_recent(clock_stepped_);
}

void SafetySigns::HearLog(bool is_written, Seconds now) {
  has_log_ = true;
  log_failed_since_ = is_written ? std::nullopt : std::optional(log_failed_since_.value_or(now));
}

void SafetySigns::MeasureVehicle(SafetyMeasures& measures, Seconds now) const {
  if (leaks_) MeasureOf(measures, SafetyId::kLeak) = FlagOf(*leaks_);
  if (charge_) {
    MeasureOf(measures, SafetyId::kBatteryLow) = 100.0 * *charge_;
    MeasureOf(measures, SafetyId::kBatteryCritical) = 100.0 * *charge_;
  }
  if (energy_) {
    MeasureOf(measures, SafetyId::kEnergyHome) = energy_->spare_wh();
    if (energy_->gauge_excess) {
      MeasureOf(measures, SafetyId::kGaugeOff) = 100.0 * *energy_->gauge_excess;
    }
  }
  MeasureOf(measures, SafetyId::kMissionTime) = SinceOrZero(under_way_since_, now);
  MeasureOf(measures, SafetyId::kNoProgress) = ProgressLack(now);
  MeasureOf(measures, SafetyId::kNoDepthProgress) = descent_.lacking_for();
  MeasureOf(measures, SafetyId::kThrustersSaturated) = SinceOrZero(saturated_since_, now);
  MeasureOf(measures, SafetyId::kDiskLow) = room_mib_;
  MeasureOf(measures, SafetyId::kDiskFull) = room_mib_;
  MeasureOf(measures, SafetyId::kPlannerSlow) = plan_s_;
  MeasureOf(measures, SafetyId::kMemoryHigh) = memory_mib_;
  MeasureOf(measures, SafetyId::kProcessorHigh) = processor_percent_;
  if (has_log_) MeasureOf(measures, SafetyId::kLogFailed) = SinceOrZero(log_failed_since_, now);
  if (shore_heard_) MeasureOf(measures, SafetyId::kLinkLost) = (now - *shore_heard_).value();
}

SafetyMeasures SafetySigns::At(Seconds now) {
  if (phase() == SafetyPhase::kIdle) {
    under_way_since_.reset();
    submerged_since_.reset();
    was_inside_ = false;
  } else {
    under_way_since_ = under_way_since_.value_or(now);
  }
  SafetyMeasures measures{};
  MeasurePlace(measures, now);
  MeasureSensors(measures, now);
  MeasureDetector(measures, now);
  MeasureProcesses(measures, now);
  MeasureVehicle(measures, now);
  return measures;
}

}  // namespace limpet

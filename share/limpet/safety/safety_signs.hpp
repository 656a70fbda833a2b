// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "limpet/objects/frame.hpp"
#include "limpet/planning/region.hpp"
#include "limpet/safety/depth_watch.hpp"
#include "limpet/safety/helm_signs.hpp"
#include "limpet/safety/safety_ladder.hpp"
#include "limpet/safety/seabed_watch.hpp"
#include "limpet/safety/sonar_watch.hpp"
#include "limpet/safety/stuck_watch.hpp"
#include "limpet/safety/zone_watch.hpp"
#include "limpet/topics/energy.hpp"
#include "limpet/topics/mission.hpp"
#include "limpet/topics/navigation.hpp"
#include "limpet/topics/safety.hpp"
#include "limpet/topics/sensors.hpp"

namespace limpet {

/// What is known of the vehicle, from its mail: turns it into what the rules watch. Pure, and
/// allocates nothing but when the area changes. Times are the listener's own, those of reception.
class SafetySigns {
 public:
  /// `warp`: vehicle time per real time, of a community: how long a process may be silent is
  /// counted in real time, as pLaunch counts it.
  explicit SafetySigns(double warp) : warp_(warp) {}

  /// The vehicle has a sonar that looks ahead: it is missed, also if it never speaks.
  void ExpectSonar() { has_sonar_ = true; }
  void HearPhase(std::string_view survey_phase, Seconds now);
  void Hear(const NavState& nav, Seconds now);
  void Hear(const DvlSample& dvl, Seconds now);
  void Hear(const ImuSample& imu, Seconds now);
  void Hear(const GpsFix& fix, Seconds now);
  void Hear(const ThrusterCommand& command, Seconds now);
  void Hear(const SonarPing& ping, Seconds now) { sonar_.Hear(ping, now); }
  void HearDepth(double depth_m, Seconds now);
  void HearWantedSpeed(double speed_mps, Seconds now) { wanted_speed_ = {now, speed_mps}; }
  void HearWantedDepth(double depth_m, Seconds now) { descent_.Want(depth_m, now); }
  void HearWantedCourse(double degrees) { wanted_course_deg_ = degrees; }
  void HearDetections(const Detections& frame, Seconds now);
  void HearHelmState(std::string_view state, Seconds now) { helm_.HearState(state, now); }
  void HearAllStop(std::string_view why, Seconds now) { helm_.HearAllStop(why, now); }
  void HearBehaviorError(Seconds now) { behavior_failed_ = now; }
  /// PLAUNCH_STATUS.
  void HearProcesses(std::string_view status, Seconds now);
  /// WALL_CLOCK's count.
  void HearClockSteps(int steps, Seconds now);
  void HearLeak(bool leaks) { leaks_ = leaks; }
  void HearCharge(double share) { charge_ = share; }
  void Hear(const EnergyState& energy) { energy_ = energy; }
  void HearShore(Seconds now) { shore_heard_ = now; }
  void HearPlanTime(double seconds) { plan_s_ = seconds; }
  void HearMemory(double mib) { memory_mib_ = mib; }
  void HearProcessor(double percent) { processor_percent_ = percent; }
  void HearRoom(double mib) { room_mib_ = mib; }
  /// LOG_STATE.
  void HearLog(bool is_written, Seconds now);
  /// An area that cannot be is left out.
  void Hear(const SurveyArea& area);
  void Hear(const HomePoint& home) { home_ = home; }

  /// A mission without a manager is under way, as in a survey, once its helm has steered.
  [[nodiscard]] SafetyPhase phase() const;
  [[nodiscard]] SafetyMeasures At(Seconds now);

 private:
  void MeasurePlace(SafetyMeasures& measures, Seconds now);
  void MeasureSensors(SafetyMeasures& measures, Seconds now) const;
  void MeasureDetector(SafetyMeasures& measures, Seconds now) const;
  void MeasureProcesses(SafetyMeasures& measures, Seconds now) const;
  void MeasureVehicle(SafetyMeasures& measures, Seconds now) const;
  /// Time since `heard`, or since the mission got under way [s]; absent while it is not.
  [[nodiscard]] std::optional<double> Silence(std::optional<Seconds> heard, Seconds now) const;
  /// Silence of the DVL, or of what navigation has taken of it [s].
  [[nodiscard]] std::optional<double> VelocitySilence(Seconds now) const;
  [[nodiscard]] std::optional<double> ProgressLack(Seconds now) const;
  [[nodiscard]] bool IsNavigationFresh(Seconds now) const;

  double warp_;
  std::optional<SafetyPhase> phase_;  ///< as the mission manager says; absent: there is none yet
  std::optional<Seconds> under_way_since_, submerged_since_;
  std::optional<Seconds> surveys_since_;  ///< by the mission manager's word
  std::optional<Seconds> surfaced_;  ///< when it was last so near the surface that a camera idles
  std::optional<Stamped<NavState>> nav_;
  std::optional<double> depth_m_;
  std::optional<Seconds> velocity_heard_, pressure_heard_, detections_heard_, command_heard_,
      shore_heard_;
  std::optional<Seconds> behavior_failed_, clock_stepped_, down_since_, saturated_since_;
  StuckWatch<3> velocity_;
  StuckWatch<1> altitude_, pressure_;
  StuckWatch<6> imu_;
  SeabedWatch seabed_;
  DepthWatch descent_;
  SonarWatch sonar_;
  bool has_sonar_ = false;
  std::optional<Stamped<GpsFix>> fix_;
  double jump_m_ = 0.0;
  std::optional<Stamped<double>> wanted_speed_;
  std::optional<double> wanted_course_deg_;
  HelmSigns helm_;
  double boxes_ = 0.0;  ///< mean of the last frames
  std::optional<int> clock_steps_;
  std::optional<bool> leaks_;
  std::optional<double> charge_, room_mib_, plan_s_, memory_mib_, processor_percent_;
  bool has_log_ = false;  ///< of which something is known
  std::optional<Seconds> log_failed_since_;
  std::optional<EnergyState> energy_;
  std::optional<SurveyArea> area_;
  std::optional<Region> region_;  ///< of `area_`
  ZoneWatch zones_;               ///< of `area_`
  std::optional<HomePoint> home_;
  bool was_inside_ = false;
};

}  // namespace limpet

// SPDX-License-Identifier: MIT
// Which sensors pNav hears, and what that makes its estimate worth.
#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "apps/pNav/nav_app.hpp"
#include "apps/pNav/nav_warnings.hpp"
#include "estimation/navigation/aiding_sources.hpp"

namespace limpet {
namespace {

constexpr Seconds kGpsPause(5.0);  // fixes come once a second, some are left out
constexpr Seconds kRefusedFixPause(10.0);
constexpr Seconds kAidingPause(60.0);  // between what a further sensor says
constexpr int kRefusedInRow = 5;       // of a further sensor

}  // namespace

bool NavApp::HasFreshGps(double now) const {
  return gps_.IsFresh(now, std::max(stale_after_, kGpsPause));
}

bool NavApp::IsValid(double now) const {
  return IsFresh(imu_, now) && (IsFresh(lock_, now) || IsFresh(depth_, now) || HasFreshGps(now));
}

void NavApp::AddSources(double now, NavState& state) const {
  state.is_valid = IsValid(now);
  state.imu = imu_.At(now, stale_after_);
  state.fog = fog_.At(now, stale_after_);
  state.dvl = lock_.At(now, stale_after_);
  state.depth = depth_.At(now, stale_after_);
  state.gps = gps_.At(now, std::max(stale_after_, kGpsPause));
  state.camera = camera_.At(now, stale_after_);
  if (imu_.was_heard()) state.imu.refused = imu_refusals_.share();
  if (lock_.was_heard()) state.dvl.refused = velocity_refusals_.share();
}

void NavApp::WatchSensors(double now) {
  const auto watch = [this](const WarningId& id, bool is_silent, const char* text) {
    if (is_silent) {
      Warn(id, text);
    } else {
      ClearWarning(id);
    }
  };
  watch(warnings::kImuStale, !IsFresh(imu_, now), "no IMU_DATA within stale_after_s");
  watch(warnings::kFogStale, fog_.was_heard() && !IsFresh(fog_, now),
        "no FOG_YAW_RATE within stale_after_s: the IMU's own yaw rate serves");
  watch(warnings::kDvlStale, !IsFresh(dvl_, now), "no DVL_DATA within stale_after_s");
  watch(warnings::kDvlNoLock, !IsFresh(lock_, now), "no bottom lock within stale_after_s");
  watch(warnings::kDepthStale, !IsFresh(depth_, now), "no DEPTH_SENSOR within stale_after_s");
  watch(warnings::kSonarStale, sonar_.was_heard() && !IsFresh(sonar_, now),
        "no new OBSTACLE_SONAR within stale_after_s: obstacles show late, if at all");
  if (const int refused = navigator_.counts().fixes; refused != refused_fixes_) {
    refused_fixes_ = refused;
    refused_fix_.Note({.stamp = now, .now = now});
  }
  watch(warnings::kGpsRefused, refused_fix_.IsFresh(now, kRefusedFixPause),
        "fixes lie metres from where dead reckoning and the others have the vehicle");
  const auto fix_error = navigator_.fix_error();
  watch(warnings::kGpsWorse, fix_error && fix_error->is_too_large(),
        "fixes wander farther than they state");
  const auto reading = navigator_.surface_reading();
  watch(warnings::kDepthNotZeroed, reading.has_value(),
        "it reads a depth where fixes come, which no antenna is at");
  const auto deviation = navigator_.compass_deviation();
  watch(warnings::kCompassDeviates, deviation && deviation->is_too_large,
        "the compass is off by more than its data sheet admits");
  WatchAgreement();
  WatchUnplaced();
  watch(warnings::kFormerElsewhere, navigator_.is_former_elsewhere(),
        "the former session's frame lies elsewhere than its fixes and compass say");
  watch(
      warnings::kNavInvalid, navigator_.has_started() && !IsValid(now),
      "no attitude, or nothing else either: NAV_STATE is not valid, NAV_X and its kin are silent");
}

void NavApp::WatchAgreement() {
  const std::vector<Disagreement> found = navigator_.Disagreements();
  for (const std::string_view motion : SensorAgreement::kMotions) {
    const auto one = std::ranges::find(found, motion, &Disagreement::what);
    if (one != found.end()) {
      Warn(warnings::kSensorsDisagree.Of(std::string(motion)), one->text);
    } else {
      ClearWarning(warnings::kSensorsDisagree, std::string(motion));
    }
  }
}

void NavApp::WatchUnplaced() {
  const std::vector<UnplacedObject> unplaced = navigator_.tracker().Unplaced();
  std::string text;
  for (const UnplacedObject& one : unplaced) {
    text += fmt::format("{}{} of {} boxes near north {:.0f}, east {:.0f}", text.empty() ? "" : "; ",
                        one.color, one.boxes, one.p_W.x(), one.p_W.y());
  }
  if (unplaced.empty()) {
    ClearWarning(warnings::kObjectsUnplaced);
  } else {
    Warn(warnings::kObjectsUnplaced, text);
  }
}

void NavApp::WatchAiding(double now) {
  if (!navigator_.has_started()) return;
  aiding_awaited_ = aiding_awaited_.value_or(now);
  for (std::size_t i = 0; i < aiding_.size(); ++i) {
    const AidingWatch& watch = aiding_[i];
    const double awaited = now - *aiding_awaited_;
    if (std::min(watch.heard.Age(now).value_or(awaited), awaited) > kAidingPause.value()) {
      Warn(warnings::kAidingSilent.Of(watch.name), "nothing of it for a minute");
    } else {
      ClearWarning(warnings::kAidingSilent, watch.name);
    }
    if (navigator_.aiding().counts(static_cast<int>(i)).refused_in_row >= kRefusedInRow) {
      Warn(warnings::kAidingRefused.Of(watch.name),
           "it has said for a while what cannot be by all that is known otherwise");
    } else {
      ClearWarning(warnings::kAidingRefused, watch.name);
    }
  }
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
// What an operator sees of the navigation.
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "apps/pNav/nav_app.hpp"
#include "estimation/navigation/aiding_sources.hpp"

namespace limpet {
namespace {

/// The former object; "?" beside what it may be while that is undecided.
std::string FormerText(const FormerIdentity& former) {
  if (former.candidates.empty()) {
    return former.id ? std::to_string(*former.id) : "-";
  }
  std::string text;
  for (const FormerCandidate& candidate : former.candidates)
    text += fmt::format("{}{}?", text.empty() ? "" : " ", candidate.id);
  return text;
}

void AddLandmarks(const std::vector<Landmark>& landmarks, ReportLines& report) {
  if (landmarks.empty()) {
    report.Add("No landmarks yet.");
    return;
  }
  ReportTable table(
      {">landmark", "class", ">north", ">east", ">down", ">sd n", ">sd e", ">looks", ">former"});
  for (const Landmark& landmark : landmarks) {
    const auto sd = [&landmark](int axis) { return std::sqrt(landmark.object.cov_W(axis, axis)); };
    table.AddRow({std::to_string(landmark.id), landmark.object.color,
                  fmt::format("{:.2f}", landmark.object.p_W.x()),
                  fmt::format("{:.2f}", landmark.object.p_W.y()),
                  fmt::format("{:.2f}", landmark.object.p_W.z()), fmt::format("{:.2f}", sd(0)),
                  fmt::format("{:.2f}", sd(1)), std::to_string(landmark.detections),
                  FormerText(landmark.former)});
  }
  report.Add(table);
}

}  // namespace

void NavApp::ReportSources(ReportLines& report) const {
  NavState state;
  AddSources(now().value(), state);
  report.Blank();
  ReportTable table({"source", ">age s", "valid"});
  const auto add = [&table](const char* name, const NavSource& source) {
    table.AddRow({name, source.age ? fmt::format("{:.1f}", *source.age) : "never heard",
                  source.is_valid.value_or(false) ? "yes" : "no"});
  };
  add("IMU", state.imu), add("FOG", state.fog), add("DVL", state.dvl);
  add("depth", state.depth), add("GPS", state.gps), add("camera", state.camera);
  report.Add(table);
  report.Blank();
}

void NavApp::ReportAiding(ReportLines& report) const {
  if (aiding_.empty()) return;
  ReportTable table({"further source", ">taken", ">refused", ">late", "its own errors, 1-sigma"});
  const AidingSources& all = navigator_.aiding();
  for (int i = 0; i < all.size(); ++i) {
    const SourceCounts& counts = all.counts(i);
    std::string errors;
    if (navigator_.has_started()) {
      for (const NamedState& error : all.NamedErrorsOf(i)) {
        errors += fmt::format("{}{} {:.3f} +- {:.3f}", errors.empty() ? "" : ", ", error.name,
                              error.value, error.sd);
      }
    }
    table.AddRow({aiding_[static_cast<std::size_t>(i)].name, std::to_string(counts.taken),
                  std::to_string(counts.refused), std::to_string(counts.late), errors});
  }
  report.Add(table);
  report.Blank();
}

void NavApp::Report(ReportLines& report) const {
  const NavigatorCounts& refused = navigator_.counts();
  report.Pair("Alignment", attitude_.is_aligned() ? "done" : "under way");
  report.Pair("GPS fixes", fmt::format("{}, {} refused", gps_fixes_, refused.fixes));
  report.Pair("DVL pings", fmt::format("{}, {} without bottom lock, {} refused", dvl_pings_,
                                       dvl_pings_without_lock_, refused.velocities));
  report.Pair("IMU", fmt::format("{} outliers", attitude_.outliers()));
  report.Pair("Depths", fmt::format("{} refused", refused.depths));
  report.Pair("Frames", fmt::format("{} came too late", refused.late_frames));
  report.Pair("Out of order", fmt::format("{} of the IMU, {} of others", attitude_.refused(),
                                          refused.stale_samples));
  ReportSources(report);
  ReportAiding(report);
  if (!navigator_.has_started()) {
    report.Pair("State", "waiting for heading and a GPS fix");
    return;
  }
  if (!IsValid(now().value())) {
    report.Pair("State", "NOT VALID: below is what was last known");
  }
  const NavigatorEstimate now_at = navigator_.Estimate(now().value());
  const Eigen::Vector3d& p_WB = now_at.X_WB.p_WB;
  report.Pair("Position", fmt::format("north {:.2f}, east {:.2f}, down {:.2f} m", p_WB.x(),
                                      p_WB.y(), p_WB.z()));
  report.Pair("1-sigma", fmt::format("{:.2f}, {:.2f}, {:.2f} m", now_at.sd_p_W.x(),
                                     now_at.sd_p_W.y(), now_at.sd_p_W.z()));
  report.Pair("Heading",
              fmt::format("{:.1f} deg, 1-sigma {:.2f} deg", MoosHeadingFromYaw(now_at.X_WB.yaw),
                          Radians(now_at.sd_yaw).in_text_unit()));
  report.Pair("Velocity", fmt::format("{:.2f} ahead, {:.2f} to starboard, {:.2f} down m/s",
                                      now_at.v_B.x(), now_at.v_B.y(), now_at.v_B.z()));
  report.Pair("Altitude",
              now_at.altitude ? fmt::format("{:.2f} m", *now_at.altitude) : "no bottom lock");
  report.Pair("Smoother", fmt::format("{} poses", navigator_.node_count()));
  report.Blank();
  AddLandmarks(navigator_.Landmarks(), report);
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
// What an operator sees of the controls.
#include <cmath>

#include <fmt/format.h>

#include "apps/pPilot/pilot_app.hpp"
#include "limpet/core/frames.hpp"

namespace limpet {

const char* PilotApp::ModeText() const {
  switch (mode_) {
    case Mode::kFlying:
      return "under control";
    case Mode::kManual:
      return "left alone: manual override";
    case Mode::kWaiting:
      return "at rest: the helm has wished for nothing yet";
    case Mode::kHalted:
      return "at rest: the helm has stopped all";
    case Mode::kNoWishes:
      return "at rest: the helm is silent";
    case Mode::kNoNavigation:
      return "at rest: navigation is silent";
    case Mode::kHolding:
      return "held at this depth: safety";
    case Mode::kSurfacing:
      return "only upwards: safety";
  }
  return "";
}

void PilotApp::Report(ReportLines& report) const {
  report.Pair("Thrusters", ModeText());
  for (const auto& [name, count] : refused_) {
    report.Pair("Refused", fmt::format("{} of {}", count, name));
  }
  ReportTable table({"", ">wanted", ">is", ">error"});
  const auto add = [&table](const char* name, const Latest<double>& wanted, double is,
                            double error) {
    table.AddRow({name, wanted ? fmt::format("{:.2f}", wanted->value) : "-",
                  fmt::format("{:.2f}", is), wanted ? fmt::format("{:.2f}", error) : "-"});
  };
  if (!nav_) {
    report.Pair("Navigation", "not heard yet");
    return;
  }
  const NavState& nav = nav_->value;
  const double heading_deg = MoosHeadingFromYaw(nav.yaw);
  const double speed = std::hypot(nav.u, nav.v);
  const auto wanted = [](const Latest<double>& latest) { return latest ? latest->value : 0.0; };
  report.Blank();
  add("heading [deg]", heading_, heading_deg,
      std::remainder(wanted(heading_) - heading_deg, 360.0));
  add("speed [m/s]", speed_, speed, wanted(speed_) - speed);
  add("depth [m]", depth_, nav.down, wanted(depth_) - nav.down);
  report.Add(table);
  report.Blank();
  const auto shares = command_.Shares();
  const std::size_t count = command_.t8 ? 8 : command_.t7 ? 7 : 6;
  report.Pair("Command",
              fmt::format("{:+.2f}", fmt::join(shares.begin(), shares.begin() + count, " ")));
}

}  // namespace limpet

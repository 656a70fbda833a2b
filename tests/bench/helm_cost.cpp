// SPDX-License-Identifier: MIT
// helm_cost: what pHelm costs with twelve everyday behaviors that all run, ten times a second: its
// iterations without the network, as a share of a core. Times are of this thread's processor.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

#include "apps/pHelm/helm_app.hpp"
#include "limpet/core/clock.hpp"
#include "limpet/core/frames.hpp"
#include "limpet/core/statistics.hpp"
#include "tests/support/test_link.hpp"

namespace {

using namespace limpet;

constexpr double kTick = 0.1;  // [s]
constexpr int kTicks = 6000;   // ten minutes

constexpr const char* kBehaviors = R"(
initialize DEPLOY = true
set MODE = ACTIVE {
  DEPLOY = true
} INACTIVE

Behavior = BHV_Waypoint
{
  name = lap
  condition = MODE == ACTIVE
  points = 60,-40 : 60,-160 : 150,-160 : 180,-100 : 150,-40
  speed = 1
  lead = 8
  lead_damper = 1
  capture_radius = 3
  repeat = forever
}
Behavior = BHV_ConstantDepth
{
  name = dive
  condition = MODE == ACTIVE
  depth = 3
}
Behavior = BHV_ConstantSpeed
{
  name = speed
  pwt = 10
  speed = 0.8
}
Behavior = BHV_ConstantHeading
{
  name = course
  pwt = 5
  heading = 90
}
Behavior = BHV_MaxDepth
{
  name = deepest
  max_depth = 20
}
Behavior = BHV_MinAltitudeX
{
  name = clearance
  min_altitude = 2
}
Behavior = BHV_Loiter
{
  name = loiter
  pwt = 3
  polygon = format=radial, x=100, y=-100, radius=40, pts=8
  speed = 1
}
Behavior = BHV_StationKeep
{
  name = hold
  pwt = 2
  station_pt = 100,-100
}
Behavior = BHV_Timer
{
  name = clock
  duration = 100000
}
Behavior = BHV_OpRegionV24
{
  name = fence
  pwt = 200
  save_poly = pts={-20,20:260,20:260,-260:-20,-260}
  halt_poly = pts={-60,60:300,60:300,-300:-60,-300}
}
Behavior = BHV_AvoidObstacle
{
  name = rock
  pwt = 150
  poly = format=radial, x=100, y=-160, radius=5, pts=8
  allowable_ttc = 20
  pwt_outer_dist = 60
  pwt_inner_dist = 10
}
Behavior = BHV_AvoidObstacle
{
  name = wreck
  pwt = 150
  poly = format=radial, x=60, y=-100, radius=5, pts=8
  allowable_ttc = 20
  pwt_outer_dist = 60
  pwt_inner_dist = 10
}
)";

/// A vehicle that does at once what it is told.
void Move(const TestLink& link, NavState& nav) {
  const double speed = link.Last(topics::kDesiredSpeed).value_or(0.0);
  nav.yaw = YawFromMoosHeading(link.Last(topics::kDesiredHeading).value_or(0.0));
  nav.u = speed;
  nav.north += kTick * speed * std::cos(nav.yaw);
  nav.east += kTick * speed * std::sin(nav.yaw);
  nav.down = link.Last(topics::kDesiredDepth).value_or(0.0);
  nav.altitude = 30.0 - nav.down;
}

void Measure(const std::string& name, bool posts_ipf) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / fmt::format("helm_cost_{}", ::getpid());
  std::filesystem::create_directory(folder);
  std::ofstream(folder / "mission.bhv") << kBehaviors;
  TestLink link;
  AppContext context;
  context.name = "pHelm";
  context.link = &link;
  context.mission_folder = folder;
  HelmApp::Params params;
  params.domain = {"course:0:359:360", "speed:0:2:41", "depth:0:50:501"};
  params.post_ipf = posts_ipf;
  HelmApp app(context, params);
  std::filesystem::remove_all(folder);  // it has been read
  link.Send(app, topics::kDeploy, true);
  NavState nav;
  nav.altitude = 30.0;
  std::vector<double> times;
  double sum = 0.0;
  int stopped = 0;
  for (int i = 0; i < kTicks; ++i) {
    link.time += Seconds(kTick);
    link.Send(app, topics::kNavState, nav);
    const Seconds begin = ThreadTime();
    app.Tick(link.time);
    times.push_back((ThreadTime() - begin).value());
    sum += times.back();
    Move(link, nav);
    stopped += link.Last(topics::kDesiredSpeed).value_or(0.0) > 0.0 ? 0 : 1;
    link.published.erase(
        link.published.begin(),
        link.published.begin() + static_cast<std::ptrdiff_t>(link.published.size() / 2));
  }
  fmt::print("{:<24} {:8.3f} {:8.3f} {:8.3f} {:9.2f}   {}\n", name, 1e3 * sum / kTicks,
             1e3 * Quantile(times, 0.5), 1e3 * Quantile(times, 0.99), 100.0 * sum / kTicks / kTick,
             stopped);
}

}  // namespace

int main() {
  fmt::print("{:<24} {:>8} {:>8} {:>8} {:>9}   standing\n", "twelve behaviors, 10 Hz", "mean ms",
             "median", "p99", "% of core");
  Measure("as missions have it", false);
  Measure("with BHV_IPF", true);
  return 0;
}

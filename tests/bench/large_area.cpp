// SPDX-License-Identifier: MIT
// large_area: what decisions on where next cost over 1 000 m^2, as table1 is surveyed, over twice
// that around three zones, and over a square kilometre, from 4 m and from 9 m, in one run: edits of
// the plan per second, mean and longest decision (processor time of this thread, which is one
// core), memory at most so far, and their ratios to the first. Each is flown for so many metres as
// are given (400).
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

#include "behaviors/BHV_CoverArea.hpp"
#include "behaviors/BHV_OpRegion.hpp"
#include "limpet/core/clock.hpp"
#include "limpet/helm/view_planner.hpp"
#include "limpet/planning/lane_tours.hpp"
#include "limpet/planning/survey_tour.hpp"
#include "limpet/planning/tour_search.hpp"
#include "tests/bench/process_cost.hpp"

namespace {

using namespace limpet;

struct Cost {
  double mean = 0.0, longest = 0.0;  ///< of a decision [s]
  double edits_per_s = 0.0, seen_m2 = 0.0, peak_mb = 0.0;
  int decisions = 0;
};

SurveyArea Area(double north, double east, double band) {
  SurveyArea area;
  area.north_min = 0.0, area.north_max = north;
  area.east_min = 0.0, area.east_max = east;
  area.margin = 2.0;
  area.object_height_max = band;
  return area;
}

/// A site with zones to keep out of, around which every link of a plan must find its way.
SurveyArea AreaWithZones() {
  SurveyArea area = Area(50.0, 40.0, 2.0);
  area.keep_out = "{8,10:14,10:14,18:8,18}{24,28:32,26:30,34:24,36}{28,6:34,12:30,16}";
  return area;
}

/// Edits of a plan of the helm's ground, as it is before the dive.
double EditsPerSecond(ViewPlanner& planner, const Pose2& pose) {
  const Situation now = planner.survey().Snapshot(Seconds(0.0), pose, 0.0);
  TourJudge judge(*now.ground, *now.region, now.turn_radius);
  judge.Reset(DubinsPath(pose), {.home_W = now.next()});
  std::vector<SurveyTour> lanes = LaneTours(judge, {});
  TourSearch search(Meters(8.0), Random(1, "bench"));
  constexpr int kEdits = 2000;
  const double begun = ThreadTime().value();
  search.Improve(judge, lanes.front(), kEdits);
  return kEdits / (ThreadTime().value() - begun);
}

constexpr double kImageStep = 0.25;  // [m]

Cost Fly(const SurveyArea& area, double altitude, double way) {
  ViewParams params;
  params.survey_altitude = Meters(altitude);
  ViewPlanner planner(params, Random(1, "bench"));
  planner.SetArea(area);
  planner.survey().SetHome({.north = 1.0, .east = 1.0});
  BHV_CoverArea cover({});
  BHV_OpRegion region({});
  const std::vector<WeightedBehavior> running{{.name = "cover", .behavior = &cover},
                                              {.name = "region", .behavior = &region}};
  SurveyGrid grid(area);
  NavState nav;
  nav.north = nav.east = 3.5;
  nav.down = 5.0;
  nav.altitude = altitude;
  planner.survey().NoteAltitude(nav);
  planner.survey().UpdateGround();
  Cost cost{.edits_per_s = EditsPerSecond(planner, {nav.north, nav.east, nav.yaw})};
  double spent = 0.0;
  for (double flown = 0.0; flown < way;) {
    const double begun = ThreadTime().value();
    const auto decision = planner.DecideIfDue(running, nav, Seconds(2.0 * flown));
    const double took = ThreadTime().value() - begun;
    if (!decision || !decision->chosen) break;  // all has been seen
    ++cost.decisions;
    spent += took;
    cost.longest = std::max(cost.longest, took);
    const DubinsPath path = planner.path().Prefix(params.replan_every.value() + 0.5);
    if (path.length() < kImageStep) break;  // it is at the end
    path.Sample(kImageStep, [&](const Pose2& pose, double) {
      nav.north = pose.north, nav.east = pose.east, nav.yaw = pose.yaw;
      grid.Observe({{nav.north, nav.east, nav.down}, 0.0, 0.0, nav.yaw}, altitude, CameraModel{});
      static_cast<void>(planner.Guide(nav));
    });
    planner.survey().Apply(grid.TakeDelta());
    flown += path.length();
  }
  cost.mean = spent / std::max(1, cost.decisions);
  cost.seen_m2 = grid.coverage().seabed * static_cast<double>(grid.wanted_cells()) / 16.0;
  cost.peak_mb = Megabytes(getpid(), "VmHWM");
  return cost;
}

}  // namespace

int main(int argc, char** argv) {
  const double way = argc > 1 ? std::atof(argv[1]) : 400.0;
  fmt::print("{:<22} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9}   ratios of mean, longest, edits, peak\n",
             "area", "edits/s", "decisions", "mean [s]", "max [s]", "seen [m2]", "peak [MB]");
  std::vector<Cost> costs;
  const auto fly = [&](const std::string& name, const SurveyArea& area, double altitude) {
    const Cost cost = Fly(area, altitude, way);
    costs.push_back(cost);
    const Cost& first = costs.front();
    fmt::print(
        "{:<22} {:>9.0f} {:>9} {:>9.3f} {:>9.3f} {:>9.0f} {:>9.0f}   {:.2f} {:.2f} {:.2f} {:.2f}\n",
        name, cost.edits_per_s, cost.decisions, cost.mean, cost.longest, cost.seen_m2, cost.peak_mb,
        cost.mean / first.mean, cost.longest / first.longest, cost.edits_per_s / first.edits_per_s,
        cost.peak_mb / first.peak_mb);
  };
  fly("30 x 36 m from 4 m", Area(30.0, 36.0, 2.0), 4.0);
  fly("three zones from 4 m", AreaWithZones(), 4.0);
  fly("1 km2 from 4 m", Area(1000.0, 1000.0, 2.0), 4.0);
  fly("1 km2 from 9 m", Area(1000.0, 1000.0, 1.0), 9.0);
  return 0;
}

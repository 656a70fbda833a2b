// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "limpet/core/camera_params.hpp"
#include "limpet/core/params.hpp"
#include "limpet/helm/generator_registry.hpp"

namespace limpet {

/// How the helm decides where to go next.
struct ViewParams {
  std::string planner = "limpet";
  std::string gain = "full";
  std::string generators{};
  Meters survey_altitude{4.0};
  Meters turning_radius{3.0};
  Meters tracking_allowance{0.4};
  Meters obstacle_clearance{1.5};
  Meters replan_every{8.0};
  Meters off_track{1.5};
  Meters arrival{0.5};
  double bottom_weight = 3.0;
  double paper_lambda = 1.0;
  GeneratorParams of_generators;
  CameraParams camera;

  template <class Visitor>
  void Describe(Visitor& visit) {
    visit.Choice("planner", planner,
                 "limpet: by a plan of the whole survey, to whose end every option is completed; "
                 "lawnmower: along lanes; the paper's (P0): other bids, too",
                 {"limpet", "lawnmower", "paper"});
    visit.Choice(
        "gain", gain,
        "full, or coverage alone (no bids on objects; planner paper: [Bucci 2025] eq. (17))",
        {"full", "coverage"});
    visit("generators", generators,
          "Who offers paths, in this order, e.g. beam, gaps, tour, home, transit; empty: the "
          "planner's own");
    visit.Required("survey_altitude_m", survey_altitude, "Altitude at which options are valued",
                   InRange(Meters(0.5), Meters(100.0)));
    visit.Required("turning_radius_m", turning_radius, "Least radius of planned turns",
                   InRange(Meters(0.5), Meters(100.0)));
    visit("tracking_allowance_m", tracking_allowance,
          "Paths keep this far inside the operating region, for the pilot's error",
          InRange(Meters(0.0), Meters(10.0)));
    visit("obstacle_clearance_m", obstacle_clearance,
          "Paths keep this far off what sonar and DVL found standing in the way (MAP_OBSTACLES)",
          InRange(Meters(0.1), Meters(100.0)));
    visit("replan_every_m", replan_every, "Path after which a new decision is taken",
          InRange(Meters(1.0), Meters(1000.0)));
    visit("off_track_m", off_track, "Cross-track error that calls for a new decision",
          InRange(Meters(0.1), Meters(100.0)));
    visit("arrival_m", arrival, "A path ends this far before its last point",
          InRange(Meters(0.05), Meters(20.0)));
    visit("bottom_weight", bottom_weight,
          "Worth of new ground at the bottom against each other layer of the band",
          InRange(0.0, 100.0));
    visit("paper_lambda", paper_lambda,
          "Planner paper: weight of the object term in eqs (20), (23) of [Bucci 2025]",
          InRange(0.0, 1000.0));
    of_generators.Describe(visit);
    camera.Describe(visit);
  }
};

}  // namespace limpet

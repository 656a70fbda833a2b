// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "limpet/core/camera_params.hpp"
#include "limpet/core/params.hpp"

namespace limpet {

/// The helm's own block; behaviors have their .bhv file.
struct HelmParams {
  std::vector<std::string> behaviors{"mission.bhv"};
  std::vector<std::string> behavior_setting;
  std::vector<std::string> domain{"course:0:359:360", "speed:0:1:21", "depth:0:100:1001"};
  std::string planner = "limpet";
  std::string gain = "full";
  Meters survey_altitude{4.0};
  Meters turning_radius{3.0};
  Meters tracking_allowance{0.4};
  Meters replan_every{8.0};
  Meters off_track{1.5};
  Meters arrival{0.5};
  Meters horizon{25.0};
  int beam_width = 40;
  double bottom_weight = 4.0;
  double gap_below = 0.02;
  int paper_nodes = 100;
  double paper_lambda = 1.0;
  CameraParams camera;

  template <class Visitor>
  void Describe(Visitor& visit) {
    visit.Required("behaviors", behaviors, "Behavior files, relative to the mission folder");
    visit("behavior_setting", behavior_setting, "Overrides of behavior files: name.key=value");
    visit.Required("domain", domain, "Decision variables, name:low:high:points");
    visit.Choice("planner", planner, "Whose options: Limpet's or the paper's (P0)",
                 {"limpet", "paper"});
    visit.Choice("gain", gain, "full, or coverage alone (no bids on objects; paper: eq 17)",
                 {"full", "coverage"});
    visit.Required("survey_altitude_m", survey_altitude, "Altitude at which options are valued",
                   InRange(Meters(0.5), Meters(100.0)));
    visit.Required("turning_radius_m", turning_radius, "Least radius of planned turns",
                   InRange(Meters(0.5), Meters(100.0)));
    visit("tracking_allowance_m", tracking_allowance,
          "Paths keep this far inside the operating region, for the pilot's error",
          InRange(Meters(0.0), Meters(10.0)));
    visit("replan_every_m", replan_every, "Path after which a new decision is taken",
          InRange(Meters(1.0), Meters(1000.0)));
    visit("off_track_m", off_track, "Cross-track error that calls for a new decision",
          InRange(Meters(0.1), Meters(100.0)));
    visit("arrival_m", arrival, "A path ends this far before its last point",
          InRange(Meters(0.05), Meters(20.0)));
    visit("horizon_m", horizon, "Length of searched options", InRange(Meters(5.0), Meters(500.0)));
    visit("beam_width", beam_width, "States kept per depth of the beam search", InRange(1, 2000));
    visit("bottom_weight", bottom_weight,
          "Worth of new ground at the bottom against each other layer of the band",
          InRange(0.0, 100.0));
    visit(
        "gap_below", gap_below,
        "Paths to far gaps are offered when the search finds less useful track than this per metre",
        InRange(0.0, 1.0));
    visit("paper_nodes", paper_nodes, "Nodes of the paper's tree", InRange(10, 100000));
    visit("paper_lambda", paper_lambda, "Weight of the object term in eqs (20), (23)",
          InRange(0.0, 1000.0));
    camera.Describe(visit);
  }
};

}  // namespace limpet

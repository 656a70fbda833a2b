// SPDX-License-Identifier: MIT
// Values beyond their range, of ways to points and of other behaviors of stock missions.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/helm_flight.hpp"
#include "tests/unit/behaviors/behavior_block.hpp"

namespace limpet {
namespace {

using ::testing::ElementsAre;

TEST(ClippedValues, AreWarnedOf) {
  HelmFlight flight(BehaviorBlock("BHV_MaxDepth", "  max_depth = -3\n"));
  std::vector<std::string> ids;
  for (const auto& said : flight.host().warnings())
    ids.push_back(said.warning.id.name());
  EXPECT_THAT(ids, ElementsAre(::testing::StartsWith("BHV_VALUES_")));
}

TEST(ClippedValues, AreTakenAsStockHelmsTakeThemAndSaid) {
  const std::string blocks =
      BehaviorBlock("BHV_ConstantSpeed",
                    "  speed = -1\n  peakwidth = -1\n  duration = no-time-limit\n") +
      BehaviorBlock("BHV_ConstantHeading",
                    "  heading = 90\n  basewidth = 200\n  peakwidth = 200\n  complete_thresh = -5\n"
                    "  duration = no-time-limit\n") +
      BehaviorBlock("BHV_MaxDepth", "  max_depth = -3\n") +
      BehaviorBlock("BHV_StationKeep",
                    "  station_pt = 0,0\n  swing_time = 90\n  inner_radius = .05\n") +
      BehaviorBlock("BHV_PeriodicSurface", "  period = .5\n") +
      BehaviorBlock("BHV_Waypoint",
                    "  points = 0,0:9,9\n  repeat = 2.7\n  currix = 1.5\n  capture_radius = 5 m\n"
                    "  lead = -5\n");
  HelmFlight flight(blocks);
  std::vector<std::string> said;
  for (const ConfigProblem& line : flight.host().IgnoredLines()) {
    said.push_back(line.key + " " + line.text);
  }
  using ::testing::StartsWith;
  EXPECT_THAT(said, ElementsAre(StartsWith("speed `-1` is taken as 0; allowed: 0 to 100 mps"),
                                StartsWith("peakwidth `-1` is taken as 0"),
                                StartsWith("complete_thresh `-5` is taken as -1"),
                                StartsWith("max_depth `-3` is taken as 0"),
                                StartsWith("swing_time `90` is taken as 60"),
                                StartsWith("repeat `2.7` is taken as 2"),
                                StartsWith("currix `1.5` is taken as 1"),
                                StartsWith("capture_radius `5 m` is taken as 5"),
                                StartsWith("lead `-5` is taken as -1")));
  const std::vector<OwnedWarning> warnings = flight.host().warnings();
  EXPECT_TRUE(std::ranges::any_of(warnings, [](const OwnedWarning& warning) {
    return warning.owner == "BHV_StationKeep" &&
           warning.warning.text == "swing_time: `90` is taken as 60; allowed: 0 to 60 s";
  }));
  EXPECT_THROW(HelmFlight(BehaviorBlock("BHV_ConstantSpeed", "  speed = fast\n")), ConfigError);
}

}  // namespace
}  // namespace limpet

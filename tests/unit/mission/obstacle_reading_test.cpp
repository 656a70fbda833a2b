// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/mission/scenario.hpp"
#include "tests/unit/mission/scenario_errors.hpp"

namespace limpet {
namespace {

using ::testing::HasSubstr;

TEST(ScenarioObstacles, AreColumnsAndBoxesThatStandOnTheSeabed) {
  const Scenario scenario = ParseScenario(
      "seabed: {depth_m: 8, roughness_m: 0}\n"
      "obstacles:\n"
      "  - {name: pile, shape: column, north_m: 4, east_m: -3, radius_m: 0.4, height_m: 9}\n"
      "  - {name: wreck, shape: box, north_m: 20, east_m: 5, size_m: [6, 2], height_m: 3}\n",
      "s.yaml");
  const std::vector<UprightBody> bodies = BodiesOf(scenario);
  ASSERT_EQ(bodies.size(), 2U);
  EXPECT_NEAR(bodies[0].top(), -1.0, 1e-9);
  EXPECT_TRUE(bodies[0].Covers({4.3, -3.0}));
  EXPECT_FALSE(bodies[0].Covers({4.3, -3.3}));
  EXPECT_NEAR(bodies[1].top(), 5.0, 1e-9);
  EXPECT_TRUE(bodies[1].Covers({22.9, 5.9}));
  EXPECT_FALSE(bodies[1].Covers({20.0, 6.1}));
}

TEST(ScenarioObstacles, WhatIsWrongOfThemIsNamedWithItsLine) {
  EXPECT_THAT(ScenarioErrorsOf("obstacles:\n  - {name: a, shape: colum, north_m: 0}\n"),
              HasSubstr("s.yaml:2: obstacles[0].shape: `colum` is not allowed"));
  EXPECT_THAT(ScenarioErrorsOf("obstacles:\n  - {name: a, shape: column, north_m: 0, east_m: 0, "
                               "radius_m: 1, hight_m: 2}\n"),
              HasSubstr("obstacles[0].hight_m: unknown key; did you mean `height_m`?"));
  EXPECT_THAT(ScenarioErrorsOf("obstacles:\n  - {name: a, shape: box, north_m: 0, east_m: 0, "
                               "radius_m: 1, height_m: 2}\n"),
              AllOf(HasSubstr("a box needs a size_m"),
                    HasSubstr("obstacles[0].radius_m: a box has none; it has size_m")));
  EXPECT_THAT(ScenarioErrorsOf("obstacles:\n  - {name: a, shape: box, north_m: 0, east_m: 0, "
                               "size_m: [1], height_m: 2}\n"),
              HasSubstr("obstacles[0].size_m: a list of 1 is not allowed"));
  EXPECT_THAT(ScenarioErrorsOf("obstacles: {}\n"), HasSubstr("s.yaml:1: obstacles:"));
  EXPECT_THAT(ScenarioErrorsOf("obstacles:\n  - {shape: column}\n"),
              AllOf(HasSubstr("needs a name"), HasSubstr("needs a north_m")));
}

TEST(ScenarioObstacles, NeitherVehicleNorObjectsMayBeInsideOne) {
  const std::string pile =
      "obstacles:\n  - {name: pile, shape: column, north_m: 0, east_m: 0, radius_m: 1, height_m: ";
  EXPECT_THAT(ScenarioErrorsOf(pile + "9}\n"), HasSubstr("the vehicle starts inside `pile`"));
  EXPECT_EQ(ScenarioErrorsOf(pile + "3}\n"), "");  // it starts above it
  EXPECT_THAT(ScenarioErrorsOf("start: {north_m: 20}\nopis:\n  - {name: A, color: yellow, "
                               "discovery: [0.5, 0, 6]}\n" +
                               pile + "3}\n"),
              HasSubstr("`A` is inside `pile` in discovery"));
}

}  // namespace
}  // namespace limpet

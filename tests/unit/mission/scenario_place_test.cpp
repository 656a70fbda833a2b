// SPDX-License-Identifier: MIT
#include "limpet/mission/scenario_place.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(ScenarioPlace, IsWhereTheSimulatorReadsIt) {
  const MissionFile mission = ParseMission(
      "ProcessConfig = uSimVehicle\n{\n  scenario = ../basin/scenario.yaml\n}\n", "m.moos");
  EXPECT_EQ(ScenarioFileOf(mission, "missions/shore"), "missions/shore/../basin/scenario.yaml");
}

TEST(ScenarioPlace, IsBesideTheMissionWhereNothingIsSaid) {
  EXPECT_EQ(ScenarioFileOf(ParseMission("ProcessConfig = pNav\n{\n}\n", "m.moos"), "m"),
            "m/scenario.yaml");
}

}  // namespace
}  // namespace limpet

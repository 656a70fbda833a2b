// SPDX-License-Identifier: MIT
#include "limpet/mission/mission_places.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

MissionFile MissionWithTwoHelms() {
  return ParseMission(
      "Community = a\nWater = salt\n"
      "ProcessConfig = ANTLER\n{\n  Run = bin/pHelm @ NewConsole = false ~ helm_two\n}\n"
      "ProcessConfig = helm_two\n{\n  behaviors = a.bhv\n}\n"
      "ProcessConfig = pNav\n{\n  rate = 1\n}\n",
      "a.moos");
}

TEST(MissionPlaces, ABlockIsOfTheProgramThatIsLaunchedUnderItsName) {
  const MissionFile mission = MissionWithTwoHelms();
  EXPECT_EQ(ProgramOfBlock(*mission.Block("helm_two"), mission), "pHelm");
}

TEST(MissionPlaces, ABlockThatNothingIsLaunchedUnderIsOfItsName) {
  const MissionFile mission = MissionWithTwoHelms();
  EXPECT_EQ(ProgramOfBlock(*mission.Block("pNav"), mission), "pNav");
}

TEST(MissionPlaces, AGlobalStandsInItsLine) {
  const SourceLine line = LineOfGlobal(MissionWithTwoHelms(), "WATER");
  EXPECT_EQ(line.file, "a.moos");
  EXPECT_EQ(line.line, 2);
}

TEST(MissionPlaces, AGlobalThatIsNotSaidIsMissingInTheFile) {
  const SourceLine line = LineOfGlobal(MissionWithTwoHelms(), "vehicle_file");
  EXPECT_EQ(line.file, "a.moos");
  EXPECT_EQ(line.line, 0);
}

}  // namespace
}  // namespace limpet

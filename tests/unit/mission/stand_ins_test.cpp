// SPDX-License-Identifier: MIT
// Missions that name a stock program, read for ours.
#include "limpet/mission/stand_ins.hpp"

#include <gtest/gtest.h>

#include "limpet/mission/mission_file.hpp"

namespace limpet {
namespace {

TEST(StandIns, StartAStockHelmsMissionParkedUnlessItSaysOtherwise) {
  const MissionFile silent =
      ParseMission("ProcessConfig = pHelmIvP\n{\n  behaviors = a.bhv\n}\n", "a.moos");
  EXPECT_EQ(silent.Block("pHelmIvP")->Find("start_in_drive")->value, "false");
  for (const char* key : {"Start_In_Drive", "start_indrive", "start_engaged", "ACTIVE_START"}) {
    const MissionFile driving = ParseMission(
        std::string("ProcessConfig = pHelmIvP\n{\n  ") + key + " = true\n}\n", "a.moos");
    const ConfigEntry* said = driving.Block("pHelmIvP")->Find(key);
    ASSERT_NE(said, nullptr);
    EXPECT_EQ(said->value, "true");
    EXPECT_EQ(driving.Block("pHelmIvP")->entries.front().value, "true");
    EXPECT_TRUE(driving.Block("pHelmIvP")->Find("start_in_drive") == nullptr ||
                driving.Block("pHelmIvP")->Find("start_in_drive")->value == "true");
  }
}

TEST(StandIns, LeaveTheBlockOfOurHelmAsItIs) {
  const MissionFile mission =
      ParseMission("ProcessConfig = pHelm\n{\n  behaviors = a.bhv\n}\n", "a.moos");
  EXPECT_EQ(mission.Block("pHelm")->entries.size(), 1U);
}

TEST(StandIns, AreKnownByTheProgramThatABlocksNameIsLaunchedFrom) {
  const MissionFile mission = ParseMission(
      "ProcessConfig = ANTLER\n{\n  Run = pHelmIvP @ NewConsole = false ~ helm_two\n}\n"
      "ProcessConfig = helm_two\n{\n  behaviors = a.bhv\n}\n",
      "a.moos");
  EXPECT_EQ(mission.Block("helm_two")->Find("start_in_drive")->value, "false");
}

TEST(StandIns, TakeABlockWhoseStrayLinesMoosPassesOver) {
  const std::string lines = "\n{\n  just words\n  behaviors = ${LIMPET_NO_SUCH}.bhv\n}\n";
  const MissionFile stock = ReadMission("ProcessConfig = pHelmIvP" + lines, "a.moos", {});
  EXPECT_TRUE(stock.Block("pHelmIvP")->problems.empty());
  ASSERT_EQ(stock.warnings.size(), 2U);
  EXPECT_EQ(stock.warnings[0].Format(),
            "a.moos:3: pHelmIvP: `just words` is neither a comment (//) nor `key = value`; "
            "ignored, as by MOOS");
  EXPECT_NE(stock.warnings[1].Format().find("its bare name is left, as by MOOS"),
            std::string::npos);
  EXPECT_EQ(stock.Block("pHelmIvP")->Find("behaviors")->value, "LIMPET_NO_SUCH.bhv");
  const MissionFile ours = ReadMission("ProcessConfig = pHelm" + lines, "a.moos", {});
  EXPECT_EQ(ours.Block("pHelm")->problems.size(), 2U) << "strict in a block of ours";
}

TEST(StandIns, DoNotTakeABlockOfStockProgramsThatIsNotClosed) {
  const MissionFile stock = ReadMission("ProcessConfig = pHelmIvP\n{\n  a = 1\n", "a.moos", {});
  EXPECT_EQ(stock.Block("pHelmIvP")->problems.size(), 1U);
}

TEST(StandIns, AreOneForEachStockProgram) {
  EXPECT_EQ(OwnNameOf("pHelmIvP"), "pHelm");
  EXPECT_EQ(OwnNameOf("uSimMarine"), "uSimMarine");
  EXPECT_EQ(StandInFor("pLogger"), nullptr);
  EXPECT_FALSE(IsStoodInFor("pHelm"));
}

}  // namespace
}  // namespace limpet

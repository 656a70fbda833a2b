// SPDX-License-Identifier: MIT
#include "limpet/characterisation/detector_sheet.hpp"

#include <fstream>

#include <gmock/gmock.h>

#include "limpet/mission/detector_settings.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/characterisation/drawn_trial.hpp"

namespace limpet {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::string& Sheet() {
  static const std::string text = DetectorSheetText(
      {.detector = "network", .made_with = "limpet detect --characterise", .file = "own.yaml"},
      DrawTrial({}, 3000, 1));
  return text;
}

TEST(DetectorSheet, SaysWhatItWasMadeWith) {
  EXPECT_THAT(Sheet(), HasSubstr("# Made by: limpet detect --characterise\n"));
  EXPECT_THAT(Sheet(), HasSubstr("name: network"));
  EXPECT_THAT(Sheet(), HasSubstr("DetectorFile = own.yaml\n"));
}

TEST(DetectorSheet, NeedsEnoughBallsInEnoughCells) {
  EXPECT_FALSE(TooFewBalls(DrawTrial({}, 3000, 1)));
  const auto few = TooFewBalls(DrawTrial({}, 30, 1));
  ASSERT_TRUE(few);
  EXPECT_THAT(*few, HasSubstr("use more --worlds"));
  TrialResult one_cell = DrawTrial({}, 3000, 1);
  for (TrialLook& look : one_cell.looks)
    look.range = 1.0, look.size_px = 40.0;
  ASSERT_TRUE(TooFewBalls(one_cell));
  EXPECT_THAT(*TooFewBalls(one_cell), HasSubstr("1 of 30 cells"));
}

TEST(DetectorSheet, IsTakenByAMissionThatNamesIt) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "network.yaml") << Sheet();
  const MissionFile mission = ReadMission(
      "DetectorFile = network.yaml\nProcessConfig = pDetect\n{\n}\n"
      "ProcessConfig = pNav\n{\n}\n"
      "ProcessConfig = pMap\n{\n}\nProcessConfig = uSimCamera\n{\n}\n",
      (folder.path() / "m.moos").string(), {});
  for (const ConfigBlock& block : mission.blocks)
    EXPECT_THAT(block.problems, IsEmpty()) << block.name;
  EXPECT_EQ(mission.Block("pDetect")->Find("detector")->value, "network");
  // Every key that a block may take from such a file is in this one.
  for (const FactTaker& taker : DetectorFacts().takers)
    EXPECT_NE(mission.Block(taker.owner)->Find(taker.key), nullptr) << taker.key;
}

TEST(DetectorSheet, CountsWhatWasFoundByRangeAndSize) {
  TrialResult trial;
  trial.pictures = 10;
  for (int i = 0; i < 10; ++i) {
    TrialLook look;
    look.color = "red";
    look.range = 1.0;
    look.visibility_m = 10.0;
    look.size_px = 40.0;
    look.visible_fraction = 1.0;
    look.visible = {0.0, 0.0, 40.0, 40.0};
    if (i < 7) look.found = Box{.u = 20.0, .v = 20.0, .w = 40.0, .h = 40.0, .color = "red"};
    trial.looks.push_back(look);
  }
  const std::string text =
      DetectorSheetText({.detector = "d", .made_with = "", .file = "d.yaml"}, trial);
  EXPECT_THAT(text, HasSubstr("0.70 of 10"));
  EXPECT_THAT(text, HasSubstr("red 0.70 of 10;"));
  EXPECT_THAT(text, HasSubstr("cylinder -;")) << "none was there";
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/mission/detector_settings.hpp"

#include <fstream>
#include <string>

#include <gmock/gmock.h>

#include "limpet/mission/mission_file.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class DetectorSettings : public ::testing::Test {
 protected:
  void Say(const std::string& file, const std::string& text) {
    std::ofstream(folder_.path() / file) << text;
  }
  MissionFile Read(const std::string& text) {
    return ReadMission("DetectorFile = net.yaml\n" + text, (folder_.path() / "m.moos").string(),
                       {});
  }
  static std::string ValueIn(const MissionFile& mission, const char* block, const char* key) {
    const ConfigEntry* entry = mission.Block(block)->Find(key);
    return entry != nullptr ? entry->value : "";
  }
  TemporaryFolder folder_;
};

TEST_F(DetectorSettings, ReachEveryBlockThatTakesThem) {
  Say("net.yaml",
      "detector:\n  name: network\n"
      "believed:\n  best: 0.9\n  half_range_share: 0.7\n  least_size_px: 20\n  wrong_color: 0.2\n"
      "boxes:\n  peak: 0.95\n");
  const MissionFile mission = Read(
      "ProcessConfig = pDetect\n{\n}\nProcessConfig = pMap\n{\n}\n"
      "ProcessConfig = pNav\n{\n}\n"
      "ProcessConfig = uSimCamera\n{\n}\n");
  EXPECT_EQ(ValueIn(mission, "pDetect", "detector"), "network");
  EXPECT_EQ(ValueIn(mission, "pNav", "wrong_color_share"), "0.2");
  EXPECT_EQ(ValueIn(mission, "pMap", "detection_best"), "0.9");
  EXPECT_EQ(ValueIn(mission, "pMap", "detection_half_range"), "0.7");
  EXPECT_EQ(ValueIn(mission, "pMap", "detection_least_size_px"), "20");
  EXPECT_EQ(ValueIn(mission, "uSimCamera", "box_peak"), "0.95");
  EXPECT_EQ(ValueIn(mission, "uSimCamera", "box_faint_at"), "") << "the file does not say it";
  ASSERT_EQ(mission.fact_files.size(), 1U);
  EXPECT_THAT(mission.fact_files.front(), EndsWith("net.yaml"));
}

TEST_F(DetectorSettings, LeaveABlockItsOwnWord) {
  Say("net.yaml", "believed: {best: 0.9}\n");
  const MissionFile mission = Read("ProcessConfig = pMap\n{\n  detection_best = 0.8\n}\n");
  EXPECT_EQ(ValueIn(mission, "pMap", "detection_best"), "0.8");
}

TEST_F(DetectorSettings, OfAFileThatIsNotThereAreAProblemThatNamesTheLineAndTheKnown) {
  Say("detector.yaml", "detector: {name: network}\n");
  const MissionFile mission = Read("ProcessConfig = pMap\n{\n}\n");
  const std::vector<ConfigProblem>& problems = mission.Block("pMap")->problems;
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_THAT(problems[0].Format(),
              HasSubstr("m.moos:1: DetectorFile: there is no `net.yaml`; known: "));
  EXPECT_THAT(problems[0].Format(), HasSubstr("detector.yaml"));
}

TEST_F(DetectorSettings, AKeyThatNobodyKnowsIsAProblemThatNamesTheNearest) {
  Say("net.yaml", "believed:\n  best: 0.9\n  half_rnge_share: 1\n");
  const MissionFile mission =
      Read("ProcessConfig = pMap\n{\n}\nProcessConfig = pNodeReporter\n{\n}\n");
  const std::vector<ConfigProblem>& problems = mission.Block("pMap")->problems;
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_THAT(problems[0].Format(), HasSubstr("net.yaml:3: believed.half_rnge_share: "));
  EXPECT_THAT(problems[0].Format(), HasSubstr("did you mean `believed.half_range_share`?"));
  EXPECT_THAT(mission.Block("pNodeReporter")->problems, IsEmpty()) << "it takes nothing from it";
}

TEST_F(DetectorSettings, OfAFileThatIsNoYamlAreAProblem) {
  Say("net.yaml", "believed: {best: 0.9\n");
  const MissionFile mission = Read("ProcessConfig = pMap\n{\n}\n");
  ASSERT_EQ(mission.Block("pMap")->problems.size(), 1U);
  EXPECT_THAT(mission.Block("pMap")->problems.front().Format(), HasSubstr("net.yaml"));
}

TEST_F(DetectorSettings, MayBeBasedOnAnothers) {
  Say("base.yaml", "believed: {best: 0.9, share_full: 0.7}\n");
  Say("net.yaml", "based_on: base.yaml\nbelieved: {best: 0.85}\n");
  const MissionFile mission = Read("ProcessConfig = pMap\n{\n}\n");
  EXPECT_EQ(ValueIn(mission, "pMap", "detection_best"), "0.85");
  EXPECT_EQ(ValueIn(mission, "pMap", "detection_share_full"), "0.7");
}

TEST_F(DetectorSettings, AreNoneWhereTheMissionNamesNoFile) {
  const MissionFile mission =
      ReadMission("ProcessConfig = pMap\n{\n}\n", (folder_.path() / "m.moos").string(), {});
  EXPECT_THAT(mission.Block("pMap")->problems, IsEmpty());
  EXPECT_THAT(mission.Block("pMap")->entries, IsEmpty());
  EXPECT_THAT(mission.fact_files, IsEmpty());
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
// A survey led through another helm: pHelm tells pHelmIvP's behaviors, which steer the vehicle.
#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/runs/session_runner.hpp"
#include "limpet/scoring/session_record.hpp"
#include "limpet/topics/mission.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::Gt;

namespace fs = std::filesystem;

TEST(LedHelm, SurveysTheAreaThroughTheBehaviorsOfAStockMission) {
  const TemporaryFolder folder;
  const fs::path mission_folder = fs::path(LIMPET_SOURCE_DIR) / "missions" / "led_helm";
  SessionRecord record("discovery");
  std::map<std::string, std::set<std::string>> writers;
  int ways = 0, refused = 0, answers = 0;
  bool is_deaf = false;
  const SessionOutcome outcome = RunSession(
      LoadMission(mission_folder / "mission.moos"),
      {.session = "discovery",
       .mission_folder = mission_folder,
       .run_folder = folder.path() / "discovery",
       .prior_folder = {},
       .seed = 4},
      [&](const Message& message) {
        record.Collect(message);
        const std::string source = message.source.substr(0, message.source.find(':'));
        writers[message.name].insert(source);
        ways += message.name == "SURVEY_WAY" ? 1 : 0;
        refused += message.name == "BHV_WARNING" ? 1 : 0;
        const auto* text = std::get_if<std::string>(&message.value);
        const bool is_answer = text != nullptr && message.name == "IVPHELM_UPDATE_RESULT";
        answers += is_answer && text->find("result=success") != std::string::npos ? 1 : 0;
        is_deaf = is_deaf || (text != nullptr && message.name == "PHELM_WARNINGS" &&
                              text->find("LED_HELM_DEAF") != std::string::npos);
      });
  EXPECT_EQ(outcome.ended, "home") << outcome.cut.value_or("");
  ASSERT_FALSE(record.believed_coverage.empty());
  EXPECT_GE(record.believed_coverage.back().value.seabed, 0.95);
  EXPECT_GE(record.believed_coverage.back().value.done_band_top, 0.9);
  const std::size_t last = record.truth.size() - 1;
  EXPECT_LT(std::hypot(record.truth.north(last) - record.truth.north(0),
                       record.truth.east(last) - record.truth.east(0)),
            3.0);
  EXPECT_THAT(ways, Gt(10));
  EXPECT_EQ(refused, 0) << "updates that its behaviors do not take";
  EXPECT_GE(answers, ways) << "and says that it has taken them";
  EXPECT_FALSE(is_deaf);
  for (const char* name : {"DESIRED_HEADING", "DESIRED_SPEED", "DESIRED_DEPTH", "IVPHELM_STATE",
                           "IVPHELM_SUMMARY", "HELM_MOTION", "MODE", "WPT_STAT"}) {
    EXPECT_THAT(writers[name], ElementsAre("pHelmIvP")) << name;
  }
  for (const char* name : {"HELM_LEAD", "HELM_PATH", "HELM_BIDS", "SURVEY_DEPTH"}) {
    EXPECT_THAT(writers[name], ElementsAre("pHelm")) << name;
  }
}

}  // namespace
}  // namespace limpet

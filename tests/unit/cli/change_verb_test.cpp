// SPDX-License-Identifier: MIT
// `limpet change` against the vehicle: the command judges what two sessions saved.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "limpet/console/command_output.hpp"
#include "limpet/core/config.hpp"
#include "tests/unit/cli/change_sessions.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

TEST_F(ChangeVerbTest, SaysWhatTheVehicleSaid) {
  FlySession("discovery", {kStays, kGoes}, {-1.0, 1.0});
  FlySession("change", {kStays, kComes, kOnUnseenGround}, {-1.0, 1.5, 14.0});
  const nlohmann::json changes = Change().at("changes");
  const OpiBeliefs on_board = OnBoard();
  ASSERT_EQ(changes.size(), on_board.opis.size());
  std::map<std::string, std::string> decided;
  for (std::size_t i = 0; i < changes.size(); ++i) {
    const nlohmann::json& change = changes[i];
    const OpiBelief& opi = on_board.opis[i];
    EXPECT_EQ(change.at("decided"), NameOf(opi.decided));
    EXPECT_EQ(change.at("color"), opi.object.color);
    EXPECT_NEAR(change.at("posterior").at("confirmed"), opi.posterior.confirmed, 1e-3);
    EXPECT_NEAR(change.at("posterior").at("removed"), opi.posterior.removed, 1e-3);
    EXPECT_NEAR(change.at("posterior").at("new"), opi.posterior.appeared, 1e-3);
    EXPECT_NEAR(change.at("log_likelihood_ratio_b"), opi.log_likelihood_ratio,
                1e-3 * std::abs(opi.log_likelihood_ratio));
    decided[opi.object.color + (opi.object.p_W.y() > 10.0 ? " far" : "")] = NameOf(opi.decided);
  }
  EXPECT_EQ(decided["yellow"], "confirmed");
  EXPECT_EQ(decided["orange"], "removed");
  EXPECT_EQ(decided["green"], "new");
  EXPECT_EQ(decided["orange far"], "uncertain") << "nobody had looked there before";
}

/// Neither was flown after the other: the matches are made here, by pNav's rule.
TEST_F(ChangeVerbTest, MatchesTwoSessionsThatNeverMet) {
  FlySession("discovery", {kStays, kGoes}, {-1.0, 1.0});
  FlySession("stranger", {kStays, kComes}, {-1.0, 1.5});
  const nlohmann::json changes = Change({}, "stranger").at("changes");
  ASSERT_EQ(changes.size(), 3U);
  EXPECT_EQ(changes[0].at("decided"), "confirmed");
  EXPECT_EQ(changes[0].at("color"), "yellow");
  EXPECT_EQ(changes[1].at("decided"), "removed");
  EXPECT_EQ(changes[2].at("decided"), "new");
}

TEST_F(ChangeVerbTest, JudgesWithTheMissionsParameters) {
  FlySession("discovery", {kStays}, {1.0});
  FlySession("change", {kStays}, {1.0});
  EXPECT_EQ(Change().at("changes")[0].at("decided"), "confirmed");
  const fs::path strict = folder_.path() / "strict.moos";
  std::ofstream(strict) << "ProcessConfig = pMap\n{\n  camera_fov_across_deg = 80\n"
                           "  camera_fov_along_deg = 60\n  camera_width_px = 640\n"
                           "  camera_height_px = 480\n  object_radius_m = 0.5\n"
                           "  decide_at = 0.999\n  lookalike_prior = 0.5\n}\n";
  EXPECT_EQ(Change({"--mission", strict.string()}).at("changes")[0].at("decided"), "uncertain");
}

TEST_F(ChangeVerbTest, NamesFileAndLineOfAParameterThatIsNone) {
  FlySession("discovery", {kStays}, {1.0});
  FlySession("change", {kStays}, {1.0});
  const fs::path wrong = folder_.path() / "wrong.moos";
  std::ofstream(wrong) << "ProcessConfig = pMap\n{\n  visibilty_m = 5\n}\n";
  try {
    static_cast<void>(Change({"--mission", wrong.string()}));
    FAIL() << "took a parameter that is none";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("wrong.moos:3: visibilty_m"));
    EXPECT_THAT(error.what(), HasSubstr("visibility_m"));
  }
}

TEST_F(ChangeVerbTest, NothingComesOfTwoSessionsThatSawNothing) {
  FlySession("discovery", {}, {});
  FlySession("change", {}, {});
  EXPECT_TRUE(Change().at("changes").empty());
}

TEST_F(ChangeVerbTest, RefusesOneSessionGivenTwice) {
  FlySession("discovery", {kStays}, {1.0});
  EXPECT_THROW(static_cast<void>(Change({}, "discovery")), Refusal);
  EXPECT_THROW(static_cast<void>(Change({}, "discovery/session")), Refusal) << "by another name";
  fs::copy(folder_.path() / "discovery", folder_.path() / "copy", fs::copy_options::recursive);
  EXPECT_THROW(static_cast<void>(Change({}, "copy")), Refusal) << "a copy is no other session";
}

TEST_F(ChangeVerbTest, NotesSessionsInTheWrongOrder) {
  FlySession("discovery", {kStays}, {1.0});
  FlySession("change", {kStays}, {1.0});
  const auto said = [this](const std::string& a, const std::string& b) {
    ::testing::internal::CaptureStderr();
    ::testing::internal::CaptureStdout();
    const std::vector<std::string> words{"--session-a", (folder_.path() / a).string(),
                                         "--session-b", (folder_.path() / b).string()};
    EXPECT_EQ(RunChange(words), kOk);
    static_cast<void>(::testing::internal::GetCapturedStdout());
    return ::testing::internal::GetCapturedStderr();
  };
  EXPECT_THAT(said("change", "discovery"), HasSubstr("session B was flown before session A"));
  EXPECT_EQ(said("discovery", "change"), "");
}

TEST_F(ChangeVerbTest, NamesTheFolderThatHoldsNoSession) {
  EXPECT_THROW(static_cast<void>(Change()), ConfigError);
  EXPECT_THROW(static_cast<void>(Change({"more"})), UsageError) << "a word too many";
}

}  // namespace
}  // namespace limpet

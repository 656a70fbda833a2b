// SPDX-License-Identifier: MIT
// `limpet change` over more than two sessions.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "limpet/console/arguments.hpp"
#include "limpet/console/command_output.hpp"
#include "tests/unit/cli/change_sessions.hpp"

namespace limpet {
namespace {

using ::testing::HasSubstr;

class ChangeSeriesTest : public ChangeVerbTest {
 protected:
  std::string FolderOf(const std::string& session) { return (folder_.path() / session).string(); }
  /// The history of the object of that colour.
  static nlohmann::json HistoryOf(const nlohmann::json& series, const std::string& color) {
    const nlohmann::json& objects = series.at("objects");
    const auto found = std::ranges::find_if(
        objects, [&color](const nlohmann::json& object) { return object.at("color") == color; });
    return found == objects.end() ? nlohmann::json() : *found;
  }
};

TEST_F(ChangeSeriesTest, KnowsAgainWhatWasAwayForASession) {
  FlySession("discovery", {kStays, kGoes}, {-1.0, 1.0});
  FlySession("second", {kStays}, {-1.0, 1.0});
  FlySession("third", {kStays, kGoes, kComes}, {-1.0, 1.0});
  const nlohmann::json series = Change({"--session-c", FolderOf("third")}, "second");
  EXPECT_EQ(series.at("sessions").size(), 3U);
  EXPECT_EQ(series.at("steps").size(), 2U);
  EXPECT_EQ(series.at("objects").size(), 3U);
  EXPECT_EQ(HistoryOf(series, "yellow").at("story"), "seen in 1, confirmed in 2, confirmed in 3");
  EXPECT_EQ(HistoryOf(series, "orange").at("story"), "seen in 1, removed in 2, back in 3");
  EXPECT_EQ(HistoryOf(series, "green").at("story"), "seen in 3");
  EXPECT_EQ(series.at("changes"), series.at("steps")[1].at("changes")) << "the last step's";
}

TEST_F(ChangeSeriesTest, StaysGoneWhatStaysAway) {
  FlySession("discovery", {kStays, kGoes}, {-1.0, 1.0});
  FlySession("second", {kStays}, {-1.0, 1.0});
  FlySession("third", {kStays}, {-1.0, 1.0});
  const nlohmann::json gone =
      HistoryOf(Change({"--session-c", FolderOf("third")}, "second"), "orange");
  EXPECT_EQ(gone.at("story"), "seen in 1, removed in 2, removed in 3");
  EXPECT_EQ(gone.at("placed_in"), 1);
  EXPECT_GT(gone.at("entries")[2].at("posterior").at("removed"), 0.9);
}

/// Where nobody looked, nothing is said to have gone, or to have come back.
TEST_F(ChangeSeriesTest, ASessionThatLookedElsewhereBreaksNoHistory) {
  FlySession("discovery", {kStays, kOnUnseenGround}, {-1.0, 1.0, 14.0});
  FlySession("second", {kStays}, {-1.0, 1.0});
  FlySession("third", {kStays, kOnUnseenGround}, {-1.0, 1.0, 14.0});
  const nlohmann::json series = Change({"--session-c", FolderOf("third")}, "second");
  EXPECT_EQ(HistoryOf(series, "orange").at("story"),
            "seen in 1, not_inspected in 2, confirmed in 3");
}

/// A session that looked elsewhere does not hide that an earlier one saw the ground bare.
TEST_F(ChangeSeriesTest, WhatComesIsJudgedByTheLastSessionThatLookedThere) {
  FlySession("discovery", {kStays}, {-1.0, 1.0});
  FlySession("second", {}, {14.0});
  FlySession("third", {kStays, kComes}, {-1.0, 1.0});
  const nlohmann::json series = Change({"--session-c", FolderOf("third")}, "second");
  const nlohmann::json comes = HistoryOf(series, "green").at("entries").at(0);
  EXPECT_EQ(comes.at("decided"), "new");
  EXPECT_GT(comes.at("posterior").at("new"), 0.9);
  EXPECT_EQ(comes.at("judged_by"), 1) << "the second was not there";
  EXPECT_EQ(series.at("changes_of"), nlohmann::json({2, 3})) << "and says nothing of it";
  for (const nlohmann::json& change : series.at("changes"))
    EXPECT_NE(change.at("decided"), "new");
  const nlohmann::json stays = HistoryOf(series, "yellow").at("entries");
  EXPECT_TRUE(stays.at(0).at("judged_by").is_null());
  EXPECT_EQ(stays.at(2).at("judged_by"), 1);
}

TEST_F(ChangeSeriesTest, ATableAndAMapAreWrittenOnRequest) {
  FlySession("discovery", {kStays, kGoes}, {-1.0, 1.0});
  FlySession("second", {kStays}, {-1.0, 1.0});
  const std::string file = FolderOf("changes.csv");
  const std::vector<std::string> words{
      "--session-a", FolderOf("discovery"), "--session-b", FolderOf("second"), "--out", file,
      "--format"};
  const auto run = [&words](const std::string& format) {
    std::vector<std::string> all = words;
    all.push_back(format);
    return RunChange(all);
  };
  EXPECT_EQ(run("csv"), kOk);
  std::ifstream in(file);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  EXPECT_THAT(text, HasSubstr("\nconfirmed,yellow,"));
  EXPECT_THAT(text, HasSubstr("\nremoved,orange,"));
  EXPECT_THROW(run("csv"), Refusal) << "the file is there";
  std::filesystem::remove(file);
  EXPECT_THROW(run("geojson"), Refusal) << "the mission said no datum";
  EXPECT_THROW(run("shp"), UsageError);
  EXPECT_THROW(
      RunChange(std::vector<std::string>{"--session-a", FolderOf("discovery"), "--session-b",
                                         FolderOf("second"), "--format", "geojson", "--json"}),
      UsageError)
      << "it is one of them";
}

TEST_F(ChangeSeriesTest, ATableOfThreeSessionsSaysThatItHasTheLastStepAlone) {
  FlySession("discovery", {kStays}, {1.0});
  FlySession("second", {kStays}, {1.0});
  FlySession("third", {kStays}, {1.0});
  ::testing::internal::CaptureStderr();
  EXPECT_EQ(RunChange(std::vector<std::string>{"--session-a", FolderOf("discovery"), "--session-b",
                                               FolderOf("second"), "--session-c", FolderOf("third"),
                                               "--format", "csv", "--out", FolderOf("c.csv")}),
            kOk);
  EXPECT_THAT(::testing::internal::GetCapturedStderr(),
              HasSubstr("csv has the last step alone, session B to session C"));
}

TEST_F(ChangeSeriesTest, SessionsAreNamedWithoutGaps) {
  FlySession("discovery", {kStays}, {1.0});
  FlySession("second", {kStays}, {1.0});
  try {
    static_cast<void>(Change({"--session-d", FolderOf("second")}, "second"));
    FAIL() << "left one out";
  } catch (const UsageError& error) {
    EXPECT_THAT(error.what(), HasSubstr("--session-d without --session-c"));
  }
}

}  // namespace
}  // namespace limpet

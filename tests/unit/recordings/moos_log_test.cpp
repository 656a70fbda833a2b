// SPDX-License-Identifier: MIT
#include "limpet/recordings/moos_log.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/moos_text.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

Expected<Recording> ReadText(const std::string& text) {
  AlogReader reader = AlogReader::OfText(text);
  return ReadMoosLog(reader, "made.alog");
}

bool Lacks(const Recording& recording, const char* what) {
  return std::ranges::find(recording.missing, what, &MissingData::what) != recording.missing.end();
}

TEST(MoosLog, GivesPlacesHeadingsSpeedsAndDepths) {
  const auto recording = ReadText(MoosText({.seconds = 10.0}));
  ASSERT_TRUE(recording.has_value());
  ASSERT_EQ(recording->own.places.size(), 50U);
  EXPECT_EQ(recording->own.places.front().p_W, Eigen::Vector2d(-50.0, 100.0));
  EXPECT_EQ(recording->own.headings.size(), 50U);
  EXPECT_EQ(recording->own.speeds.back().value, 1.0);
  EXPECT_EQ(recording->depths.size(), 50U);
  EXPECT_FALSE(Lacks(*recording, "heading"));
  EXPECT_TRUE(Lacks(*recording, "roll and pitch"));
}

TEST(MoosLog, MakesNoPlaceOfNorthAndEastOfDifferentInstants) {
  const auto recording = ReadText("1.0 NAV_X a 3\n2.0 NAV_Y a 4\n2.05 NAV_X a 5\n3.0 NAV_X a 6\n");
  ASSERT_TRUE(recording.has_value());
  ASSERT_EQ(recording->own.places.size(), 1U);
  EXPECT_EQ(recording->own.places.front().p_W, Eigen::Vector2d(4.0, 5.0));
}

TEST(MoosLog, NamesVariablesOfMotionWhoseFormIsNotKnown) {
  const auto recording =
      ReadText(MoosText({.seconds = 1.0}) + "1.0 ACME_DVL_RAW iDvl 1,2,3\n1.0 NAV_ROLL a 0.1\n");
  ASSERT_TRUE(recording.has_value());
  EXPECT_THAT(recording->left_out, Contains(HasSubstr("ACME_DVL_RAW, NAV_ROLL: their form")));
}

TEST(MoosLog, CountsWhatIsNoNumber) {
  const auto recording = ReadText(MoosText({.seconds = 1.0}) + "1.0 NAV_DEPTH a deep\n");
  ASSERT_TRUE(recording.has_value());
  EXPECT_THAT(recording->left_out, Contains(HasSubstr("made.alog: 1 entries of NAV_*")));
}

TEST(MoosLog, SaysWhichLineOfAnExtractOfColumnsIsNoEntry) {
  const auto recording = ReadText("0.5\n0.6\n0.7\n");
  ASSERT_FALSE(recording.has_value());
  EXPECT_THAT(recording.error().text,
              HasSubstr("made.alog: none of 3 lines is an entry (time, variable, source, value); "
                        "made.alog:1: "));
}

TEST(MoosLog, SaysThatALogHoldsNoNavigation) {
  const auto recording = ReadText("0.5 DB_UPTIME MOOSDB 3\n");
  ASSERT_FALSE(recording.has_value());
  EXPECT_THAT(recording.error().text, HasSubstr("made.alog: holds none of NAV_X"));
}

TEST(MoosLog, TakesTheOneLogOfAFolderAndWantsOneOfSeveralNamed) {
  const TemporaryFolder folder;
  EXPECT_FALSE(IsMoosRecording(folder.path()));
  std::ofstream(folder.path() / "a.alog") << MoosText({.seconds = 5.0});
  std::ofstream(folder.path() / "columns.alog") << "0.5\n";
  ASSERT_TRUE(IsMoosRecording(folder.path()));
  EXPECT_TRUE(IsMoosRecording(folder.path() / "a.alog"));
  const auto one = LoadMoosRecording(folder.path());
  ASSERT_TRUE(one.has_value());
  EXPECT_THAT(one->left_out, Contains(HasSubstr("columns.alog: none of 1 lines")));
  std::ofstream(folder.path() / "b.alog") << MoosText({.seconds = 5.0});
  const auto two = LoadMoosRecording(folder.path());
  ASSERT_FALSE(two.has_value());
  EXPECT_THAT(two.error().text, HasSubstr("holds the logs a.alog and b.alog; name one of them"));
}

// Its extracts have neither times nor names of variables: that is said, and nothing is guessed.
TEST(MoosLog, SaysOfTheColumnsOfTheIverLogsWhatCanBeSaid) {
  const std::filesystem::path folder =
      std::filesystem::path(LIMPET_SOURCE_DIR) /
      "../shared/data/iver_umassd/simulation/iver__18_12_2016_____17_26_26";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not there";
  const auto recording = LoadMoosRecording(folder);
  ASSERT_FALSE(recording.has_value());
  EXPECT_THAT(recording.error().text, HasSubstr("nav_x.alog: none of 3765 lines is an entry"));
  EXPECT_THAT(recording.error().text, HasSubstr("nav_xy.alog: two columns of 3765 numbers"));
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/recordings/ros_csv.hpp"

#include <algorithm>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/ros_text.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

std::string ErrorOfDvl(const std::string& text) {
  Recording recording;
  const auto added = AddRosCsv(text, "dvl.csv", recording);
  return added ? "" : added.error().text;
}

TEST(RosCsv, ReadsPingsAndTakesNothingOfABadBeam) {
  Recording recording;
  ASSERT_TRUE(AddRosCsv(DvlHeader() + DvlLine({.t = 0.25, .velocity = {0.5, 0.1, 0.0}}) +
                            DvlLine({.t = 0.5, .velocity = {0.5, 0.1, 0.0}, .bad_beam = 2}),
                        "dvl.csv", recording));
  ASSERT_EQ(recording.pings.size(), 2U);
  EXPECT_NEAR(recording.pings[1].t - recording.pings[0].t, 0.25, 1e-6);
  EXPECT_EQ(*recording.pings[0].v_D, Eigen::Vector3d(0.5, 0.1, 0.0));
  EXPECT_TRUE(recording.pings[0].beam_speeds[2].has_value());
  EXPECT_FALSE(recording.pings[1].beam_speeds[2].has_value());
  EXPECT_FALSE(recording.pings[1].beam_ranges[2].has_value());
  EXPECT_EQ(recording.pings[1].altitude, 3.0);
}

TEST(RosCsv, KnowsNoVelocityAndNoAltitudeWhereTheInstrumentHasNone) {
  Recording recording;
  ASSERT_TRUE(AddRosCsv(DvlHeader() + DvlLine({.has_velocity = false, .altitude = -2.0}), "dvl.csv",
                        recording));
  EXPECT_FALSE(recording.pings.front().v_D.has_value());
  EXPECT_FALSE(recording.pings.front().altitude.has_value());
}

TEST(RosCsv, SaysThatAHeadingWhichNeverChangesIsNone) {
  Recording recording;
  ASSERT_TRUE(AddRosCsv(DvlText(30), "dvl.csv", recording));
  ASSERT_EQ(recording.missing.size(), 3U);
  EXPECT_EQ(recording.missing.front().what, "heading");
  EXPECT_EQ(recording.missing.front().reason, "dvl.csv: field.heading is 0 in all of 30 rows");
  EXPECT_THAT(recording.missing.front().cost, HasSubstr("no track"));
}

TEST(RosCsv, SaysWhyAHeadingThatChangesIsNotRead) {
  Recording recording;
  ASSERT_TRUE(AddRosCsv(
      DvlHeader() + DvlLine({.t = 1.0, .heading = 10.0}) + DvlLine({.t = 2.0, .heading = 12.0}),
      "dvl.csv", recording));
  EXPECT_EQ(recording.missing.front().reason,
            "dvl.csv: field.heading is not read: its unit and the mounting are in no column");
}

TEST(RosCsv, NamesFileLineAndColumnOfWhatIsNoNumber) {
  std::string line = DvlLine({});
  line.replace(line.rfind(",3.0"), 4, ",deep");
  EXPECT_EQ(ErrorOfDvl(DvlText(3) + line + DvlLine({})),
            "dvl.csv:5: column field.altitude is `deep`, not a number");
  EXPECT_EQ(ErrorOfDvl(DvlHeader() + "1,2,3\n"), "dvl.csv:2: has 3 columns, its header 23");
  EXPECT_THAT(ErrorOfDvl(DvlHeader() + "1,2,soon" + DvlLine({}).substr(42) + DvlLine({})),
              HasSubstr("dvl.csv:2: "));
}

TEST(RosCsv, LeavesOutALastLineThatIsCutAndSaysSo) {
  Recording recording;
  const std::string text = DvlText(10);
  ASSERT_TRUE(AddRosCsv(text.substr(0, text.size() - 20), "dvl.csv", recording));
  EXPECT_EQ(recording.pings.size(), 9U);
  EXPECT_THAT(recording.left_out, Contains(HasSubstr("dvl.csv:11: the last line is cut")));
}

TEST(RosCsv, CountsRowsThatHoldNoFiniteNumber) {
  Recording recording;
  ASSERT_TRUE(
      AddRosCsv("%time,field.depth\n1000000000,nan\n2000000000,3.5\n", "depth.csv", recording));
  ASSERT_EQ(recording.depths.size(), 1U);
  EXPECT_EQ(recording.depths.front().t, 2.0);
  EXPECT_THAT(recording.left_out, Contains(HasSubstr("depth.csv: 1 rows")));
}

TEST(RosCsv, ReadsEveryKnownTopicOfAFolderAndNamesTheOthers) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "dvl.csv") << DvlText(30);
  std::ofstream(folder.path() / "depth.csv") << DepthText(6.0);
  std::ofstream(folder.path() / "sonar.csv") << "%time,field.bins\n1,2\n";
  std::ofstream(folder.path() / "notes.csv") << "a,b\n";
  ASSERT_TRUE(IsRosRecording(folder.path()));
  const auto recording = LoadRosRecording(folder.path());
  ASSERT_TRUE(recording.has_value());
  EXPECT_EQ(recording->pings.size(), 30U);
  EXPECT_EQ(recording->depths.size(), 61U);
  EXPECT_THAT(recording->left_out, Contains(HasSubstr("sonar.csv: neither")));
  EXPECT_THAT(recording->left_out, Contains(HasSubstr("notes.csv: no topic")));
  const auto lacks = [&recording](const char* what) {
    return std::ranges::find(recording->missing, what, &MissingData::what) !=
           recording->missing.end();
  };
  EXPECT_TRUE(lacks("gyro and accelerometer"));
  EXPECT_FALSE(lacks("depth"));
}

TEST(RosCsv, IsNotAStreamOfOurOwnNorAnyOtherFolder) {
  const TemporaryFolder folder;
  EXPECT_FALSE(IsRosRecording(folder.path()));
  EXPECT_FALSE(IsRosRecording(folder.path() / "none"));
  std::ofstream(folder.path() / "depth.csv") << DepthText(1.0);
  EXPECT_TRUE(IsRosRecording(folder.path()));
  EXPECT_TRUE(IsRosRecording(folder.path() / "depth.csv"));
  std::ofstream(folder.path() / "stream.csv.gz") << "DEP,0,1,0.02\n";
  EXPECT_FALSE(IsRosRecording(folder.path()));
}

TEST(RosCsv, RefusesAFolderWithoutAnyMeasurement) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "sonar.csv") << "%time,field.bins\n1,2\n";
  const auto recording = LoadRosRecording(folder.path());
  ASSERT_FALSE(recording.has_value());
  EXPECT_THAT(recording.error().text, HasSubstr("holds no measurement\n  sonar.csv: neither"));
}

}  // namespace
}  // namespace limpet

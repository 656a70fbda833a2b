// SPDX-License-Identifier: MIT
#include "limpet/recordings/recording_check.hpp"

#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include "limpet/recordings/ros_csv.hpp"
#include "tests/support/ros_text.hpp"

namespace limpet {
namespace {

Recording Made(const std::string& dvl, const std::string& depth = "") {
  Recording recording;
  EXPECT_TRUE(AddRosCsv(dvl, "dvl.csv", recording));
  if (!depth.empty()) {
    EXPECT_TRUE(AddRosCsv(depth, "depth.csv", recording));
  }
  return recording;
}

TEST(RecordingCheck, TellsHowTheBeamsStandFromTheInstrumentsOwnVelocities) {
  const DvlCheck dvl = *Check(Made(DvlText(500))).dvl;
  ASSERT_TRUE(dvl.geometry.has_value());
  EXPECT_EQ(dvl.geometry->pings(), 400);
  for (std::size_t beam = 0; beam < 4; ++beam) {
    EXPECT_NEAR(dvl.geometry->tilts()[beam].in_text_unit(), 22.0, 0.1);
    const double off =
        dvl.geometry->azimuths()[beam].in_text_unit() - 90.0 * static_cast<double>(beam);
    EXPECT_NEAR(std::remainder(off, 360.0), 0.0, 0.5);
    EXPECT_NEAR(dvl.geometry->lengths()[beam], 1.0, 0.01);
  }
}

TEST(RecordingCheck, FindsThatThreeBeamsGiveTheInstrumentsVelocity) {
  const DvlCheck dvl = *Check(Made(DvlText(500))).dvl;
  EXPECT_EQ(dvl.four_beams, 400U);
  EXPECT_EQ(dvl.three_beams, 100U);
  EXPECT_EQ(dvl.three.count, 100U);
  EXPECT_LT(dvl.three.greatest, 0.002);
  EXPECT_LT(dvl.contradiction.greatest, 0.001);
}

TEST(RecordingCheck, ShowsABeamThatContradictsTheOthers) {
  Recording recording = Made(DvlText(500));
  const double error = 0.4;  // of the second beam; the instrument knows no better [m/s]
  for (std::size_t i = 0; i < recording.pings.size(); i += 20) {
    DvlPing& ping = recording.pings[i];
    *ping.beam_speeds[1] += error;
    ping.v_D->y() += error / (2.0 * std::sin(kMadeTilt));
    ping.v_D->z() += error / (4.0 * std::cos(kMadeTilt));
  }
  const DvlCheck dvl = *Check(recording).dvl;
  EXPECT_LT(dvl.four.greatest, 0.001);
  EXPECT_NEAR(dvl.contradiction.greatest, error / 2.0, 0.001);
  EXPECT_LT(dvl.contradiction.median, 0.001);
}

TEST(RecordingCheck, SaysNothingOfBeamsThatTooFewPingsShow) {
  const DvlCheck dvl = *Check(Made(DvlText(15))).dvl;
  EXPECT_FALSE(dvl.geometry.has_value());
  EXPECT_EQ(dvl.four.count, 0U);
}

TEST(RecordingCheck, CountsPingsWhoseBeamsWouldGiveTheVelocityThatLacks) {
  std::string text = DvlText(100);
  for (int i = 0; i < 10; ++i) {
    const double t = 20.0 + 0.2 * i;
    text += DvlLine({.t = t, .velocity = MadeVelocity(t), .has_velocity = false});
  }
  const DvlCheck dvl = *Check(Made(text)).dvl;
  EXPECT_EQ(dvl.with_velocity, 100U);
  EXPECT_EQ(dvl.velocity_from_beams, 10U);
  EXPECT_NEAR(dvl.longest_without_velocity, 2.0, 1e-6);
}

TEST(RecordingCheck, FindsTheRuleOfTheAltitude) {
  const DvlCheck dvl = *Check(Made(DvlText(100))).dvl;
  ASSERT_TRUE(dvl.altitude.has_value());
  EXPECT_EQ(dvl.altitude->rule, "the least of the beams");
  EXPECT_NEAR(dvl.altitude->differences.median, 0.0, 1e-9);
}

TEST(RecordingCheck, AddsUpThePathAndLeavesPausesOut) {
  std::string text = DvlHeader();
  for (int i = 0; i <= 100; ++i)
    text += DvlLine({.t = 0.2 * i + (i > 50 ? 10.0 : 0.0), .velocity = {0.3, 0.4, 0.0}});
  const DvlCheck dvl = *Check(Made(text)).dvl;
  EXPECT_NEAR(dvl.path.length, 0.5 * 19.8, 1e-6);
  EXPECT_NEAR(dvl.path.covered, 19.8, 1e-6);
  EXPECT_NEAR(dvl.path.left_out, 10.2, 1e-6);
  EXPECT_NEAR(dvl.times.longest_pause, 10.2, 1e-6);
}

TEST(RecordingCheck, LetsTheGateJudgeAndKeepsWhatItRefusesOutOfThePath) {
  Recording recording = Made(DvlText(500));
  for (std::size_t i = 50; i < recording.pings.size(); i += 50)
    recording.pings[i].v_D = Eigen::Vector3d(3.0, -2.0, 0.0);
  const DvlCheck dvl = *Check(recording).dvl;
  EXPECT_EQ(dvl.gate.refused, 9U);
  EXPECT_EQ(dvl.gate.good, 491U);
  EXPECT_GT(dvl.path.length, dvl.gated_path.length + 4.0);
}

TEST(RecordingCheck, ComparesTheThirdAxisWithTheDepth) {
  const RecordingCheck down = Check(Made(DvlText(500), DepthText(100.0)));
  ASSERT_TRUE(down.vertical.has_value());
  EXPECT_NEAR(down.vertical->slope, 1.0, 0.05);
  EXPECT_GT(down.vertical->correlation, 0.95);
  const RecordingCheck up = Check(Made(DvlText(500), DepthText(100.0, -1.0)));
  EXPECT_NEAR(up.vertical->slope, -1.0, 0.05);
}

TEST(RecordingCheck, GivesRangeAndRatesOfTheDepth) {
  const DepthCheck depth = *Check(Made(DvlText(5), DepthText(100.0))).depth;
  EXPECT_NEAR(depth.times.Rate(), 10.0, 1e-6);
  EXPECT_NEAR(depth.least, 20.0, 0.01);
  EXPECT_NEAR(depth.greatest, 28.0, 0.02);
  EXPECT_NEAR(depth.fastest_down, 0.2, 0.01);
}

TEST(RecordingCheck, CountsSamplesThatComeNotLaterThanTheOneBefore) {
  Recording recording;
  recording.depths = {{1.0, 3.0}, {2.0, 3.0}, {2.0, 3.0}, {1.5, 3.0}, {3.0, 3.0}};
  const DepthCheck depth = *Check(recording).depth;
  EXPECT_EQ(depth.times.untimely, 2U);
  EXPECT_EQ(depth.times.longest_pause, 1.0);
}

// An AUV in caves: its DVL's beams stand 22 deg from the vertical, and its own arithmetic is kept
// to.
TEST(RecordingCheck, HoldsOfARealRecordingOfCaves) {
  const std::filesystem::path folder =
      std::filesystem::path(LIMPET_SOURCE_DIR) / "../shared/data/caves_girona";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not there";
  const auto recording = LoadRosRecording(folder);
  ASSERT_TRUE(recording.has_value()) << recording.error().text;
  const RecordingCheck check = Check(*recording);
  const DvlCheck& dvl = *check.dvl;
  EXPECT_EQ(dvl.times.count, 5564U);
  EXPECT_EQ(dvl.with_velocity, 5082U);
  EXPECT_EQ(dvl.four_beams, 4795U);
  EXPECT_EQ(dvl.three_beams, 763U);
  ASSERT_TRUE(dvl.geometry.has_value());
  for (const Radians tilt : dvl.geometry->tilts())
    EXPECT_NEAR(tilt.in_text_unit(), 22.0, 0.1);
  EXPECT_LT(dvl.four.within_95, 1e-3);
  EXPECT_LT(dvl.three.within_95, 1e-3);
  EXPECT_NEAR(dvl.path.length, 552.5, 0.1);
  EXPECT_EQ(check.depth->times.count, 19553U);
  EXPECT_NEAR(check.depth->greatest, 18.25, 0.01);
  EXPECT_LT(check.vertical->correlation, -0.5);
  EXPECT_EQ(recording->missing.front().what, "heading");
}

}  // namespace
}  // namespace limpet

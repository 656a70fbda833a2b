// SPDX-License-Identifier: MIT
// A stream comes back from its rawlog as it went in; what of a file is not sound is said.
#include "estimation/replay/rawlog.hpp"

#include <filesystem>
#include <fstream>
#include <variant>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CObservationGPS.h>
#include <mrpt/obs/CObservationIMU.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CRawlog.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/serialization/CArchive.h>

#include "limpet/packing/gzip_bytes.hpp"
#include "tests/support/simulated_stream.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::vector<double> NumbersOf(const AttitudeEstimate& a) {
  return {a.t, a.roll, a.pitch, a.yaw, a.sd_roll, a.sd_pitch, a.sd_yaw};
}
std::vector<double> NumbersOf(const InertialInput& row) {
  return {row.t,          row.force_B.x(), row.force_B.y(), row.force_B.z(),
          row.rate_B.x(), row.rate_B.y(),  row.rate_B.z(),  row.heading};
}
std::vector<double> NumbersOf(const YawRate& row) { return {row.t, row.rate}; }
std::vector<double> NumbersOf(const DvlRow& row) {
  const Eigen::Vector3d v = row.v_WD_B.value_or(Eigen::Vector3d::Constant(-99.0));
  return {row.t,
          v.x(),
          v.y(),
          v.z(),
          row.altitude.value_or(-99.0),
          row.beams[0].value_or(-99.0),
          row.beams[3].value_or(-99.0)};
}
std::vector<double> NumbersOf(const DepthReading& row) { return {row.t, row.depth}; }
std::vector<double> NumbersOf(const ThrusterShares& row) {
  std::vector<double> all{row.t};
  all.insert(all.end(), row.shares.begin(), row.shares.end());
  return all;
}
std::vector<double> NumbersOf(const PositionFix& row) {
  return {row.t, row.p_W.x(), row.p_W.y(), row.sd};
}
std::vector<double> NumbersOf(const FrameRow& row) {
  std::vector<double> all{row.arrival, row.frame.exposure.value(),
                          static_cast<double>(row.frame.frame)};
  for (const Box& box : row.frame.boxes) {
    for (const double number : {box.u, box.v, box.w, box.h, box.confidence})
      all.push_back(number);
    all.push_back(static_cast<double>(std::hash<std::string>()(box.color) % 1000));
  }
  return all;
}
/// Kind and numbers of every row.
std::vector<std::vector<double>> RowsOf(const SensorStream& stream) {
  std::vector<std::vector<double>> rows;
  for (const StreamRow& row : stream.rows) {
    rows.push_back(std::visit([](const auto& some) { return NumbersOf(some); }, row));
    rows.back().push_back(static_cast<double>(row.index()));
  }
  return rows;
}

/// A row of every kind, at times that a text of seven digits can say.
SensorStream EveryRow() {
  SensorStream stream;
  stream.meta.camera.fx = 501.25;
  stream.meta.has_intrinsics = true;
  stream.meta.noise.depth = 0.031;
  stream.meta.opi_radius = 0.4;
  stream.meta.distortion.p2 = -0.0031;
  stream.rows = {
      AttitudeEstimate{.t = 0.1, .roll = 0.01, .yaw = 3.5, .sd_roll = 0.1, .sd_yaw = 1.0 / 3.0},
      AttitudeEstimate{.t = 0.2, .roll = 0.02, .yaw = 3.6, .sd_roll = 0.1, .sd_yaw = 0.5},
      DvlRow{.t = 0.3, .v_WD_B = Eigen::Vector3d(0.5, 1.0 / 7.0, -0.1), .altitude = 4.2},
      DvlRow{.t = 0.4, .v_WD_B = {}, .altitude = {}},
      DvlRow{.t = 0.5, .v_WD_B = {}, .altitude = 3.0, .beams = {{3.1, {}, 3.3, 3.4}}},
      DepthReading{.t = 0.6, .depth = 3.0000001},
      PositionFix{.t = 0.7, .p_W = {-12.5, 1.0 / 3.0}, .sd = 0.58},
      FrameRow{
          .arrival = 1.05,
          .frame = {.frame = 7,
                    .exposure = Seconds(0.8),
                    .boxes = {{.u = 3, .v = 4, .w = 5, .h = 6, .confidence = 0.9, .color = "1"},
                              {.u = 1, .v = 2, .w = 3, .h = 4, .confidence = 0.1, .color = "2"}}}},
      FrameRow{.arrival = 1.35, .frame = {.frame = 8, .exposure = Seconds(1.05), .boxes = {}}},
      InertialInput{.t = 1.1,
                    .force_B = {0.1, 0.2, -9.8},
                    .rate_B = {1e-3, 2e-3, 3e-3},
                    .heading = 6.0},
      YawRate{.t = 1'767'225'600.02, .rate = -1e-5},
      ThrusterShares{.t = 1'767'225'600.1, .shares = {0.1, -1.0, 1.0 / 3.0, 0, 0, 0, 0, 1.0}}};
  return stream;
}

std::string Unpacked(const std::string& packed) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "x.gz") << packed;
  return ReadUnpacked(folder.path() / "x.gz", 1U << 30U)->bytes;
}
std::string EveryRowUnpacked() { return Unpacked(ToRawlog(EveryRow()).bytes); }

/// Objects of MRPT's, one behind the other.
template <class... Objects>
std::string BytesOf(const Objects&... objects) {
  mrpt::io::CMemoryStream memory;
  auto archive = mrpt::serialization::archiveFrom(memory);
  (archive << ... << objects);
  return {static_cast<const char*>(memory.getRawBufferData()), memory.getTotalBytesCount()};
}

TEST(Rawlog, BringsEveryKindOfRowBackWithEveryBit) {
  const SensorStream before = EveryRow();
  const auto after = ParseRawlog(EveryRowUnpacked(), "x.rawlog");
  ASSERT_TRUE(after.has_value());
  EXPECT_EQ(RowsOf(*after), RowsOf(before));
  EXPECT_EQ(after->meta.camera.fx, before.meta.camera.fx);
  EXPECT_EQ(after->meta.noise.depth, before.meta.noise.depth);
  EXPECT_EQ(after->meta.distortion.p2, before.meta.distortion.p2);
  EXPECT_TRUE(after->meta.has_intrinsics && !after->meta.has_image_size);
  EXPECT_THAT(after->left_out, IsEmpty());
  EXPECT_FALSE(after->cut.has_value());
}

TEST(Rawlog, OfASimulatedSessionDiffersByTheRoundingOfTimesAlone) {
  const SensorStream before = SimulateStream({.seed = 4, .duration_s = 60.0}).stream;
  const auto after = ParseRawlog(Unpacked(ToRawlog(before).bytes), "x.rawlog");
  ASSERT_TRUE(after.has_value());
  const auto a = RowsOf(before), b = RowsOf(*after);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i].size(), b[i].size());
    EXPECT_NEAR(a[i][0], b[i][0], 1e-7);
    EXPECT_TRUE(std::equal(a[i].begin() + 1, a[i].end(), b[i].begin() + 1)) << "row " << i;
  }
}

TEST(Rawlog, IsReadWholeByMrptsOwnReader) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "x.rawlog").string();
  std::ofstream(file) << ToRawlog(EveryRow()).bytes;
  mrpt::obs::CRawlog rawlog;
  ASSERT_TRUE(rawlog.loadFromRawLogFile(file));
  EXPECT_EQ(rawlog.size(), EveryRow().rows.size() + 3) << "two sigmas and the beams on top";
  EXPECT_THAT(rawlog.getCommentText(), HasSubstr("opi_radius,0.4\n"));
}

TEST(Rawlog, ThatMrptWroteAgainIsTheSameStream) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "x.rawlog").string();
  std::ofstream(file) << ToRawlog(EveryRow()).bytes;
  mrpt::obs::CRawlog rawlog;
  ASSERT_TRUE(rawlog.loadFromRawLogFile(file));
  ASSERT_TRUE(rawlog.saveToRawLogFile(file));
  const auto again = LoadRawlog(file);
  ASSERT_TRUE(again.has_value());
  EXPECT_EQ(RowsOf(*again), RowsOf(EveryRow()));
  EXPECT_EQ(again->meta.camera.fx, 501.25);
}

TEST(Rawlog, RowsWhoseTimeIsNoneAreCounted) {
  SensorStream stream = EveryRow();
  stream.rows.emplace_back(DepthReading{.t = 1e300, .depth = 1.0});
  EXPECT_EQ(ToRawlog(stream).untimely_rows, 1);
}

TEST(Rawlog, WhatComesAgainBitForBitCountsOnce) {
  const std::string bytes = EveryRowUnpacked();
  const auto twice = ParseRawlog(bytes + bytes, "x.rawlog");
  ASSERT_TRUE(twice.has_value());
  EXPECT_EQ(RowsOf(*twice), RowsOf(EveryRow()));
  EXPECT_THAT(twice->left_out, ElementsAre(HasSubstr("13 such were dropped: each counts once")));
}

TEST(Rawlog, CutInItsLastObservationKeepsWhatComesBeforeAndSaysSo) {
  const std::string bytes = EveryRowUnpacked();
  const auto stream = ParseRawlog(std::string_view(bytes).substr(0, bytes.size() - 20), "x.rawlog");
  ASSERT_TRUE(stream.has_value());
  EXPECT_EQ(stream->rows.size(), EveryRow().rows.size() - 1);
  EXPECT_THAT(stream->cut.value_or(""), HasSubstr("x.rawlog: byte "));
  EXPECT_THAT(stream->cut.value_or(""), HasSubstr("the last observation is cut"));
}

TEST(Rawlog, WhoseGzipFileIsCutSaysSo) {
  const TemporaryFolder folder;
  const std::string packed = ToRawlog(SimulateStream({.seed = 4, .duration_s = 20.0}).stream).bytes;
  std::ofstream(folder.path() / "x.rawlog") << packed.substr(0, packed.size() / 2);
  const auto stream = LoadRawlog(folder.path() / "x.rawlog");
  ASSERT_TRUE(stream.has_value());
  EXPECT_THAT(stream->cut.value_or(""), HasSubstr("x.rawlog: the file is damaged or cut short"));
}

TEST(Rawlog, DamagedInTheMiddleLosesNoMoreThanThat) {
  std::string bytes = EveryRowUnpacked();
  const std::size_t second = bytes.find("CObservationIMU", bytes.find("CObservationIMU") + 1);
  bytes[second + 15] = '\x7f';  // the version
  const auto stream = ParseRawlog(bytes, "x.rawlog");
  ASSERT_TRUE(stream.has_value());
  EXPECT_EQ(stream->rows.size(), EveryRow().rows.size() - 1);
  EXPECT_THAT(stream->left_out, ElementsAre(HasSubstr("x.rawlog: damaged in 1 place; byte ")));
}

TEST(Rawlog, ALengthThatLiesTakesNoMemory) {
  std::string bytes = EveryRowUnpacked();
  const std::size_t label = bytes.find("attitude_sigma");
  bytes.replace(label - 4, 4, "\xff\xff\xff\x7f");
  const auto stream = ParseRawlog(bytes, "x.rawlog");
  ASSERT_TRUE(stream.has_value());
  EXPECT_THAT(stream->left_out, ElementsAre(HasSubstr("a CObservationRawDAQ that is damaged")));
}

TEST(Rawlog, AFlagThatIsNeitherTrueNorFalseIsDamage) {
  mrpt::obs::CObservationIMU imu;
  imu.sensorLabel = "mark";
  for (const auto field : {mrpt::obs::IMU_ROLL, mrpt::obs::IMU_PITCH, mrpt::obs::IMU_YAW})
    imu.set(field, 0.1);
  std::string bytes = BytesOf(imu, imu);
  const std::string flags("\0\0\0\0\0\0\0\0\0\1\1\1\0\0", 14);
  bytes.at(bytes.find(flags) + 10) = '\xfe';
  const auto stream = ParseRawlog(bytes, "x.rawlog");
  ASSERT_TRUE(stream.has_value());
  EXPECT_EQ(stream->rows.size(), 1U);
  EXPECT_THAT(stream->left_out, ElementsAre(HasSubstr("a CObservationIMU that is damaged")));
}

TEST(Rawlog, OfOtherPeopleGivesWhatItHasAndNamesTheRest) {
  mrpt::obs::CObservationIMU turned, gyro;
  for (const auto field : {mrpt::obs::IMU_ROLL, mrpt::obs::IMU_PITCH, mrpt::obs::IMU_YAW})
    turned.set(field, 0.1);
  gyro.sensorLabel = "xsens";
  gyro.set(mrpt::obs::IMU_WX, 0.1);
  const mrpt::obs::CObservationOdometry wheels;
  const auto stream = ParseRawlog(BytesOf(wheels, turned, wheels, gyro, turned), "x.rawlog");
  ASSERT_TRUE(stream.has_value());
  EXPECT_EQ(stream->rows.size(), 2U);
  EXPECT_THAT(stream->left_out, ElementsAre("x.rawlog: 1 CObservationIMU `xsens` passed over",
                                            "x.rawlog: 2 CObservationOdometry passed over"));
}

mrpt::obs::CObservationGPS FixAt(double latitude_deg, double longitude_deg, int quality) {
  mrpt::obs::gnss::Message_NMEA_GGA gga;
  gga.fields.latitude_degrees = latitude_deg, gga.fields.longitude_degrees = longitude_deg;
  gga.fields.fix_quality = static_cast<std::uint8_t>(quality);
  gga.fields.thereis_HDOP = true, gga.fields.HDOP = 2.0F;
  mrpt::obs::CObservationGPS gps;
  gps.timestamp = mrpt::Clock::fromDouble(1767225600.0);
  gps.setMsg(gga);
  return gps;
}

TEST(Rawlog, PlacesOnEarthBecomeNorthAndEastOfTheFirst) {
  const auto stream = ParseRawlog(
      BytesOf(FixAt(43.7, 10.3, 0), FixAt(43.721, 10.283, 1), FixAt(43.731, 10.293, 4)), "x");
  ASSERT_TRUE(stream.has_value());
  ASSERT_EQ(stream->rows.size(), 2U);
  const auto& first = std::get<PositionFix>(stream->rows[0]);
  const auto& second = std::get<PositionFix>(stream->rows[1]);
  EXPECT_NEAR(first.t, 1767225600.0, 1e-6);
  EXPECT_NEAR(first.p_W.norm(), 0.0, 1e-6);
  EXPECT_NEAR(first.sd, 6.0, 1e-9);
  EXPECT_NEAR(second.p_W.x(), 1111.12, 0.01) << "0.01 deg of the ellipsoid's tables";
  EXPECT_NEAR(second.p_W.y(), 805.68, 0.01);
  EXPECT_NEAR(second.sd, 0.04, 1e-9);
  EXPECT_EQ(stream->datum->latitude_deg, 43.721);
  EXPECT_THAT(stream->left_out, ElementsAre("x: 1 CObservationGPS `` passed over"));
}

TEST(Rawlog, TakesObservationsOutOfSensoryFrames) {
  auto turned = mrpt::obs::CObservationIMU::Create();
  for (const auto field : {mrpt::obs::IMU_ROLL, mrpt::obs::IMU_PITCH, mrpt::obs::IMU_YAW})
    turned->set(field, 0.1);
  mrpt::obs::CSensoryFrame frame;
  frame.insert(turned);
  const mrpt::obs::CActionCollection actions;
  const auto stream = ParseRawlog(BytesOf(actions, frame, actions, frame), "x.rawlog");
  ASSERT_TRUE(stream.has_value());
  EXPECT_EQ(stream->rows.size(), 2U);
}

TEST(Rawlog, ThatIsNoneIsRefused) {
  const auto text = ParseRawlog("t,x,y\n1,2,3\n", "x.csv");
  ASSERT_FALSE(text.has_value());
  EXPECT_THAT(text.error().text, HasSubstr("x.csv: holds no measurement that can be used"));
  EXPECT_FALSE(ParseRawlog("", "empty").has_value());
  EXPECT_FALSE(LoadRawlog("nowhere.rawlog").has_value());
}

TEST(Rawlog, WhoseMetaDataAreWrongSaysWhere) {
  std::string bytes = EveryRowUnpacked();
  const std::size_t radius = bytes.find("opi_radius,0.4");
  bytes.replace(radius, 14, "opi_radius,zer");
  const auto stream = ParseRawlog(bytes, "x.rawlog");
  ASSERT_TRUE(stream.has_value());
  EXPECT_THAT(stream->left_out, ElementsAre(HasSubstr("opi_radius is `zer`, not a number")));
}

}  // namespace
}  // namespace limpet

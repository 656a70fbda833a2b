// SPDX-License-Identifier: MIT
// The sensors of a logged run as a rawlog, by the command.
#include <algorithm>
#include <variant>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "estimation/replay/rawlog.hpp"
#include "estimation/replay/replay.hpp"
#include "limpet/core/config.hpp"
#include "limpet/vehicle_file/vehicle_file.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/log_tools/made_log.hpp"

namespace limpet {
namespace {

using ::testing::HasSubstr;

std::string Entry(double t, const char* name, const std::string& value) {
  return fmt::format("{:<15.5f} {:<20} {:<15} {} \n", t, name, "uSimSensors", value);
}

/// Half a minute at rest and level, heading north, in its last five seconds gathering speed, then
/// half a minute ahead.
std::string LogOfARun() {
  std::string log = kMadeBanner;
  for (int i = 0; i < 3000; ++i) {
    const double t = 0.02 * i, u = 0.1 * std::clamp(t - 25.0, 0.0, 5.0);
    const double fx = t >= 25.0 && t < 30.0 ? 0.1 : 0.0;
    log += Entry(t, "IMU_DATA", fmt::format("fx={},fy=0,fz=-9.81,p=0,q=0,r=0,heading=0", fx));
    log += Entry(t, "FOG_YAW_RATE", "0.00000");
    if (i % 10 == 0) {
      log += Entry(
          t, "DVL_DATA",
          fmt::format(
              "has_lock=true,u={},v=0,w=0,altitude=4,b1=4.4,sd_horizontal=0.01,sd_vertical=0.005",
              u));
      log += Entry(t, "DEPTH_SENSOR", "3.00000");
    }
    if (i % 50 == 0 && t < 20.0) log += Entry(t, "GPS_DATA", "north=7,east=-3,sd=0.4");
  }
  return log + Entry(61.0, "DETECTIONS",
                     R"({"frame":4,"exposure":1767225660.5,"boxes":[{"u":9,"v":8,"w":7,"h":6,)"
                     R"("confidence":0.9,"color":"yellow"}]})");
}

/// Commands of the thrusters, ahead and then off, and what comes of them: from 60 s on nobody
/// measures the velocity, and from 62 s on the vehicle runs out.
std::string LogOfAStopUnseen() {
  std::string log = kMadeBanner;
  double u = 0.0;  // [m/s]
  for (int i = 0; i < 5000; ++i) {
    const double t = 0.02 * i, share = t > 20.0 && t < 62.0 ? 0.26 : 0.0;
    const double force = 35.0 * share - 3.0 * u - 30.0 * u * std::abs(u);  // [N]
    log += Entry(t, "IMU_DATA",
                 fmt::format("fx={},fy=0,fz=-9.81,p=0,q=0,r=0,heading=0", force / 45.0));
    log += Entry(t, "FOG_YAW_RATE", "0.00000");
    if (i % 5 == 0) {
      log +=
          Entry(t, "THRUSTER_COMMAND", fmt::format("t1={0},t2={0},t3={0},t4={0},t5=0,t6=0", share));
    }
    if (i % 10 == 0) {
      log +=
          Entry(t, "DVL_DATA",
                t < 60.0 ? fmt::format("has_lock=true,u={},v=0,w=0,altitude=4,sd_horizontal=0.01,"
                                       "sd_vertical=0.005",
                                       u)
                         : std::string("has_lock=false"));
      log += Entry(t, "DEPTH_SENSOR", "3.00000");
    }
    if (i % 50 == 0 && t < 20.0) log += Entry(t, "GPS_DATA", "north=7,east=-3,sd=0.4");
    u += 0.02 * force / 45.0;
  }
  return log;
}

/// How far on the vehicle is thought to have gone [m].
double WayOn(const SensorStream& stream) {
  const VehicleFile vehicle = LoadMissionVehicle("feelhippo.yaml", ".");
  const ReplayResult result = Replay(
      stream,
      ParamsForVehicle(vehicle.params, vehicle.sensors, vehicle.camera.geometry(), stream.meta),
      [] { return 0.0; });
  return result.online.empty() ? 0.0 : result.online.back().X_WB.p_WB.x() - 7.0;
}

class LogRawlog : public ::testing::Test {
 protected:
  LogRawlog() { WriteLog(log_, LogOfARun()); }
  [[nodiscard]] SensorStream Convert(std::vector<std::string> more = {}) {
    std::vector<std::string> words{log_, "--out", out_};
    words.insert(words.end(), more.begin(), more.end());
    run_ = RunLogCommand(kLogRawlog, words);
    const auto stream = LoadRawlog(out_);
    EXPECT_TRUE(stream.has_value());
    return stream ? *stream : SensorStream();
  }
  template <class Row>
  static std::size_t CountOf(const SensorStream& stream) {
    return static_cast<std::size_t>(std::ranges::count_if(
        stream.rows, [](const StreamRow& row) { return std::holds_alternative<Row>(row); }));
  }
  TemporaryFolder folder_;
  std::string log_ = (folder_.path() / "run.alog").string();
  std::string out_ = (folder_.path() / "run.rawlog").string();
  LogRun run_;
};

TEST_F(LogRawlog, HoldsEveryMeasurementAtItsTime) {
  const SensorStream stream = Convert();
  EXPECT_EQ(CountOf<InertialInput>(stream), 3000U);
  EXPECT_EQ(CountOf<YawRate>(stream), 3000U);
  EXPECT_EQ(CountOf<DvlRow>(stream), 300U);
  EXPECT_EQ(CountOf<DepthReading>(stream), 300U);
  EXPECT_EQ(CountOf<PositionFix>(stream), 20U);
  EXPECT_NEAR(std::get<InertialInput>(stream.rows.front()).t, 1767225600.0, 1e-6);
  const auto& frame = std::get<FrameRow>(stream.rows.back());
  EXPECT_NEAR(frame.arrival, 1767225661.0, 1e-6);
  EXPECT_NEAR(frame.frame.exposure.value(), 1767225660.5, 1e-6);
  EXPECT_EQ(frame.frame.boxes.at(0).color, "yellow");
  EXPECT_THAT(run_.out, HasSubstr("run.rawlog: 6 621 measurements\n"));
  EXPECT_THAT(run_.out, HasSubstr("no vehicle is known"));
}

TEST_F(LogRawlog, IsReplayedByTheEstimator) {
  const SensorStream stream = Convert({"--vehicle", "feelhippo.yaml"});
  const VehicleFile vehicle = LoadMissionVehicle("feelhippo.yaml", ".");
  const ReplayResult result = Replay(
      stream,
      ParamsForVehicle(vehicle.params, vehicle.sensors, vehicle.camera.geometry(), stream.meta),
      [] { return 0.0; });
  ASSERT_FALSE(result.smoothed.empty());
  EXPECT_NEAR(result.smoothed.back().X_WB.p_WB.x(), 7.0 + 1.25 + 0.5 * 29.0, 0.3);
  EXPECT_NEAR(result.smoothed.back().X_WB.p_WB.y(), -3.0, 0.3);
  EXPECT_NEAR(result.smoothed.back().X_WB.p_WB.z(), 3.0, 0.05);
}

TEST_F(LogRawlog, CommandsOfTheThrustersTellThatTheVehicleHasStopped) {
  WriteLog(log_, LogOfAStopUnseen());
  SensorStream stream = Convert({"--vehicle", "feelhippo.yaml"});
  EXPECT_EQ(CountOf<ThrusterShares>(stream), 1000U);
  const double way = 0.5 * 38.0 + 2.0;  // about: it gathers speed from 20 s on, and runs out
  EXPECT_NEAR(WayOn(stream), way, 3.0);
  std::erase_if(stream.rows,
                [](const StreamRow& row) { return std::holds_alternative<ThrusterShares>(row); });
  EXPECT_GT(WayOn(stream), way + 8.0) << "without them it is thought to go on";
}

TEST_F(LogRawlog, HasTheCameraOfTheVehicleThatIsNamed) {
  const StreamMeta meta = Convert({"--vehicle", "feelhippo.yaml"}).meta;
  EXPECT_TRUE(meta.has_image_size && meta.has_intrinsics);
  EXPECT_EQ(meta.camera.fx, LoadMissionVehicle("feelhippo.yaml", ".").camera.geometry().fx);
}

TEST_F(LogRawlog, VelocitiesAreTurnedIntoTheVehiclesAxes) {
  std::ofstream(folder_.path() / "turned.yaml")
      << "based_on: feelhippo.yaml\ndvl:\n  yaw_deg: 90\n";
  const SensorStream stream = Convert({"--vehicle", (folder_.path() / "turned.yaml").string()});
  Eigen::Vector3d last = Eigen::Vector3d::Zero();
  for (const StreamRow& row : stream.rows)
    if (const auto* ping = std::get_if<DvlRow>(&row)) last = ping->v_WD_B.value_or(last);
  EXPECT_NEAR(last.x(), 0.0, 1e-9);
  EXPECT_NEAR(last.y(), 0.5, 1e-9);
}

TEST_F(LogRawlog, EntriesThatMakeNoSenseAreCountedAndLeftOut) {
  WriteLog(log_, LogOfARun() + Entry(61.5, "DVL_DATA", "has_lock=maybe") +
                     Entry(61.6, "DEPTH_SENSOR", "deep"));
  EXPECT_EQ(CountOf<DvlRow>(Convert()), 300U);
  EXPECT_THAT(run_.out, HasSubstr("2 left out: they make no sense\n"));
}

TEST_F(LogRawlog, ALogWithoutSensorsLeavesNoFile) {
  WriteLog(log_, std::string(kMadeBanner) + Entry(1.0, "NAV_X", "1.00000"));
  EXPECT_EQ(RunLogCommand(kLogRawlog, {log_, "--out", out_}).code, kFailed);
  EXPECT_FALSE(std::filesystem::exists(out_));
}

}  // namespace
}  // namespace limpet

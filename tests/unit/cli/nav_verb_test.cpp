// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/limpet/cli.hpp"
#include "apps/limpet/command_line.hpp"
#include "apps/limpet/verbs/nav.hpp"
#include "tests/support/moos_text.hpp"
#include "tests/support/ros_text.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// A minute straight ahead, without any object.
class NavVerbTest : public ::testing::Test {
 protected:
  NavVerbTest() {
    std::ofstream(folder_.path() / "meta.csv") << "key,v1\nopi_radius,0.5\n";
    std::ofstream rows(folder_.path() / "stream.csv.gz");
    for (int i = 0; i < 600; ++i) {
      const double t = 0.1 * i;
      rows << fmt::format("ATT,{:.2f},0,0,0,0.005,0.005,0.02\n", t);
      if (i % 2 == 0) rows << fmt::format("DVL,{:.2f},1,0.5,0,0,0.01,0.005,4,4,4,4,4\n", t);
      if (i % 2 == 0) rows << fmt::format("DEP,{:.2f},3.0,0.02\n", t);
      if (i % 10 == 0 && i < 100) rows << fmt::format("GPS,{:.2f},{:.2f},0,0.5\n", t, 0.5 * t);
    }
  }
  void AddFrame() const {
    std::ofstream(folder_.path() / "stream.csv.gz", std::ios::app) << "FRM,59.9,59.95,1,0\n";
  }
  int Run(std::vector<std::string> words) {
    ::testing::internal::CaptureStdout();
    const int code = RunNav(words);
    output_ = ::testing::internal::GetCapturedStdout();
    return code;
  }
  [[nodiscard]] std::string Text(const char* file) const {
    std::ifstream in(folder_.path() / "out" / file);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  TemporaryFolder folder_;
  std::string output_;
};

TEST_F(NavVerbTest, WritesPosesLandmarksAssociationsAndTiming) {
  EXPECT_EQ(Run({folder_.path().string(), "--out", (folder_.path() / "out").string()}), kOk);
  EXPECT_THAT(Text("smoothed.csv"), HasSubstr("t,x,y,z,roll,pitch,yaw,sd_x,sd_y,sd_z,sd_yaw\n"));
  EXPECT_THAT(Text("landmarks.csv"), HasSubstr("id,x,y,z,sd_x,sd_y,sd_z,class,looks\n"));
  EXPECT_THAT(Text("timing.json"), HasSubstr("\"p99_ms\""));
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "out/map.svg"));
}

TEST_F(NavVerbTest, SaysWhatItDoesNotKnow) {
  ASSERT_EQ(Run({folder_.path().string(), "--out", (folder_.path() / "out").string()}), kOk);
  EXPECT_THAT(output_, Not(HasSubstr("no GPS fix")));
  EXPECT_THAT(output_, HasSubstr("the depth sensor read 3.0 m where fixes came"));
  EXPECT_THAT(output_, Not(HasSubstr("no better than")));
  const TemporaryFolder blind;
  std::ofstream(blind.path() / "meta.csv") << "key,v1\nopi_radius,0.5\n";
  std::ofstream rows(blind.path() / "stream.csv.gz");
  for (int i = 0; i < 1200; ++i) {
    rows << fmt::format("ATT,{:.2f},0,0,0,0.005,0.005,0.02\nDVL,{:.2f},0,,,,,,,,,,\n", 0.1 * i,
                        0.1 * i);
  }
  rows.close();
  ASSERT_EQ(Run({blind.path().string(), "--out", (blind.path() / "out").string()}), kOk);
  EXPECT_THAT(output_, HasSubstr("no GPS fix was used: places count from the start"));
  EXPECT_THAT(output_, HasSubstr("the place was known to no better than 5 m"));
}

TEST_F(NavVerbTest, WritesHowSurelyEachPlaceWasKnown) {
  ASSERT_EQ(Run({folder_.path().string(), "--out", (folder_.path() / "out").string()}), kOk);
  const std::string online = Text("online.csv"), covariances = Text("online_covariance.csv");
  EXPECT_THAT(covariances, ::testing::StartsWith("t,xx,xy,xz,yy,yz,zz\n"));
  EXPECT_EQ(std::ranges::count(online, '\n'), std::ranges::count(covariances, '\n'));
  const std::size_t last = covariances.rfind('\n', covariances.size() - 2) + 1;
  double t = 0.0, xx = 0.0;
  ASSERT_EQ(std::sscanf(covariances.c_str() + last, "%lf,%lf", &t, &xx), 2);
  EXPECT_GT(xx, 1e-4) << "no fix is that good";
  EXPECT_LT(xx, 4.0);
}

TEST_F(NavVerbTest, WritesCurrentAndSpeedThroughTheWaterWithTheirSigmas) {
  ASSERT_EQ(Run({folder_.path().string(), "--out", (folder_.path() / "out").string()}), kOk);
  const std::string states = Text("states.csv");
  EXPECT_THAT(states, HasSubstr("t,state,value,sd\n"));
  EXPECT_THAT(states, HasSubstr(",current_north,"));
  for (const char* state : {",dvl_scale,", ",gyro_scale,", ",dvl_lever_ahead,"}) {
    EXPECT_TRUE(states.find(state) != std::string::npos) << state;
  }
  EXPECT_THAT(states, HasSubstr(",current_east,0,0.0"));
  EXPECT_THAT(states, HasSubstr(",water_speed,0."));
}

TEST_F(NavVerbTest, TakesUpWhatAnEarlierSessionLeft) {
  const std::string stream = folder_.path().string(), out = (folder_.path() / "out").string();
  ASSERT_EQ(Run({stream, "--out", out}), kOk);
  std::ofstream(folder_.path() / "out/landmarks.csv", std::ios::app)
      << "7,20,3,6,0.5,0.5,0.05,yellow,12\n";
  std::ofstream(folder_.path() / "out/landmarks_covariance.csv", std::ios::app)
      << "7,x,0.25\n7,y,0,0.25\n7,z,0,0,0.0025\n";
  EXPECT_EQ(Run({stream, "--out", (folder_.path() / "again").string(), "--former", out}), kOk);
  EXPECT_THAT(output_, HasSubstr("0 of 1 objects recognised"));
  EXPECT_TRUE(std::filesystem::exists(folder_.path() / "again/matches.csv"));
}

TEST_F(NavVerbTest, NamesFileAndLineOfAFormerSessionItDoesNotUnderstand) {
  const std::string stream = folder_.path().string(), out = (folder_.path() / "out").string();
  ASSERT_EQ(Run({stream, "--out", out}), kOk);
  std::ofstream(folder_.path() / "out/landmarks.csv", std::ios::app) << "7,twenty,3,6\n";
  ::testing::internal::CaptureStderr();
  EXPECT_EQ(Run({stream, "--out", (folder_.path() / "again").string(), "--former", out}), kFailed);
  EXPECT_THAT(::testing::internal::GetCapturedStderr(), HasSubstr("landmarks.csv:2: "));
}

TEST_F(NavVerbTest, DrawsErrorAndMapWhenAsked) {
  EXPECT_EQ(Run({folder_.path().string(), "--plot", "--out", (folder_.path() / "out").string()}),
            kOk);
  EXPECT_THAT(Text("error.svg"), HasSubstr("standard deviations"));
  EXPECT_THAT(Text("map.svg"), HasSubstr("smoothed track"));
}

TEST_F(NavVerbTest, FailsOnAFolderThatIsNoStream) {
  ::testing::internal::CaptureStderr();
  EXPECT_EQ(Run({(folder_.path() / "nowhere").string(), "--out", folder_.path().string()}),
            kFailed);
  EXPECT_THAT(::testing::internal::GetCapturedStderr(), HasSubstr("cannot be opened"));
}

TEST_F(NavVerbTest, TakesSensorsAndCameraFromTheVehiclesFile) {
  AddFrame();
  const std::string stream = folder_.path().string(), out = (folder_.path() / "out").string();
  EXPECT_EQ(Run({stream, "--out", out, "--vehicle", "feelhippo.yaml", "--plot"}), kOk);
  const std::string with_feelhippo = Text("error.svg");
  EXPECT_EQ(Run({stream, "--out", out, "--vehicle", "bluerov2.yaml", "--plot"}), kOk);
  EXPECT_TRUE(Text("error.svg") != with_feelhippo) << "its DVL is believed less: wider bounds";
}

TEST_F(NavVerbTest, AVehiclesFileThatContradictsMetaCountsAndIsSaid) {
  std::ofstream(folder_.path() / "meta.csv", std::ios::app)
      << "dvl_pos_body,0.4,0,0.1\ncam_pos_body,0.25,0,0.15\n";
  const std::string stream = folder_.path().string(), out = (folder_.path() / "out").string();
  ::testing::internal::CaptureStderr();
  EXPECT_EQ(Run({stream, "--out", out, "--vehicle", "feelhippo.yaml"}), kOk);
  const std::string said = ::testing::internal::GetCapturedStderr();
  EXPECT_THAT(said, HasSubstr("its meta.csv says dvl_pos_body 0.4, 0, 0.1, but feelhippo.yaml -0.2,"
                              " 0, 0.18: the vehicle's file counts"));
  EXPECT_THAT(said, HasSubstr("its meta.csv says cam_pos_body"));
  EXPECT_THAT(said, Not(HasSubstr("image_size")));
}

TEST_F(NavVerbTest, SaysThatAPauseMayBeAClockThatWasSet) {
  std::ofstream rows(folder_.path() / "stream.csv.gz", std::ios::app);
  for (int i = 0; i < 300; ++i) {
    rows << fmt::format("ATT,{0:.2f},0,0,0,0.005,0.005,0.02\nDEP,{0:.2f},3.0,0.02\n",
                        100.0 + 0.1 * i);
  }
  rows.close();
  ::testing::internal::CaptureStderr();
  EXPECT_EQ(Run({folder_.path().string(), "--out", (folder_.path() / "out").string()}), kOk);
  EXPECT_THAT(::testing::internal::GetCapturedStderr(),
              HasSubstr("all sensors pause or jump 40.1 s at t = 59.9 s"));
  EXPECT_EQ(Run({folder_.path().string(), "--check"}), kOk);
  EXPECT_THAT(output_, HasSubstr("In doubt\n  "));
}

TEST_F(NavVerbTest, FramesOfAStreamWhoseCameraNobodySaysAreRefused) {
  AddFrame();
  ::testing::internal::CaptureStderr();
  EXPECT_EQ(Run({folder_.path().string(), "--out", (folder_.path() / "out").string()}), kFailed);
  EXPECT_THAT(::testing::internal::GetCapturedStderr(),
              HasSubstr("meta.csv: image_size: is missing, and the stream has frames"));
}

TEST_F(NavVerbTest, OverAStreamAndOverItsRawlogEstimatesTheSame) {
  const std::string stream = folder_.path().string(), out = (folder_.path() / "out").string();
  const std::string rawlog = (folder_.path() / "x.rawlog").string();
  ASSERT_EQ(Run({stream, "--out", out, "--rawlog", rawlog}), kOk);
  std::vector<std::string> before;
  for (const char* file : {"online.csv", "smoothed.csv", "states.csv", "landmarks.csv"})
    before.push_back(Text(file));
  std::filesystem::remove_all(out);
  ASSERT_EQ(Run({rawlog, "--out", out}), kOk);
  for (const char* file : {"landmarks.csv", "states.csv", "smoothed.csv", "online.csv"}) {
    EXPECT_EQ(Text(file), before.back()) << file;
    before.pop_back();
  }
}

TEST_F(NavVerbTest, WritesNoRawlogOverAFileUnlessForced) {
  const std::string stream = folder_.path().string(), out = (folder_.path() / "out").string();
  const std::string rawlog = (folder_.path() / "x.rawlog").string();
  std::ofstream(rawlog) << "mine";
  ::testing::internal::CaptureStderr();
  EXPECT_EQ(RunCommandLine({"nav", stream, "--out", out, "--rawlog", rawlog}), kRefused);
  EXPECT_THAT(::testing::internal::GetCapturedStderr(), HasSubstr("--force writes over it"));
  EXPECT_EQ(std::filesystem::file_size(rawlog), 4U);
  EXPECT_EQ(Run({stream, "--out", out, "--rawlog", rawlog, "--force"}), kOk);
  EXPECT_GT(std::filesystem::file_size(rawlog), 1000U);
}

TEST_F(NavVerbTest, SaysWhatOfACutRawlogItUsed) {
  const std::string stream = folder_.path().string(), out = (folder_.path() / "out").string();
  const std::filesystem::path rawlog = folder_.path() / "x.rawlog";
  ASSERT_EQ(Run({stream, "--out", out, "--rawlog", rawlog.string()}), kOk);
  std::filesystem::resize_file(rawlog, std::filesystem::file_size(rawlog) / 2);
  ::testing::internal::CaptureStderr();
  EXPECT_EQ(Run({rawlog.string(), "--out", out}), kOk);
  EXPECT_THAT(::testing::internal::GetCapturedStderr(),
              HasSubstr("unexpected end of file); what comes before was used"));
}

TEST_F(NavVerbTest, RefusesAFileThatIsNoRawlog) {
  ::testing::internal::CaptureStderr();
  EXPECT_EQ(Run({(folder_.path() / "meta.csv").string(), "--out", folder_.path().string()}),
            kFailed);
  EXPECT_THAT(::testing::internal::GetCapturedStderr(),
              HasSubstr("meta.csv: holds no measurement that can be used"));
}

TEST_F(NavVerbTest, AVehicleThatIsNowhereIsNamedWithThoseThereAre) {
  ::testing::internal::CaptureStderr();
  EXPECT_NE(Run({folder_.path().string(), "--out", (folder_.path() / "out").string(), "--vehicle",
                 "dolphin.yaml"}),
            kOk);
  EXPECT_THAT(::testing::internal::GetCapturedStderr(),
              HasSubstr("there is no `dolphin.yaml`; known: bluerov2.yaml, feelhippo.yaml"));
}

TEST_F(NavVerbTest, ChecksAStreamAndEstimatesNothing) {
  EXPECT_EQ(Run({folder_.path().string(), "--check"}), kOk);
  EXPECT_THAT(output_, HasSubstr("300 in 59.8 s, 5.00 per second"));
  EXPECT_THAT(output_, HasSubstr("camera frames: no row says it"));
  EXPECT_EQ(RunCommandLine({"nav", folder_.path().string(), "--check", "--out", "x"}), kUsage);
  EXPECT_EQ(RunCommandLine({"nav", folder_.path().string()}), kUsage);
}

/// What another vehicle recorded: topics of ROS as CSV, without any attitude.
class NavVerbOfRosTest : public NavVerbTest {
 protected:
  NavVerbOfRosTest() {
    std::filesystem::create_directory(ros_);
    std::ofstream(ros_ / "dvl.csv") << DvlText(300);
    std::ofstream(ros_ / "depth.csv") << DepthText(60.0);
  }
  std::filesystem::path ros_ = folder_.path() / "ros";
};

TEST_F(NavVerbOfRosTest, SaysWhatTheRecordingHoldsAndWhatOfItAgrees) {
  EXPECT_EQ(Run({ros_.string(), "--check"}), kOk);
  EXPECT_THAT(output_, HasSubstr("four in 240, three in 60, fewer in 0"));
  EXPECT_THAT(output_, HasSubstr("22.0 at 0, 22.0 at 90"));
  EXPECT_THAT(output_, HasSubstr("passes 300, believes 0"));
  EXPECT_THAT(output_, HasSubstr("heading: dvl.csv: field.heading is 0 in all of 300 rows"));
}

TEST_F(NavVerbOfRosTest, SaysItToProgramsToo) {
  EXPECT_EQ(Run({ros_.string(), "--check", "--json"}), kOk);
  EXPECT_THAT(output_, HasSubstr("\"three_beams\": 60"));
  EXPECT_THAT(output_, HasSubstr("\"what\": \"heading\""));
}

TEST_F(NavVerbOfRosTest, RefusesToReckonATrackWithoutAHeadingAndSaysWhatLacks) {
  ::testing::internal::CaptureStderr();
  EXPECT_EQ(RunCommandLine({"nav", ros_.string(), "--out", (folder_.path() / "out").string()}),
            kRefused);
  const std::string said = ::testing::internal::GetCapturedStderr();
  EXPECT_THAT(said, HasSubstr("no track can be reckoned from it; missing are"));
  EXPECT_THAT(said, HasSubstr("heading: dvl.csv: field.heading is 0"));
  EXPECT_THAT(said, HasSubstr("--check` says what it holds"));
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "out"));
}

TEST_F(NavVerbOfRosTest, NamesFileLineAndColumnOfWhatItCannotRead) {
  std::ofstream(ros_ / "depth.csv") << "%time,field.depth\n1,2.5\n2,deep\n";
  ::testing::internal::CaptureStderr();
  EXPECT_EQ(Run({ros_.string(), "--check"}), kFailed);
  EXPECT_THAT(::testing::internal::GetCapturedStderr(),
              HasSubstr("depth.csv:3: column field.depth is `deep`, not a number"));
}

/// The log of another vehicle, by MOOS.
class NavVerbOfMoosTest : public NavVerbTest {
 protected:
  void Log(const MadeLog& log) { std::ofstream(log_) << MoosText(log); }
  std::filesystem::path log_ = folder_.path() / "other.alog";
  std::string out_ = (folder_.path() / "out").string();
};

TEST_F(NavVerbOfMoosTest, ReckonsATrackAndComparesItWithTheVehiclesOwn) {
  Log({});
  EXPECT_EQ(Run({log_.string(), "--out", out_, "--vehicle", "feelhippo.yaml"}), kOk);
  EXPECT_THAT(output_, HasSubstr("against the recording's own places: 0."));
  EXPECT_THAT(output_, HasSubstr("of a path of 159."));
  EXPECT_THAT(Text("smoothed.csv"), HasSubstr("t,x,y,z,roll,pitch,yaw,sd_x,sd_y,sd_z,sd_yaw\n"));
}

TEST_F(NavVerbOfMoosTest, SaysWhatItHadToAssume) {
  Log({});
  ::testing::internal::CaptureStderr();
  EXPECT_EQ(Run({log_.string(), "--out", out_, "--vehicle", "feelhippo.yaml"}), kOk);
  const std::string said = ::testing::internal::GetCapturedStderr();
  EXPECT_THAT(said, HasSubstr("a level vehicle was assumed that goes ahead at NAV_SPEED"));
  EXPECT_THAT(said, HasSubstr("roll and pitch: other.alog: no "));
}

TEST_F(NavVerbOfMoosTest, WantsAVehicleAndAHeading) {
  Log({});
  ::testing::internal::CaptureStderr();
  EXPECT_EQ(RunCommandLine({"nav", log_.string(), "--out", out_}), kRefused);
  Log({.has_heading = false});
  EXPECT_EQ(RunCommandLine({"nav", log_.string(), "--out", out_, "--vehicle", "feelhippo.yaml"}),
            kRefused);
  const std::string said = ::testing::internal::GetCapturedStderr();
  EXPECT_THAT(said, HasSubstr("does not say its sensors' noise; --vehicle FILE does"));
  EXPECT_THAT(said, HasSubstr("heading: other.alog: no NAV_HEADING; no track can be reckoned"));
}

TEST_F(NavVerbOfMoosTest, ChecksPlacesAgainstSpeedsAndHeadings) {
  Log({.course_off = 20.0});
  EXPECT_EQ(Run({log_.string(), "--check"}), kOk);
  EXPECT_THAT(output_, HasSubstr("159.8 m by its places, 159.8 m by its speeds"));
  EXPECT_THAT(output_, HasSubstr("median 20.0"));
}

/// A track whose fixes end after ten seconds, and a positioning system that goes on.
class NavVerbSourcesTest : public NavVerbTest {
 protected:
  NavVerbSourcesTest() {
    std::ofstream rows(folder_.path() / "sources.csv");
    rows << "t,variable,value\n";
    for (int i = 10; i < 59; ++i) {
      rows << fmt::format("{},USBL_FIX,north={:.2f},east=0,down=3,sd=0.5\n", i, 0.5 * i);
      rows << fmt::format("{},BEACON_RANGE,{:.3f}\n", i, std::hypot(0.5 * i - 15.0, 20.0, 2.0));
    }
  }
};

TEST_F(NavVerbSourcesTest, SaysWhatItLeavesOut) {
  EXPECT_EQ(Run({folder_.path().string(), "--out", (folder_.path() / "out").string()}), kOk);
  EXPECT_THAT(output_, HasSubstr("49 rows of BEACON_RANGE were not used"));
  EXPECT_THAT(output_, HasSubstr("49 rows of USBL_FIX were not used"));
}

TEST_F(NavVerbSourcesTest, HearsTheSourcesThatAreNamed) {
  EXPECT_EQ(Run({folder_.path().string(), "--out", (folder_.path() / "out").string(), "--sources",
                 "beacon_range, magnetic_heading; beacon_range_at_m = 15, 20, 5"}),
            kOk);
  EXPECT_THAT(output_, HasSubstr("beacon_range: 49 rows of BEACON_RANGE; 49 taken, 0 refused"));
  EXPECT_THAT(output_, HasSubstr("magnetic_heading: no row of "));
  std::ostringstream states;
  states << std::ifstream(folder_.path() / "out" / "states.csv").rdbuf();
  EXPECT_THAT(states.str(), HasSubstr(",beacon_off_north_m,")) << "where the beacon really is";
  EXPECT_THAT(output_, HasSubstr("49 rows of USBL_FIX were not used"));
}

TEST_F(NavVerbSourcesTest, RefusesAKeyThatNoNamedSourceHas) {
  EXPECT_EQ(Run({folder_.path().string(), "--out", (folder_.path() / "out").string(), "--sources",
                 "acoustic_fix; acoustic_fix_sgma_m = 2"}),
            kFailed);
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "out"));
}

}  // namespace
}  // namespace limpet

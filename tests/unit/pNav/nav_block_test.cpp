// SPDX-License-Identifier: MIT
// pNav's block in a mission file: its own keys and those of the measurement sources that it names.
#include "apps/pNav/nav_block.hpp"

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/app/registry.hpp"
#include "tests/support/test_link.hpp"

namespace limpet {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Lines = std::vector<std::pair<std::string, std::string>>;

/// With what the mission's globals and the vehicle's file say, which stand in lines 2 to 6.
ConfigBlock Block(const Lines& lines) {
  ConfigBlock block{.name = "pNav", .where = {"m.moos", 1}, .entries = {}};
  Lines all{{"opi_radius_m", "0.5"},
            {"camera_fov_across_deg", "80"},
            {"camera_fov_along_deg", "60"},
            {"camera_width_px", "640"},
            {"camera_height_px", "480"}};
  all.insert(all.end(), lines.begin(), lines.end());
  for (const auto& [key, value] : all) {
    block.entries.push_back({key, value, {"m.moos", static_cast<int>(block.entries.size()) + 2}});
  }
  return block;
}

std::string ProblemsOf(const Lines& lines) {
  std::string text;
  for (const ConfigProblem& problem : AppRegistry().at("pNav").check(Block(lines))) {
    text += problem.Format() + "\n";
  }
  return text;
}

TEST(NavBlock, TakesTheKeysOfItsSources) {
  EXPECT_THAT(ProblemsOf({{"sources", "acoustic_fix, beacon_range"},
                          {"acoustic_fix_sigma_m", "2"},
                          {"beacon_range_at_m", "10, 20, 8"}}),
              IsEmpty());
  EXPECT_THAT(ProblemsOf({{"sources", "none"}}), IsEmpty());
}

TEST(NavBlock, ARadiusOfAClassThatIsNoneIsAnError) {
  EXPECT_THAT(ProblemsOf({{"opi_radius_by_class", "yellow:0.4"}}), IsEmpty());
  EXPECT_THAT(ProblemsOf({{"opi_radius_by_class", "yellow=0.4"}}),
              AllOf(HasSubstr("m.moos:7"), HasSubstr("opi_radius_by_class")));
}

TEST(NavBlock, ABeaconMustSayWhereItIs) {
  EXPECT_THAT(ProblemsOf({{"sources", "beacon_range"}}), HasSubstr("beacon_range_at_m"));
}

TEST(NavBlock, AKeyOfASourceThatIsNotHeardIsAnError) {
  EXPECT_THAT(ProblemsOf({{"acoustic_fix_sigma_m", "2"}}),
              AllOf(HasSubstr("m.moos:7"), HasSubstr("acoustic_fix_sigma_m")));
}

TEST(NavBlock, AnUnknownSourceIsOneProblemThatNamesTheNearest) {
  EXPECT_THAT(ProblemsOf({{"sources", "acustic_fix"}, {"acoustic_fix_sigma_m", "2"}}),
              AllOf(HasSubstr("did you mean `acoustic_fix`?"),
                    ::testing::Not(HasSubstr("acoustic_fix_sigma_m"))));
}

TEST(NavBlock, ASourceIsNamedOnce) {
  EXPECT_THAT(ProblemsOf({{"sources", "acoustic_fix, acoustic_fix"}}), HasSubstr("twice"));
}

TEST(NavBlock, WhatDeadReckoningStandsOnIsNamedUnderSensors) {
  EXPECT_THAT(ProblemsOf({{"sensors", "imu, dvl, depth, gps"}, {"dvl_variable", "NUCLEUS_DVL"}}),
              IsEmpty());
  EXPECT_THAT(ProblemsOf({{"sensors", "imu, dvll"}}),
              AllOf(HasSubstr("m.moos:7"), HasSubstr("did you mean `dvl`?")));
  EXPECT_THAT(ProblemsOf({{"sensors", "imu, acoustic_fix"}}), HasSubstr("`sources` names it"));
  EXPECT_THAT(ProblemsOf({{"sources", "gps"}}), HasSubstr("`sensors` names it"));
}

TEST(NavBlock, AKeyOfASensorThatIsNotHeardIsAnError) {
  EXPECT_THAT(ProblemsOf({{"sensors", "imu, dvl, depth, gps"}, {"fog_variable", "KVH"}}),
              HasSubstr("fog_variable"));
}

TEST(NavBlock, SourcesOfACommandLineBringNoKeysOfSensors) {
  EXPECT_EQ(ParseSources("acoustic_fix; acoustic_fix_sigma_m = 2").size(), 1U);
  EXPECT_THROW(static_cast<void>(ParseSources("acoustic_fix; dvl_variable = NUCLEUS_DVL")),
               ConfigError);
}

TEST(NavBlock, SensorsAreHeardUnderTheNamesThatItGives) {
  TestLink link;
  AppContext context;
  context.name = "pNav";
  context.link = &link;
  context.globals = {{"VehicleFile", "feelhippo.yaml", {}}};
  const auto app =
      CreateNavApp(context, Block({{"sensors", "imu, dvl, gps"}, {"dvl_variable", "NUCLEUS_DVL"}}));
  const auto has_lock_of = [&](const std::string& variable) {
    Topic<DvlSample> said = topics::kDvlData;
    said.name = variable;
    for (int i = 0; i < 1000; ++i) {
      link.time = link.time + Seconds(0.02);
      link.Send(*app, topics::kImuData, ImuSample{.fz = -9.81});
      link.Send(*app, topics::kGpsData, GpsFix{.sd = 0.5});
      DvlSample at_rest;
      at_rest.has_lock = true;
      at_rest.u = at_rest.v = at_rest.w = 0.0;
      link.Send(*app, said, at_rest);
      if (i % 5 == 0) app->Tick(link.time);
    }
    return link.Last(topics::kNavState)->dvl.is_valid.value_or(false);
  };
  link.time = Seconds(1767225600.0);
  EXPECT_FALSE(has_lock_of("DVL_DATA"));
  EXPECT_TRUE(has_lock_of("NUCLEUS_DVL"));
}

/// A vehicle at rest under water that hears acoustic fixes.
class HearingNav : public ::testing::Test {
 protected:
  HearingNav() {
    AppContext context;
    context.name = "pNav";
    context.link = &link_;
    context.globals = {{"VehicleFile", "feelhippo.yaml", {}}};
    app_ = CreateNavApp(
        context, Block({{"sources", "acoustic_fix"}, {"acoustic_fix_constant_sigma_m", "0.2"}}));
  }
  void RunFor(double seconds, double fix_north) {
    DvlSample at_rest;
    at_rest.has_lock = true;
    at_rest.u = at_rest.v = at_rest.w = 0.0;
    for (int i = 0; i < static_cast<int>(std::lround(seconds * 50.0)); ++i, ++step_) {
      link_.time = Seconds(1767225600.0 + 0.02 * step_);
      link_.Send(*app_, topics::kFogYawRate, 0.0);
      link_.Send(*app_, topics::kImuData, ImuSample{.fz = -9.81});
      if (step_ % 5 == 0) link_.Send(*app_, topics::kDepthSensor, 8.0);
      if (step_ % 10 == 0) link_.Send(*app_, topics::kDvlData, at_rest);
      if (step_ < 1000 && step_ % 50 == 0) link_.Send(*app_, topics::kGpsData, GpsFix{.sd = 0.5});
      if (step_ >= 1000 && step_ % 50 == 0)
        link_.Send(*app_, topics::kUsblFix, UsblFix{.north = fix_north, .down = 8.0, .sd = 0.3});
      if (step_ % 5 == 0) app_->Tick(link_.time);
    }
  }
  [[nodiscard]] std::string Report() const {
    ReportLines lines;
    app_->Report(lines);
    std::string text;
    for (const std::string& line : lines.lines())
      text += line + "\n";
    return text;
  }
  TestLink link_;
  std::unique_ptr<App> app_;
  int step_ = 0;
};

TEST_F(HearingNav, AFurtherSensorMovesTheEstimateAndIsReported) {
  RunFor(20.0, 0.0);
  const auto before = link_.Last(topics::kNavState);
  RunFor(200.0, 0.8);
  const auto after = link_.Last(topics::kNavState);
  ASSERT_TRUE(before && after);
  EXPECT_GT(after->north, 0.4);
  EXPECT_LT(after->sd_north, before->sd_north);
  EXPECT_THAT(Report(), AllOf(HasSubstr("further source"), HasSubstr("acoustic_fix")));
}

TEST_F(HearingNav, ASensorThatContradictsAllOthersIsNeverBelievedAndWarnedOf) {
  RunFor(20.0, 0.0);
  RunFor(200.0, 90.0);
  EXPECT_NEAR(link_.Last(topics::kNavState)->north, 0.0, 1.0);
  EXPECT_TRUE(app_->warnings().contains("AIDING_REFUSED_acoustic_fix"));
  RunFor(5.0, 0.0);
  EXPECT_FALSE(app_->warnings().contains("AIDING_REFUSED_acoustic_fix"));
}

TEST_F(HearingNav, ASensorThatSaysNothingIsWarnedOf) {
  RunFor(20.0, 0.0);
  EXPECT_FALSE(app_->warnings().contains("AIDING_SILENT_acoustic_fix"));
  RunFor(5.0, 0.0);
  link_.time += Seconds(61.0);
  app_->Tick(link_.time);
  EXPECT_TRUE(app_->warnings().contains("AIDING_SILENT_acoustic_fix"));
}

TEST_F(HearingNav, MailThatMakesNoSenseIsWarnedOf) {
  RunFor(1.0, 0.0);
  link_.Send(*app_, Topic<std::string>{"USBL_FIX", ""}, std::string("somewhere"));
  EXPECT_TRUE(app_->warnings().contains("BAD_MAIL_USBL_FIX"));
}

}  // namespace
}  // namespace limpet

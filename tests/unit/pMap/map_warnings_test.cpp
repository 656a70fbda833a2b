// SPDX-License-Identifier: MIT
// What pMap tells an operator that it leaves out or cannot see.
#include "apps/pMap/map_warnings.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/topics/surface_fix.hpp"
#include "tests/unit/pMap/map_app_fixture.hpp"

namespace limpet {
namespace {

class MapWarningsTest : public MapAppTest {
 protected:
  /// A pass over objects 1.7 m below the camera, seen from 1.85 m at most.
  std::vector<trial::Sphere> SeeFromNearAlone() {
    std::vector<trial::Sphere> high;
    for (int i = 0; i < 6; ++i)
      high.push_back({.ned = {3.0 * i, 0.0, 5.2}, .color = "yellow", .landmark = 10 + i});
    std::vector<ObservedFrame> frames =
        trial::Fly({.north = -3, .length = 22}, link_.time, high, {.detects = 1.0}, random_);
    for (ObservedFrame& frame : frames) {
      std::erase_if(frame.boxes, [&](const Box& box) {
        return (high[static_cast<std::size_t>(*box.landmark - 10)].ned - frame.X_WB.p_WB).norm() >
               1.85;
      });
      link_.time = frame.exposure;
      link_.Send(app_, topics::kNavCameraFrame, frame);
      app_.Tick(link_.time);
    }
    return high;
  }
  void Tell(const std::vector<trial::Sphere>& spheres) {
    link_.time += Seconds(20.0);
    Confirm(spheres);
    link_.time += Seconds(6.0);
    app_.Tick(link_.time);
  }
  /// Over bare ground.
  bool WarnsOfMurkFrom(double altitude) {
    link_.time += Seconds(6.0);
    ObservedFrame frame;
    frame.exposure = link_.time;
    frame.altitude = altitude;
    frame.X_WB.p_WB = {100.0, 0.0, 3.0};
    link_.Send(app_, topics::kNavCameraFrame, frame);
    app_.Tick(link_.time);
    return app_.warnings().contains("WATER_MURKY");
  }
};

/// What the report says of frames that were left out.
std::string LeftOutIn(const MapApp& app) {
  ReportLines lines;
  app.Report(lines);
  const std::string text = lines.Text();
  const std::size_t begin = text.find("Left out:");
  return text.substr(begin, text.find('\n', begin) - begin);
}

TEST_F(MapWarningsTest, SaysThatItFliesTooHighToSee) {
  link_.Send(app_, topics::kSurveyPhase, std::string("DIVE"));
  Survey({.north = -10, .length = 1, .altitude = 8.0}, {});
  EXPECT_FALSE(app_.warnings().contains("VIEW_TOO_HIGH")) << "on the way down that is no trouble";
  link_.Send(app_, topics::kSurveyPhase, std::string("SURVEY"));
  Survey({.north = -10, .length = 1, .altitude = 8.0}, {});
  EXPECT_TRUE(app_.warnings().contains("VIEW_TOO_HIGH"));
  EXPECT_THAT(LeftOutIn(app_), ::testing::HasSubstr("18 too high above the seabed"));
  Survey({.north = -10, .length = 1, .altitude = 4.0}, {});
  EXPECT_FALSE(app_.warnings().contains("VIEW_TOO_HIGH"));
}

TEST_F(MapWarningsTest, TakesAFixInMidSurveyForNoViewThatIsTooHigh) {
  link_.Send(app_, topics::kSurveyPhase, std::string("SURVEY"));
  Survey({.north = -10, .length = 1, .altitude = 4.0}, {});
  link_.Send(app_, topics::kSurfaceFix, true);
  Survey({.north = -10, .length = 1, .altitude = 8.0}, {});
  EXPECT_FALSE(app_.warnings().contains("VIEW_TOO_HIGH")) << "on the way up, and there";
  link_.Send(app_, topics::kSurfaceFix, false);
  Survey({.north = -10, .length = 1, .altitude = 8.0}, {});
  EXPECT_FALSE(app_.warnings().contains("VIEW_TOO_HIGH")) << "on the way down again";
  Survey({.north = -10, .length = 1, .altitude = 4.0}, {});
  Survey({.north = -10, .length = 1, .altitude = 8.0}, {});
  EXPECT_TRUE(app_.warnings().contains("VIEW_TOO_HIGH")) << "once it was down";
}

TEST_F(MapWarningsTest, SaysThatFramesWithoutAnAltitudeAreLeftOut) {
  ObservedFrame frame;
  frame.exposure = link_.time;
  link_.Send(app_, topics::kNavCameraFrame, frame);
  EXPECT_TRUE(app_.warnings().contains("VIEW_WITHOUT_ALTITUDE"));
  frame.exposure = link_.time - Seconds(1.0);
  link_.Send(app_, topics::kNavCameraFrame, frame);
  EXPECT_TRUE(app_.warnings().contains("FRAME_OUT_OF_ORDER"));
  EXPECT_THAT(LeftOutIn(app_), ::testing::HasSubstr("1 out of order, 1 without an altitude"));
  frame.exposure = link_.time + Seconds(1.0);
  frame.altitude = 4.0;
  link_.Send(app_, topics::kNavCameraFrame, frame);
  EXPECT_TRUE(app_.warnings().empty());
}

TEST_F(MapWarningsTest, TellsHowFarItSeesAndWarnsWhereTheSeabedIsOutOfSight) {
  const std::vector<trial::Sphere> high = SeeFromNearAlone();
  EXPECT_NEAR(link_.Last(topics::kWaterState)->visibility.value(), 8.0, 2.5);
  EXPECT_FALSE(app_.warnings().contains("WATER_MURKY")) << "nothing is known of the water";
  Tell(high);
  EXPECT_LT(link_.Last(topics::kWaterState)->visibility, Meters(3.0));
  EXPECT_LT(link_.Last(topics::kWaterState)->sd, Meters(1.2));
  EXPECT_TRUE(app_.warnings().contains("WATER_MURKY"));
  ReportLines lines;
  app_.Report(lines);
  EXPECT_THAT(lines.Text(), ::testing::ContainsRegex("Seabed: +[0-9] % of frames"));
  link_.Send(app_, topics::kSurveyPhase, std::string("HOME"));
  link_.time += Seconds(6.0);
  app_.Tick(link_.time);
  EXPECT_FALSE(app_.warnings().contains("WATER_MURKY"));
}

/// An estimate on the threshold is one warning, not one every few seconds.
TEST_F(MapWarningsTest, MurkIsOverOnlyWhereTheSeabedIsClearlyInSight) {
  Tell(SeeFromNearAlone());
  double down = 4.0, up = 0.0;
  while (down > 0.3 && WarnsOfMurkFrom(down))
    down *= 0.97;
  for (up = down; up < 8.0 && !WarnsOfMurkFrom(up);)
    up *= 1.03;
  EXPECT_GT(down, 0.3);
  EXPECT_GT(up, 1.15 * down);
  EXPECT_LT(up, 1.3 * down);
}

TEST_F(MapWarningsTest, SaysThatItDoesNotFollowUpEveryHint) {
  std::vector<trial::Sphere> ghosts;
  for (int i = 0; i < 11; ++i) {
    // At the image's edge: what was seen whole would need no second look.
    ghosts.push_back({.ned = {3.0 * i, 3.0, 6.0}, .color = "yellow"});
  }
  Survey({.north = -4, .east = 1, .length = 16}, ghosts);
  link_.time += Seconds(1.0);
  app_.Tick(link_.time);
  EXPECT_FALSE(app_.warnings().contains("TENTATIVE_OBJECTS_LEFT_OUT"));
  Survey({.north = 12, .east = 1, .length = 26}, ghosts);
  link_.time += Seconds(1.0);
  app_.Tick(link_.time);
  EXPECT_TRUE(app_.warnings().contains("TENTATIVE_OBJECTS_LEFT_OUT"));
}

TEST_F(MapWarningsTest, SaysThatItTakesAnObjectOfPNavsForNone) {
  const trial::Sphere seen{.ned = {4, 1, 5.5}, .color = "yellow", .landmark = 3};
  Survey({.north = -3, .east = 1, .length = 16}, {});
  link_.Send(app_, topics::kNavLandmarks,
             Landmarks{{{.id = 3,
                         .object = {.p_W = seen.ned,
                                    .cov_W = 0.01 * Eigen::Matrix3d::Identity(),
                                    .color = "yellow"},
                         .detections = 12}}});
  link_.time += Seconds(20.0);
  app_.Tick(link_.time);
  EXPECT_TRUE(app_.warnings().contains("LANDMARKS_DOUBTED"));
  link_.Send(app_, topics::kNavLandmarks, Landmarks{});
  link_.time += Seconds(20.0);
  app_.Tick(link_.time);
  EXPECT_FALSE(app_.warnings().contains("LANDMARKS_DOUBTED"));
}

TEST_F(MapWarningsTest, SaysThatBeamsEndWhereNothingCanBe) {
  const auto ping = [this](double first) {
    for (int i = 0; i < 60; ++i) {
      link_.Send(
          app_, topics::kNavBeams,
          PosedBeams{.down = 0.0, .b1 = first, .b2 = 12.0, .b3 = 12.0, .b4 = first, .sd_down = {}});
    }
  };
  ping(2.0);
  EXPECT_TRUE(app_.warnings().contains("BEAMS_LEFT_OUT"));
  ReportLines lines;
  app_.Report(lines);
  EXPECT_THAT(lines.Text(), ::testing::HasSubstr("120 used, 120 left out as outliers"));
  // Where the mission lets objects float that high, they are no outliers.
  SurveyArea area = kArea;
  area.object_height_max = 9.0;
  link_.Send(app_, topics::kSurveyArea, area);
  ping(2.0);
  EXPECT_FALSE(app_.warnings().contains("BEAMS_LEFT_OUT"));
}

TEST_F(MapWarningsTest, SaysSoWhereNoneOfSeveralFormerObjectsIsFoundAgain) {
  SessionPrior prior =
      Former({{1, {0, 1, 5.5}, "yellow"}, {2, {4, 1, 5.5}, "yellow"}, {3, {8, 1, 6.0}, "orange"}});
  AddViews({.north = -3, .east = 1, .length = 16}, prior);
  link_.Send(app_, topics::kSessionPrior, prior);
  for (const double east : {0.5, 1.0, 1.5})
    Survey({.north = -3, .east = east, .length = 16}, {});
  Confirm({});
  EXPECT_TRUE(app_.warnings().contains("FORMER_ALL_GONE"));
  for (const double east : {0.5, 1.0, 1.5})
    Survey({.north = -3, .east = east, .length = 16}, {kYellow});
  Confirm({kYellow}, {{kYellow.landmark.value(), 2}});
  EXPECT_FALSE(app_.warnings().contains("FORMER_ALL_GONE")) << "one stands where it stood";
}

}  // namespace
}  // namespace limpet

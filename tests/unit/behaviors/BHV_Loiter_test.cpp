// SPDX-License-Identifier: MIT
#include "behaviors/BHV_Loiter.hpp"

#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/helm_flight.hpp"
#include "tests/unit/behaviors/every_behavior.hpp"

namespace limpet {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

std::string Loiter(const std::string& lines) {
  return "Behavior = BHV_Loiter\n{\n  name = loiter\n  condition = LOITER = true\n  speed = 1.5\n"
         "  polygon = format=radial, x=0, y=0, radius=40, pts=8, snap=0.1\n  capture_radius = 4\n"
         "  slip_radius = 12\n" +
         lines + "}\n";
}

HelmFlight Begun(const std::string& lines, double x, double y, double heading_deg) {
  HelmFlight flight(Loiter(lines));
  flight.PlaceAt(x, y, heading_deg);
  flight.Say("LOITER", std::string("true"));
  return flight;
}

/// Angle that the vehicle goes round the origin in a time, clockwise positive [deg].
double Swept(HelmFlight& flight, double seconds) {
  double swept = 0.0, last = std::atan2(flight.x(), flight.y());
  for (int i = 0; i < static_cast<int>(10.0 * seconds); ++i) {
    flight.Tick();
    const double now = std::atan2(flight.x(), flight.y());
    swept += WrapAngle(now - last);
    last = now;
  }
  return DegreesFromRadians(swept);
}

TEST(BhvLoiter, GoesRoundItsPolygonAtItsSpeed) {
  for (const bool is_clockwise : {true, false}) {
    HelmFlight flight = Begun(is_clockwise ? "" : "  clockwise = false\n", -120.0, 10.0, 90.0);
    ASSERT_TRUE(flight.FlyUntil([&] { return flight.Last("LOITER_MODE") == "stable"; }, 120.0));
    const double begin = flight.travelled();
    const double perimeter = 8.0 * 2.0 * 40.0 * std::sin(M_PI / 8.0);
    const double degrees = Swept(flight, 3.0 * perimeter / 1.5);
    // Corners are reached at the capture radius: the round is a little shorter than the polygon.
    EXPECT_NEAR(degrees * (is_clockwise ? 1.0 : -1.0), 3.0 * 360.0, 0.12 * 3.0 * 360.0);
    EXPECT_NEAR(flight.travelled() - begin, 3.0 * perimeter, 0.02 * 3.0 * perimeter);
    EXPECT_NEAR(std::hypot(flight.x(), flight.y()), 38.0, 4.0);
  }
}

TEST(BhvLoiter, EntersWithTheRounds) {
  HelmFlight flight = Begun("", -200.0, 0.0, 90.0);
  flight.Tick();
  EXPECT_GT(*flight.decision().course, 0.0);
  EXPECT_LT(MoosHeadingFromYaw(*flight.decision().course), 90.0)
      << "clockwise rounds keep the polygon to starboard";
  HelmFlight other = Begun("  clockwise = false\n", -200.0, 0.0, 90.0);
  other.Tick();
  EXPECT_GT(MoosHeadingFromYaw(*other.decision().course), 90.0);
}

TEST(BhvLoiter, TakesASpiralFactorBeyondItsScaleForTheEndOfIt) {
  const auto course_with = [](const std::string& factor) {
    HelmFlight flight = Begun("  spiral_factor = " + factor + "\n", 10.0, 0.0, 90.0);
    flight.Tick();
    return *flight.decision().course;
  };
  EXPECT_EQ(course_with("-2"), course_with("0"));
  EXPECT_EQ(course_with("250"), course_with("100"));
}

TEST(BhvLoiter, TakesTheBetterDirectionAsItWakesUpIfLeftTo) {
  const auto clockwise = [](double heading, bool wakes_up) {
    HelmFlight flight =
        Begun("  condition = GO = true\n  clockwise = best\n  runflag = CW = $[CWISE]\n", -100.0,
              0.0, heading);
    if (wakes_up) flight.Tick();
    flight.PlaceAt(-100.0, 0.0, heading);
    flight.Say("GO", std::string("true"));
    flight.Tick();
    return flight.Last("CW");
  };
  EXPECT_EQ(clockwise(120.0, true), "0") << "it already heads to starboard of the polygon";
  EXPECT_EQ(clockwise(60.0, true), "1");
  EXPECT_EQ(clockwise(120.0, false), "1") << "a helm that begins with it goes clockwise, as theirs";
}

TEST(BhvLoiter, SaysHowFarItIs) {
  HelmFlight flight = Begun("  post_suffix = a\n", -137.0, 0.0, 90.0);
  flight.Tick();
  EXPECT_EQ(flight.Last("LOITER_MODE_A"), "acquiring_external");
  EXPECT_EQ(flight.Last("LOITER_ACQUIRE_A"), "1");
  EXPECT_EQ(flight.Last("LOITER_DIST_TO_POLY_A"), "100");
  EXPECT_THAT(flight.Last("LOITER_REPORT_A"),
              HasSubstr(",capture_hits=0,nonmono_hits=0,acquire_mode=true"));
  EXPECT_THAT(flight.Last("VIEW_POLYGON"), HasSubstr("label=alpha_loiter"));
  flight.Say("LOITER", std::string("false"));
  flight.Tick();
  EXPECT_EQ(flight.Last("LOITER_MODE_A"), "idle");
  EXPECT_THAT(flight.Last("VIEW_POLYGON"), HasSubstr("active=false"));
}

TEST(BhvLoiter, ComesBackWhenItWasCarriedOff) {
  HelmFlight flight = Begun("", -60.0, 0.0, 90.0);
  flight.Fly(60.0);
  flight.PlaceAt(0.0, 90.0, 0.0);
  flight.Tick();
  EXPECT_EQ(flight.Last("LOITER_MODE"), "recovering_external");
  flight.Fly(90.0);
  EXPECT_EQ(flight.Last("LOITER_MODE"), "stable");
}

TEST(BhvLoiter, MovesItsCenterByUpdates) {
  HelmFlight flight = Begun("  updates = UP\n  runxflag = C = $[CENTER]\n", -60.0, 0.0, 90.0);
  flight.Fly(30.0);
  flight.Say("UP", std::string("center_assign = 300,100"));
  flight.Tick();
  EXPECT_EQ(flight.Last("C"), "x=300,y=100");
  flight.Say("UP", std::string("xcenter_assign = 200"));
  flight.Tick();
  EXPECT_EQ(flight.Last("C"), "x=200,y=100");
  flight.Say("UP", std::string("center_assign = y=50"));
  flight.Tick();
  EXPECT_EQ(flight.Last("C"), "x=200,y=50");
  flight.Fly(300.0);
  EXPECT_NEAR(std::hypot(flight.x() - 200.0, flight.y() - 50.0), 38.0, 4.0);
}

TEST(BhvLoiter, LoitersWhereItIsIfItsCenterIsToBeThere) {
  HelmFlight flight =
      Begun("  center_activate = true\n  runflag = C = $[CENTER]\n", 500.0, 20.0, 0.0);
  flight.Tick();
  EXPECT_EQ(flight.Last("C"), "x=500,y=20");
}

TEST(BhvLoiter, GrowsByAnUpdate) {
  HelmFlight flight = Begun("  updates = UP\n  runxflag = R = $[RAD]\n", -60.0, 0.0, 90.0);
  flight.Tick();
  const double radius = std::stod(flight.Last("R"));
  flight.Say("UP", std::string("mod_poly_rad = 10"));
  flight.Tick();
  EXPECT_NEAR(std::stod(flight.Last("R")), radius + 10.0, 0.01);
}

TEST(BhvLoiter, CompletesAfterItsShareOfARound) {
  HelmFlight flight = Begun("  slingshot = 270\n  endflag = DONE = true\n", -60.0, 0.0, 90.0);
  ASSERT_TRUE(flight.FlyUntil([&] { return !flight.Posts("DONE").empty(); }, 300.0));
  EXPECT_GT(flight.travelled(), 0.7 * 245.0);
}

TEST(BhvLoiter, AnUpdateOfItsSpeedLeavesItsRoundAlone) {
  HelmFlight flight = Begun("  updates = UP\n", -60.0, 0.0, 90.0);
  flight.Fly(70.0);
  const std::string index = flight.Last("LOITER_INDEX");
  flight.Say("UP", std::string("speed = 1"));
  flight.Fly(1.0);
  EXPECT_EQ(flight.Last("LOITER_INDEX"), index);
  EXPECT_NEAR(*flight.decision().speed, 1.0, 1e-9);
}

TEST(BhvLoiter, HasNoOpinionAndWarnsWithoutAPolygon) {
  HelmFlight flight("Behavior = BHV_Loiter\n{\n  speed = 1\n}\n");
  flight.Tick();
  EXPECT_THAT(flight.decision().active, SizeIs(0));
  EXPECT_EQ(flight.decision().warnings.at(0).warning.id.name(), "LOITER_NO_POLYGON");
}

TEST(BhvLoiter, RefusesAPolygonThatIsNotConvex) {
  for (const char* polygon :
       {"0,0:10,0:2,2:0,10", "0,0:10,0", "0,0:5,5:10,10", "0,0:10,0:0,10:10,10"}) {
    EXPECT_THROW(
        HelmFlight("Behavior = BHV_Loiter\n{\n  polygon = " + std::string(polygon) + "\n}\n"),
        ConfigError)
        << polygon;
  }
}

TEST(BhvLoiter, SaysHowFarRoundItHasComeOfItsSlingshotAndThatItIsDone) {
  HelmFlight flight = Begun("  slingshot = 200\n", -60.0, 0.0, 90.0);
  ASSERT_TRUE(flight.FlyUntil([&] { return !flight.Posts("LOITER_COMPLETE").empty(); }, 300.0));
  EXPECT_EQ(flight.Last("LOITER_COMPLETE"), "true");
  EXPECT_NEAR(std::stod(flight.Last("LOITER_BNG_TOTAL")), 200.0, 1.0);
  double sum = 0.0;
  for (const std::string& step : flight.Posts("LOITER_BNG_DELTA")) {
    sum += std::stod(step);
  }
  EXPECT_NEAR(sum, 200.0, 2.0);
  HelmFlight endless = Begun("", -60.0, 0.0, 90.0);
  endless.Fly(60.0);
  EXPECT_THAT(endless.Posts("LOITER_BNG_TOTAL"), SizeIs(0)) << "nobody asked";
}

TEST(BhvLoiter, BeginsToCountAnewAfterEachSlingshotIfItLivesOn) {
  HelmFlight flight =
      Begun("  slingshot = 90\n  perpetual = true\n  endflag = ROUND = $[CTR]\n", -60.0, 0.0, 90.0);
  ASSERT_TRUE(flight.FlyUntil([&] { return flight.Posts("ROUND").size() == 4; }, 400.0));
  EXPECT_GT(flight.travelled(), 200.0) << "a round";
  EXPECT_EQ(flight.Last("LOITER_COMPLETE"), "true");
}

TEST(BhvLoiter, SaysThatItIsDoneAlsoWhenItsTimeIsUp) {
  HelmFlight flight = Begun("  duration = 5\n", -60.0, 0.0, 90.0);
  flight.Fly(4.0);
  EXPECT_EQ(flight.Last("LOITER_COMPLETE"), "");
  flight.Fly(2.0);
  EXPECT_EQ(flight.Last("LOITER_COMPLETE"), "true");
}

INSTANTIATE_TYPED_TEST_SUITE_P(BhvLoiter, EveryBehavior, BHV_Loiter);

}  // namespace
}  // namespace limpet

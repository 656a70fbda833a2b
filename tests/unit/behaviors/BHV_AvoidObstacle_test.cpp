// SPDX-License-Identifier: MIT
#include "behaviors/BHV_AvoidObstacle.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/helm_flight.hpp"
#include "tests/unit/behaviors/every_behavior.hpp"

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr const char* kTravel =
    "Behavior = BHV_Waypoint\n{\n  name = go\n  points = 200,0\n  speed = 1.5\n"
    "  capture_radius = 5\n  endflag = THERE = true\n}\n";

std::string AvoidBlock(const std::string& lines) {
  return "Behavior = BHV_AvoidObstacleV24\n{\n  name = avoid\n  pwt = 300\n  updates = OBSTACLE\n" +
         lines + "}\n";
}

/// Goes 200 m to the east; the least distance that it had to a rectangle, or nothing if it did not
/// arrive.
std::optional<double> LeastDistance(HelmFlight& flight, const ConvexPolygon& rectangle) {
  double least = 1e9;
  flight.PlaceAt(0.0, 0.0, 90.0);
  const bool is_there = flight.FlyUntil(
      [&] {
        least = std::min(least, rectangle.Outside({flight.x(), flight.y()}));
        return !flight.Last("THERE").empty();
      },
      300.0);
  return is_there ? std::optional(least) : std::nullopt;
}

TEST(BhvAvoidObstacle, LeadsRoundAnObstacleOnTheWayAtADistance) {
  for (const double shift : {0.0, 5.0, -8.0, 15.0}) {
    const double south = -12.0 + shift, north = 12.0 + shift;
    const std::string poly = fmt::format("pts={{90,{0}:110,{0}:110,{1}:90,{1}}}", south, north);
    HelmFlight flight(kTravel + AvoidBlock("  poly = " + poly + ",label=rock\n"));
    const auto rectangle =
        ConvexPolygon::Of({{90, south}, {110, south}, {110, north}, {90, north}});
    const auto least = LeastDistance(flight, *rectangle);
    ASSERT_TRUE(least) << shift;
    EXPECT_GT(*least, 7.0) << shift;
    EXPECT_LT(flight.travelled(), 240.0) << "and not by a long way round: " << shift;
  }
}

TEST(BhvAvoidObstacle, GoesRoundWhatLiesRightAheadOfASlowTurnerToo) {
  struct Rock {
    double middle, half_width, least, free, inner, outer, turn_rate;
  };
  // Two ways round that are as good must not take turns until neither can be gone.
  for (const Rock& rock : {Rock{100, 9, 5, 10, 10, 40, 0.35}, Rock{100, 10, 5, 10, 10, 40, 0.15},
                           Rock{110, 12, 8, 20, 15, 50, 0.25}, Rock{90, 6, 10, 15, 25, 50, 0.2}}) {
    const std::string poly = fmt::format("{0},{2} : {1},{2} : {1},{3} : {0},{3}", rock.middle - 10,
                                         rock.middle + 10, -rock.half_width, rock.half_width);
    HelmFlight flight(kTravel + AvoidBlock(fmt::format(
                                    "  poly = {}\n  allowable_ttc = 5\n  min_util_cpa_dist = {}\n"
                                    "  max_util_cpa_dist = {}\n  pwt_inner_dist = {}\n"
                                    "  pwt_outer_dist = {}\n  completed_dist = 150\n",
                                    poly, rock.least, rock.free, rock.inner, rock.outer)));
    flight.turn_rate = rock.turn_rate;
    const auto rectangle = ConvexPolygon::Of({{rock.middle - 10, -rock.half_width},
                                              {rock.middle + 10, -rock.half_width},
                                              {rock.middle + 10, rock.half_width},
                                              {rock.middle - 10, rock.half_width}});
    const auto least = LeastDistance(flight, *rectangle);
    ASSERT_TRUE(least) << poly;
    EXPECT_GT(*least, rock.least) << poly;
    EXPECT_EQ(flight.Last("BHV_ERROR"), "") << poly;
  }
}

TEST(BhvAvoidObstacle, LeavesTheWayAloneWhereTheObstacleIsFarFromIt) {
  HelmFlight flight(kTravel + AvoidBlock("  poly = 90,20 : 110,20 : 110,40 : 90,40\n"));
  const auto rectangle = ConvexPolygon::Of({{90, 20}, {110, 20}, {110, 40}, {90, 40}});
  ASSERT_TRUE(LeastDistance(flight, *rectangle));
  EXPECT_LT(flight.travelled(), 196.0);
}

TEST(BhvAvoidObstacle, PrefersToBeSlowWhereItCannotTurnAside) {
  HelmFlight flight(
      "Behavior = BHV_ConstantHeading\n{\n  name = east\n  heading = 90\n  peakwidth = 0\n"
      "  basewidth = 1\n  pwt = 1000\n}\n"
      "Behavior = BHV_ConstantSpeed\n{\n  name = speed\n  speed = 2\n  basewidth = 4\n}\n" +
      AvoidBlock("  poly = 40,-50 : 60,-50 : 60,50 : 40,50\n  allowable_ttc = 10\n"));
  flight.PlaceAt(0.0, 0.0, 90.0);
  flight.Tick();
  EXPECT_NEAR(*flight.decision().speed, 2.0, 0.26) << "there is time";
  flight.PlaceAt(22.0, 0.0, 90.0);
  flight.Tick();
  EXPECT_LT(*flight.decision().speed, 0.6);
}

TEST(BhvAvoidObstacle, LeadsOutOfAnObstacleByTheShortestWay) {
  HelmFlight flight(kTravel + AvoidBlock("  poly = -50,-50 : 50,-50 : 50,10 : -50,10\n"
                                         "  allstop_on_breach = false\n"));
  flight.PlaceAt(0.0, 0.0, 90.0);
  flight.Tick();
  EXPECT_LT(flight.decision().course.value(), 0.8) << "to the north";
  EXPECT_EQ(flight.Last("BHV_WARNING"), "avoid: it is inside the obstacle");
  EXPECT_EQ(flight.Last("BHV_ERROR"), "");
}

TEST(BhvAvoidObstacle, HasNoSayAboutWhatLiesAsternOrFarOff) {
  HelmFlight flight(
      AvoidBlock("  poly = -20,-5 : -10,-5 : -10,5 : -20,5\n  pwt_outer_dist = 30\n"));
  flight.PlaceAt(0.0, 0.0, 90.0);
  flight.Tick();
  EXPECT_THAT(flight.decision().active, IsEmpty()) << "astern";
  flight.PlaceAt(0.0, 0.0, 270.0);
  flight.Tick();
  EXPECT_THAT(flight.decision().active, ElementsAre("avoid"));
  flight.PlaceAt(40.0, 0.0, 270.0);
  flight.Tick();
  EXPECT_THAT(flight.decision().active, IsEmpty()) << "far off";
}

TEST(BhvAvoidObstacle, SaysHowNearItIsAndHowNearItWas) {
  HelmFlight flight(
      kTravel +
      AvoidBlock("  poly = 90,-12 : 110,-12 : 110,12 : 90,12\n  id = rock7\n"
                 "  rng_flag = <20 NEAR = $[RNG]\n  cpa_flag = PASSED = $[CPA] $[SIDE] $[OID]\n"
                 "  endflag = CLEAR = $[RNG]\n"));
  const auto rectangle = ConvexPolygon::Of({{90, -12}, {110, -12}, {110, 12}, {90, 12}});
  const auto least = LeastDistance(flight, *rectangle);
  ASSERT_TRUE(least);
  ASSERT_FALSE(flight.Posts("NEAR").empty());
  EXPECT_LT(std::stod(flight.Posts("NEAR").front()), 20.0);
  ASSERT_THAT(flight.Posts("PASSED"), SizeIs(1));
  EXPECT_NEAR(std::stod(flight.Last("PASSED")), *least, 0.1);
  EXPECT_THAT(flight.Last("PASSED"), HasSubstr("rock7"));
  ASSERT_THAT(flight.Posts("CLEAR"), SizeIs(1)) << "beyond completed_dist";
  EXPECT_NEAR(std::stod(flight.Last("CLEAR")), 50.0, 0.5);
}

TEST(BhvAvoidObstacle, IsGoneOnceTheObstacleIsResolved) {
  HelmFlight flight(AvoidBlock("  poly = 30,-5 : 40,-5 : 40,5 : 30,5\n  id = a\n"));
  flight.Tick();
  flight.Say("OBM_RESOLVED", std::string("b"));
  flight.Tick();
  EXPECT_THAT(flight.host().statuses(), SizeIs(1));
  flight.Say("OBM_RESOLVED", std::string("a"));
  flight.Tick();
  flight.Tick();
  EXPECT_THAT(flight.host().statuses(), IsEmpty());
}

TEST(BhvAvoidObstacle, IsGoneAlsoWhereSeveralAreResolvedAtOnce) {
  HelmFlight flight(AvoidBlock("  poly = 30,-5 : 40,-5 : 40,5 : 30,5\n  id = a\n"));
  flight.Tick();
  for (const char* id : {"z", "a", "b"}) {
    flight.Say("OBM_RESOLVED", std::string(id));
  }
  flight.Tick();
  EXPECT_THAT(flight.Posts("NOTED_RESOLVED"), ElementsAre("z", "a", "b"));
  flight.Tick();
  EXPECT_THAT(flight.host().statuses(), IsEmpty());
}

TEST(BhvAvoidObstacle, IsGoneAfterMailOfATimeInWhichTheHelmWasParked) {
  HelmFlight flight(AvoidBlock("  poly = 30,-5 : 40,-5 : 40,5 : 30,5\n  id = a\n"));
  flight.Tick();
  flight.Say("OBM_RESOLVED", std::string("a"));
  for (int other = 0; other < 100; ++other) {
    flight.Say("OBM_RESOLVED", "other_" + std::to_string(other));
  }
  flight.Tick();
  flight.Tick();
  EXPECT_THAT(flight.host().statuses(), IsEmpty());
}

TEST(BhvAvoidObstacle, IsMadeByMailForEachObstacle) {
  HelmFlight flight(AvoidBlock("  templating = spawn\n"));
  flight.Say("OBSTACLE", std::string("name=_1 # poly=30,-5:40,-5:40,5:30,5 # id=one"));
  flight.Say("OBSTACLE", std::string("name=_2 # poly=30,25:40,25:40,35:30,35 # id=two"));
  flight.PlaceAt(0.0, 0.0, 90.0);
  flight.Tick();
  EXPECT_THAT(flight.decision().active, SizeIs(2));
}

TEST(BhvAvoidObstacle, AsksForObstaclesAsTheHelmBeginsIfMailMakesIt) {
  HelmFlight flight(AvoidBlock("  templating = spawn\n  pwt_outer_dist = 40\n"));
  const std::vector<HelmPost> posts = flight.host().InitialPosts();
  ASSERT_THAT(posts, SizeIs(1));
  EXPECT_EQ(posts[0].variable, "OBM_ALERT_REQUEST");
  EXPECT_EQ(std::get<std::string>(posts[0].value), "name=avoid,update_var=OBSTACLE,alert_range=40");
  HelmFlight alone(AvoidBlock("  poly = 30,-5 : 40,-5 : 40,5 : 30,5\n"));
  EXPECT_THAT(alone.host().InitialPosts(), IsEmpty()) << "it has its obstacle";
}

TEST(BhvAvoidObstacle, KeepsToTheSideOnWhichItHasBegunToPass) {
  constexpr const char* kEast =
      "Behavior = BHV_ConstantHeading\n{\n  name = east\n  heading = 90\n  pwt = 10\n"
      "  basewidth = 180\n}\n";
  const std::string rock = "  poly = 30,-20 : 40,-20 : 40,20 : 30,20\n";
  HelmFlight flight(kEast + AvoidBlock(rock + "  runxflag = LOCK = $[SLOCK]\n"));
  const auto course_at = [](HelmFlight& vehicle, double x, double y) {
    vehicle.PlaceAt(x, y, 90.0);
    vehicle.Tick();
    return MoosHeadingFromYaw(*vehicle.decision().course);
  };
  EXPECT_LT(course_at(flight, 0.0, 1.0), 90.0) << "a little north of the middle";
  EXPECT_EQ(flight.Last("LOCK"), "") << "not near yet";
  EXPECT_LT(course_at(flight, 13.0, 1.0), 90.0);
  EXPECT_EQ(flight.Last("LOCK"), "port");
  EXPECT_LT(course_at(flight, 13.0, -1.0), 90.0) << "a gust: now the south is nearer";
  EXPECT_EQ(flight.Last("LOCK"), "port");
  HelmFlight other(kEast + AvoidBlock(rock));
  EXPECT_GT(course_at(other, 13.0, -1.0), 90.0) << "who comes from there goes there";
  static_cast<void>(course_at(flight, -20.0, -1.0));
  EXPECT_EQ(flight.Last("LOCK"), "") << "well off it is open again";
}

TEST(BhvAvoidObstacle, StopsInsideAnObstacleUnlessToldToLeadOut) {
  HelmFlight flight(AvoidBlock("  poly = -50,-50 : 50,-50 : 50,10 : -50,10\n"));
  flight.PlaceAt(0.0, 0.0, 90.0);
  flight.Tick();
  EXPECT_THAT(flight.Last("BHV_ERROR"), HasSubstr("it is inside the obstacle"));
}

TEST(BhvAvoidObstacle, DrawsTheObstacleAndItsBuffersAndErasesThem) {
  HelmFlight flight(
      AvoidBlock("  condition = GO = true\n  poly = pts={30,-5:40,-5:40,5:30,5},label=rock\n"
                 "  visual_hints = buff_max_edge_color=red\n  draw_buff_min_poly = false\n"));
  flight.Say("GO", std::string("true"));
  flight.PlaceAt(0.0, 0.0, 90.0);
  flight.Tick();
  ASSERT_THAT(flight.Posts("VIEW_POLYGON"), SizeIs(2));
  EXPECT_THAT(flight.Posts("VIEW_POLYGON")[0], HasSubstr("label=rock"));
  EXPECT_THAT(flight.Posts("VIEW_POLYGON")[1], HasSubstr("label=rock_rim_poly"));
  EXPECT_THAT(flight.Posts("VIEW_POLYGON")[1], HasSubstr("edge_color=red"));
  flight.Say("GO", std::string("false"));
  flight.Tick();
  EXPECT_THAT(flight.Last("VIEW_POLYGON"), HasSubstr("active=false"));
}

TEST(BhvAvoidObstacle, RefusesObstaclesAndDistancesThatCannotBe) {
  for (const char* line :
       {"poly = 0,0 : 10,0 : 2,2 : 0,10", "pwt_inner_dist = 60\n  pwt_outer_dist = 40",
        "min_util_cpa_dist = 9\n  max_util_cpa_dist = 5",
        "completed_dist = 20\n  pwt_outer_dist = 30"}) {
    EXPECT_THROW(HelmFlight(AvoidBlock(std::string("  ") + line + "\n")), ConfigError) << line;
  }
}

TEST(BhvAvoidObstacle, WarnsWhileItKnowsNoObstacle) {
  HelmFlight flight(AvoidBlock(""));
  flight.Tick();
  EXPECT_EQ(flight.decision().warnings.at(0).warning.id.name(), "OBSTACLE_NOT_SET");
}

TEST(BhvAvoidObstacle, SaysTheNumberOfItsObstacleAndItsDistances) {
  const auto said = [](const std::string& lines) {
    HelmFlight flight(AvoidBlock("  poly = 30,-5 : 40,-5 : 40,5 : 30,5\n" + lines +
                                 "  runflag = SAID = <$[OIDX]> $[MINU_CPA] $[MAXU_CPA]\n"));
    flight.Tick();
    return flight.Last("SAID");
  };
  EXPECT_EQ(said("  id = ais_17_4\n"), "<4> 8 16");
  EXPECT_EQ(said("  id = rock\n  min_util_cpa_dist = 5\n  max_util_cpa_dist = 9\n"), "<> 5 9");
}

TEST(BhvAvoidObstacle, SaysOfEachResolvedObstacleThatItHasHeardOfIt) {
  HelmFlight flight(
      AvoidBlock("  condition = GO = true\n  poly = 30,-5 : 40,-5 : 40,5 : 30,5\n"
                 "  id = a\n"));
  flight.state().now += Seconds(1.0);
  flight.host().SetVariable("OBM_RESOLVED", std::string("old"), Seconds(1000.0));
  flight.Tick();
  EXPECT_THAT(flight.Posts("NOTED_RESOLVED"), IsEmpty()) << "before its time";
  flight.Say("OBM_RESOLVED", std::string("b"));
  flight.Tick();
  flight.Say("GO", std::string("true"));
  flight.Tick();
  flight.Say("OBM_RESOLVED", std::string("a"));
  flight.Tick();
  EXPECT_THAT(flight.Posts("NOTED_RESOLVED"), ElementsAre("b", "a")) << "idle and running";
}

TEST(BhvAvoidObstacle, IsSilencedByNameOrBySourceWhereItMayBe) {
  const std::string block =
      "  poly = pts={30,-5:40,-5:40,5:30,5},label=rock,vsource=radar\n  id = rock_7\n";
  HelmFlight flight(AvoidBlock(block + "  can_disable = true\n"));
  const auto has_say = [](HelmFlight& vehicle, const std::string& filter) {
    vehicle.PlaceAt(0.0, 0.0, 90.0);
    vehicle.Say("BHV_ABLE_FILTER", filter);
    vehicle.Tick();
    return !vehicle.decision().active.empty();
  };
  EXPECT_TRUE(has_say(flight, "action=disable,obstacle_id=rock_8"));
  EXPECT_FALSE(has_say(flight, "action=disable, obstacle_id=ROCK_7"));
  EXPECT_THAT(flight.Last("VIEW_POLYGON"), HasSubstr("active=false"));
  flight.Tick();
  EXPECT_THAT(flight.decision().active, IsEmpty()) << "as long as nobody says otherwise";
  EXPECT_TRUE(has_say(flight, "action=enable,obstacle_id=rock_7"));
  EXPECT_FALSE(has_say(flight, "action=disable,vsource=radar"));
  EXPECT_TRUE(has_say(flight, "vsource=radar,action=enable"));
  EXPECT_TRUE(has_say(flight, "action=disable")) << "of nobody";
  static_cast<void>(has_say(flight, "action=expunge,obstacle_id=rock_7"));
  flight.Tick();
  EXPECT_THAT(flight.host().statuses(), IsEmpty());
  HelmFlight firm{AvoidBlock(block)};
  EXPECT_TRUE(has_say(firm, "action=disable,obstacle_id=rock_7"));
}

INSTANTIATE_TYPED_TEST_SUITE_P(BhvAvoidObstacle, EveryBehavior, BHV_AvoidObstacle);

}  // namespace
}  // namespace limpet

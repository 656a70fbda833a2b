// SPDX-License-Identifier: MIT
// What BHV_Waypoint bids on course and speed, alone and beside others.
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "behaviors/BHV_Waypoint.hpp"
#include "limpet/core/frames.hpp"
#include "limpet/helm/motion_decision.hpp"
#include "tests/support/helm_flight.hpp"
#include "tests/unit/behaviors/behavior_block.hpp"

namespace limpet {
namespace {

TEST(BhvWaypointBids, HoldsToItsCourseWhereAnotherWayIsAboutAsGood) {
  // A heading that is wanted nearly as much as the way's: the present one decides.
  const std::string both =
      "Behavior = BHV_Waypoint\n{\n  name = way\n  pwt = 100\n  points = 0,1000\n  speed = 2\n}\n"
      "Behavior = BHV_ConstantHeading\n{\n  name = west\n  pwt = 50\n  heading = 215\n"
      "  peakwidth = 0\n  basewidth = 180\n  duration = no-time-limit\n}\n";
  for (const double heading : {0.0, 215.0}) {
    HelmFlight flight(both);
    flight.PlaceAt(0.0, 0.0, heading);
    flight.Tick();
    const double chosen = MoosHeadingFromYaw(*flight.decision().course);
    EXPECT_NEAR(std::remainder(chosen - heading, 360.0), 0.0, 1.0) << heading;
  }
}

TEST(BhvWaypointBids, GoesToItsPointWhateverItsPresentCourse) {
  for (const double heading : {0.0, 20.0, 100.0, 181.0, 300.0}) {
    HelmFlight flight("Behavior = BHV_Waypoint\n{\n  points = 0,1000\n  speed = 2\n}\n");
    flight.PlaceAt(0.0, 0.0, heading);
    flight.Tick();
    EXPECT_NEAR(*flight.decision().course, 0.0, 1e-6) << heading;
  }
}

TEST(BhvWaypointBids, OfTwoThatWantOtherSpeedsTheHeavierHasItsOwnNearly) {
  // MOOS-IvP's helm decides 1.8 on speed:0:4:21: each says as much from worst to best as it weighs.
  const std::string way = "Behavior = BHV_Waypoint\n{\n  points = 1000,0\n";
  HelmFlight flight(way + "  name = fast\n  pwt = 100\n  speed = 2\n}\n" + way +
                    "  name = slow\n  pwt = 80\n  speed = 1.2\n}\n");
  flight.state().domain.speed = MotionAxis{.low = 0.0, .high = 4.0, .points = 21};
  flight.PlaceAt(0.0, 0.0, 90.0);
  MotionArbiter arbiter(flight.state().domain, {}, true);
  static_cast<void>(flight.host().Update(flight.state()));
  EXPECT_NEAR(*arbiter.Decide(flight.host().running(), flight.state()).speed, 1.8, 1e-9);
}

TEST(BhvWaypointBids, WouldRatherBeSlowThanFastIfItsFunctionSaysSo) {
  const auto speed = [](const std::string& kind) {
    HelmFlight flight(
        "Behavior = BHV_Waypoint\n{\n  name = way\n  points = 1000,0\n  speed = 2.4\n  ipf_type "
        "= " +
        kind +
        "\n}\nBehavior = BHV_ConstantSpeed\n{\n  name = fast\n  pwt = 30\n  speed = 4\n"
        "  duration = no-time-limit\n}\n");
    flight.PlaceAt(0.0, 0.0, 90.0);
    flight.Tick();
    return *flight.decision().speed;
  };
  EXPECT_NEAR(speed("zaic_spd"), 2.5, 0.01) << "the point next to 2.4";
  EXPECT_NEAR(speed("zaic"), 4.0, 0.1);
}

TEST(BhvWaypointBids, SaysTheFormOfFunctionThatItsBlockNames) {
  const auto kind = [](const std::string& lines) {
    HelmFlight flight("Behavior = BHV_Waypoint\n{\n  points = 100,0\n  speed = 1\n" + lines +
                      "  runflag = KIND = $[IPF_TYPE]\n}\n");
    flight.Tick();
    return flight.Last("KIND");
  };
  EXPECT_EQ(kind(""), "zaic");
  EXPECT_EQ(kind("  ipf_type = ROC\n"), "roc");
  EXPECT_EQ(kind("  ipf-type = zaic_spd\n"), "zaic_spd");
  EXPECT_EQ(kind("  ipf_type = unheard_of\n"), "zaic") << "as pHelmIvP takes it";
}

TEST(CoupledBehaviors, ShareTheirWeightBetweenCourseAndSpeed) {
  const std::string way =
      BehaviorBlock("BHV_Waypoint", "  points = 0,1000\n  speed = 2\n  pwt = 100\n");
  HelmFlight flight(way + BehaviorBlock("BHV_ConstantSpeed", "  speed = 0.5\n  pwt = 30\n"));
  flight.Tick();
  EXPECT_NEAR(*flight.decision().speed, 0.5, 1e-9)
      << "of the way, which likes that half as well, 50";
  HelmFlight patient(
      BehaviorBlock("BHV_Waypoint",
                    "  points = 0,1000\n  speed = 2\n  pwt = 100\n  patience = 10\n") +
      BehaviorBlock("BHV_ConstantSpeed", "  speed = 0.5\n  pwt = 30\n"));
  patient.Tick();
  EXPECT_NEAR(*patient.decision().speed, 2.0, 1e-9) << "90 of the way";
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/launch/deployment.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/launch/surfacing.hpp"

namespace limpet {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

class DeploymentTest : public testing::Test {
 protected:
  DeploymentTest() {
    signs_.is_all_up = signs_.has_helm = signs_.has_survey = true;
    signs_.helm_words = 2;
  }
  bool WritesAt(double seconds) { return deployment_.Mind(signs_, Seconds(seconds)).writes; }
  void GetUnderWay() { signs_.deploy = "true", signs_.phase = "ALIGN", signs_.helm_stop = "clear"; }

  DeploymentSigns signs_;
  Deployment deployment_{true};
};

TEST_F(DeploymentTest, WaitsUntilAllAreUpAndTheHelmHasPostedItsInitialValues) {
  signs_.is_all_up = false;
  EXPECT_FALSE(WritesAt(0.0));
  signs_.is_all_up = true, signs_.helm_words = 1;  // what a former helm left in a foreign database
  EXPECT_FALSE(WritesAt(0.1));
  signs_.helm_words = 2;
  EXPECT_TRUE(WritesAt(0.2));
  EXPECT_FALSE(WritesAt(0.3));
}

TEST_F(DeploymentTest, WritesAgainWhenSomebodyWroteOverIt) {
  EXPECT_TRUE(WritesAt(0.0));
  signs_.deploy = "false", signs_.phase = "ALIGN";
  EXPECT_FALSE(WritesAt(0.5));
  EXPECT_TRUE(WritesAt(1.1));
  GetUnderWay();
  EXPECT_FALSE(WritesAt(2.0));
  signs_.deploy = "false";  // an operator
  EXPECT_FALSE(WritesAt(9.0)) << "once under way it is left to the operator";
}

TEST_F(DeploymentTest, WarnsOfAMissionThatDoesNotGetUnderWay) {
  EXPECT_TRUE(WritesAt(0.0));
  signs_.deploy = "true", signs_.phase = "ALIGN", signs_.helm_stop = "NothingToDo";
  EXPECT_FALSE(WritesAt(9.0));
  EXPECT_THAT(deployment_.warning(), IsEmpty());
  EXPECT_THAT(deployment_.Mind(signs_, Seconds(10.1)).says, HasSubstr("NothingToDo"));
  EXPECT_THAT(deployment_.warning(), HasSubstr("not under way"));
  GetUnderWay();
  EXPECT_EQ(deployment_.Mind(signs_, Seconds(11.0)).says, "the mission is under way");
  EXPECT_THAT(deployment_.warning(), IsEmpty());
}

TEST_F(DeploymentTest, WarnsOfAHelmThatNeverSpeaks) {
  signs_.helm_words = 0;
  EXPECT_FALSE(WritesAt(0.0));
  EXPECT_THAT(deployment_.Mind(signs_, Seconds(10.1)).says, HasSubstr("the helm has not iterated"));
}

TEST_F(DeploymentTest, GivesUpWritingAfterAWhile) {
  int writes = 0;
  for (double t = 0.0; t < 60.0; t += 0.5)
    writes += WritesAt(t) ? 1 : 0;
  EXPECT_EQ(writes, Deployment::kMostWrites);
}

TEST(Surfacing, EndsTheMissionOnceTheVehicleIsUp) {
  Surfacing surfacing;
  EXPECT_FALSE(surfacing.EndsNow({.was_deployed = true}, Seconds(0.0)));
  surfacing.Begin("pNav is given up", Seconds(0.0));
  EXPECT_FALSE(surfacing.EndsNow({.was_deployed = true, .depth_m = 0.3}, Seconds(1.0)))
      << "it may be on its way down";
  EXPECT_FALSE(surfacing.EndsNow({.was_deployed = true, .depth_m = 3.0}, Seconds(10.0)));
  EXPECT_TRUE(surfacing.EndsNow({.was_deployed = true, .depth_m = 0.3}, Seconds(20.0)));
  EXPECT_FALSE(surfacing.EndsNow({.was_deployed = true, .depth_m = 0.3}, Seconds(21.0)));
}

TEST(Surfacing, WaitsNoLongerThanAnAscentForADepthThatNobodyTells) {
  Surfacing surfacing;
  surfacing.Begin("pNav is given up", Seconds(0.0));
  EXPECT_FALSE(surfacing.EndsNow({.was_deployed = true}, Seconds(179.0)));
  EXPECT_TRUE(surfacing.EndsNow({.was_deployed = true}, Seconds(181.0)));
}

TEST(Surfacing, DoesNotWaitForAVehicleThatWasNeverDeployed) {
  Surfacing surfacing;
  surfacing.Begin("pNav is given up", Seconds(0.0));
  EXPECT_TRUE(surfacing.EndsNow({.was_deployed = false}, Seconds(0.1)));
}

}  // namespace
}  // namespace limpet

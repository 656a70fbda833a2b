// SPDX-License-Identifier: MIT
#include "limpet/replay_output/replay_tables.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace limpet {
namespace {

TEST(ReplayTables, PosesAreInNedSecondsMetresAndRadians) {
  SmoothedPose pose{.t = 12.5, .X_WB = {}};
  pose.X_WB.p_WB = {1.0, -2.0, 3.25};
  pose.X_WB.yaw = -0.5;
  EXPECT_EQ(PosesCsv({pose}),
            "t,x,y,z,roll,pitch,yaw\n12.500,1.0000,-2.0000,3.2500,0.00000,0.00000,-0.50000\n");
}

TEST(ReplayTables, SmoothedPosesHaveTheirSigmasAtTheEnd) {
  SmoothedPose pose{.t = 12.5, .X_WB = {}};
  EXPECT_EQ(SmoothedCsv({pose}, {{0.25, 0.5, 0.125, 0.01}}),
            "t,x,y,z,roll,pitch,yaw,sd_x,sd_y,sd_z,sd_yaw\n"
            "12.500,0.0000,0.0000,0.0000,0.00000,0.00000,0.00000,0.25,0.5,0.125,0.01\n");
}

TEST(ReplayTables, StatesHaveALineEachWithTheirSigma) {
  EXPECT_EQ(StatesCsv({{.t = 1.0, .states = {{"current_north", 0.03, 0.01}, {"delay", 0.2, 0.05}}},
                       {.t = 2.0, .states = {}}}),
            "t,state,value,sd\n1.000,current_north,0.03,0.01\n1.000,delay,0.2,0.05\n");
}

TEST(ReplayTables, AnObjectThatNoFormerSessionKnewIsMatchedWithNone) {
  std::vector<Landmark> landmarks(2);
  landmarks[0].id = 4, landmarks[0].former.id = 9;
  landmarks[1].id = 5;
  EXPECT_EQ(MatchesCsv(landmarks), "landmark,former\n4,9\n5,-1\n");
}

TEST(ReplayTables, ABoxIsNamedByItsFrameAndItsPlaceInIt) {
  EXPECT_EQ(AssociationsCsv({{.frame = 7, .detection = 1, .landmark = 3}, {.frame = 8}}),
            "frame,det,landmark\n7,1,3\n8,0,-1\n");
}

TEST(ReplayTables, TimesAreInMillisecondsWhateverTheirOrder) {
  std::vector<double> updates;
  for (int i = 100; i > 0; --i) {
    updates.push_back(1e-3 * i);
  }
  const auto json = nlohmann::json::parse(TimingJson(updates, 6.0));
  EXPECT_EQ(json.at("updates"), 100);
  EXPECT_NEAR(json.at("median_ms").get<double>(), 50.0, 1.0);
  EXPECT_NEAR(json.at("p99_ms").get<double>(), 99.0, 1.0);
  EXPECT_NEAR(json.at("max_ms").get<double>(), 100.0, 1e-9);
  EXPECT_GT(json.at("peak_rss_mb").get<double>(), 1.0);
  EXPECT_EQ(nlohmann::json::parse(TimingJson({}, 0.0)).at("max_ms"), 0.0) << "of none";
}

}  // namespace
}  // namespace limpet

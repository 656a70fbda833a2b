// SPDX-License-Identifier: MIT
// One app of an embedded mission hangs under way: what becomes of the vehicle.
#include <cmath>
#include <filesystem>
#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/app/embedded.hpp"
#include "limpet/runs/session_runner.hpp"
#include "limpet/topics/mission.hpp"
#include "limpet/topics/navigation.hpp"
#include "limpet/topics/simulation.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;
using ::testing::AnyOf;

/// The basin's dive without a camera: it never sees anything, so it is ended by its limits.
class StalledDive {
 public:
  StalledDive() {
    MissionFile mission = LoadMission(kFolder / "mission.moos");
    for (const char* setting : {"pSurvey.align_s=5", "pSurvey.last_fix_s=1", "pSurvey.stall_s=20",
                                "pSurvey.lost_s=60", "pSurvey.give_up_s=60"}) {
      ApplySetting(mission, setting);
    }
    EmbeddedSetup setup;
    setup.community = "basin";
    setup.apps = {"uSimVehicle", "uSimSensors", "pNav", "pSurvey", "pHelm", "pPilot"};
    setup.blocks = mission.blocks;
    setup.globals = mission.globals;
    setup.mission_folder = kFolder;
    setup.run_folder = folder_.path();
    setup.session = "discovery";
    community_.emplace(std::move(setup));
    community_->Observe([this](const Message& message) { Note(message); });
    Run(1.0);
    community_->Poke("DEPLOY", std::string("true"));
  }
  void Run(double seconds) {
    const Seconds end = community_->elapsed() + Seconds(seconds);
    while (community_->elapsed() < end)
      community_->Step();
  }
  /// Until the vehicle is under way at depth.
  void DiveDeep() {
    while (truth_.down < 1.5 && community_->elapsed() < Seconds(120.0))
      community_->Step();
  }
  void RunToTheEnd() {
    while (ended_.empty() && community_->elapsed() < Seconds(900.0))
      community_->Step();
  }
  void Stall(const std::string& app, bool hangs = true) { community_->Stall(app, hangs); }
  void StallDatabase(bool hangs = true) { community_->StallDatabase(hangs); }
  [[nodiscard]] Seconds now() const { return community_->now(); }
  [[nodiscard]] const SimTruth& truth() const { return truth_; }
  [[nodiscard]] const SimThrust& thrust() const { return thrust_; }
  [[nodiscard]] const std::string& ended() const { return ended_; }
  [[nodiscard]] Seconds navigation_stamp() const { return nav_t_; }
  /// Of the estimate, horizontal [m].
  [[nodiscard]] double navigation_error() const {
    return std::hypot(nav_.north - truth_.north, nav_.east - truth_.east);
  }

 private:
  inline static const fs::path kFolder = fs::path(LIMPET_SOURCE_DIR) / "missions" / "basin";
  void Note(const Message& message) {
    if (message.name == topics::kSimTruth.name) {
      truth_ = *TopicCodec<SimTruth>::Decode(message.value);
    } else if (message.name == topics::kNavState.name) {
      nav_ = *TopicCodec<NavState>::Decode(message.value);
      nav_t_ = message.time;
    } else if (message.name == topics::kSimThrust.name) {
      thrust_ = *TopicCodec<SimThrust>::Decode(message.value);
    } else if (message.name == topics::kMissionEnd.name) {
      ended_ = std::get<std::string>(message.value);
    }
  }
  TemporaryFolder folder_;
  std::optional<EmbeddedCommunity> community_;
  SimTruth truth_;
  SimThrust thrust_;
  NavState nav_;
  Seconds nav_t_;
  std::string ended_;
};

class StalledApp : public testing::TestWithParam<const char*> {};

TEST_P(StalledApp, MeansZeroThrustWithinASecondAndTheSurfaceAndADeclaredEnd) {
  StalledDive dive;
  dive.DiveDeep();
  ASSERT_GT(dive.truth().down, 1.4);
  ASSERT_GT(dive.thrust().greatest, 0.0);
  const Seconds stalled = dive.now();
  dive.Stall(GetParam());
  dive.Run(1.2);
  EXPECT_EQ(dive.thrust().greatest, 0.0);
  ASSERT_TRUE(dive.thrust().zero_at);
  EXPECT_LE(*dive.thrust().zero_at - stalled.value(), 1.2);
  dive.RunToTheEnd();
  EXPECT_THAT(dive.ended(), AnyOf("home", "aborted", "timeout", "lost"));
  EXPECT_LT(dive.truth().down, 0.2);
  EXPECT_EQ(dive.thrust().greatest, 0.0);
}

INSTANTIATE_TEST_SUITE_P(UnderWay, StalledApp, testing::Values("pPilot", "pHelm", "pNav"),
                         [](const auto& tested) { return std::string(tested.param); });

TEST(StalledPilot, TakesTheControlsAgainWhenItGoesOn) {
  StalledDive dive;
  dive.DiveDeep();
  dive.Stall("pPilot");
  dive.Run(5.0);
  EXPECT_EQ(dive.thrust().greatest, 0.0);
  dive.Stall("pPilot", false);
  dive.Run(3.0);
  EXPECT_GT(dive.thrust().greatest, 0.0);
}

TEST(StalledDatabase, MeansZeroThrustWithinASecondAndADiveThatGoesOnWhenItIsBack) {
  StalledDive dive;
  dive.DiveDeep();
  ASSERT_GT(dive.thrust().greatest, 0.0);
  const Seconds stalled = dive.now();
  dive.StallDatabase();
  dive.Run(8.0);
  dive.StallDatabase(false);
  ASSERT_TRUE(dive.thrust().zero_at);
  EXPECT_GT(*dive.thrust().zero_at, stalled.value());
  EXPECT_LE(*dive.thrust().zero_at - stalled.value(), 1.2);
  dive.Run(10.0);
  EXPECT_GT(dive.thrust().greatest, 0.0);
  EXPECT_LT((dive.now() - dive.navigation_stamp()).value(), 0.5);
  EXPECT_LT(dive.navigation_error(), 1.5);
  dive.RunToTheEnd();
  EXPECT_THAT(dive.ended(), AnyOf("home", "aborted", "timeout", "lost"));
  dive.Run(5.0);
  EXPECT_LT(dive.truth().down, 0.3);
  EXPECT_EQ(dive.thrust().greatest, 0.0);
}

}  // namespace
}  // namespace limpet

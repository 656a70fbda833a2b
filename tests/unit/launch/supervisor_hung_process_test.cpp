// SPDX-License-Identifier: MIT
// What becomes of a vehicle under way when one of its processes hangs, dies for good, or is ended:
// real processes, stopped by SIGSTOP.
#include <chrono>
#include <csignal>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/topics/safety.hpp"
#include "tests/unit/launch/live_mission.hpp"

namespace limpet {
namespace {

using ::testing::AnyOf;
using ::testing::HasSubstr;

/// Vehicle time from a hang to zero thrust; a machine that wakes its processes late may add what
/// it was late.
constexpr Seconds kZeroAfter(1.2);

class HungProcess : public testing::TestWithParam<const char*> {};

TEST_P(HungProcess, StopsTheThrustersAndIsReplacedAndTheMissionEnds) {
  const std::string name = GetParam();
  LiveMission mission;
  mission.Launch();
  ASSERT_TRUE(mission.AwaitDive()) << mission.Said();
  const pid_t pid = mission.PidOf(name);
  ASSERT_GT(pid, 0);
  const Seconds stopped = mission.Now();
  ASSERT_EQ(::kill(pid, SIGSTOP), 0);
  ASSERT_TRUE(mission.Await([&] {
    const auto thrust = mission.Thrust();
    return thrust && thrust->zero_at && *thrust->zero_at > stopped.value();
  })) << mission.Said();
  const Seconds zero_after = Seconds(*mission.Thrust()->zero_at) - stopped;
  EXPECT_LE(zero_after, kZeroAfter + mission.lateness() * 2.0);
  RecordProperty("zero_after_ms", static_cast<int>(1e3 * zero_after.value()));
  EXPECT_LE(mission.Thrust()->oldest_obeyed, 1.0 + 1e-6);
  ASSERT_TRUE(mission.Await([&] {
    return mission.Latest("PLAUNCH_STATUS")
               .find("app=" + name + ",state=running,restarts=1,last=hung and was killed") !=
           std::string::npos;
  })) << mission.Said();
  ASSERT_TRUE(mission.Await([&] {
    mission.Poke("RETURN", "true");
    return !mission.Latest("MISSION_END").empty();
  })) << mission.Said();
  EXPECT_THAT(mission.Latest("MISSION_END"), AnyOf("home", "aborted", "timeout", "lost"));
  EXPECT_EQ(mission.AwaitEnd(), 0) << mission.Said();
  EXPECT_THAT(mission.Said(), HasSubstr(name + " hangs: no sign of life for"));
}

INSTANTIATE_TEST_SUITE_P(UnderWay, HungProcess,
                         testing::Values("pPilot", "pHelm", "pNav", "LimpetDB"),
                         [](const auto& tested) { return std::string(tested.param); });

TEST(HungDatabase, ThatGoesOnByItselfLeavesTheVehicleUnderWay) {
  const LiveMission::Lines patience{{"LimpetDB", "HungAfter_s = 60"}};
  LiveMission mission(patience);
  mission.Launch();
  ASSERT_TRUE(mission.AwaitDive()) << mission.Said();
  const pid_t pid = mission.PidOf("LimpetDB");
  ASSERT_GT(pid, 0);
  const Seconds stopped = mission.Now();
  ASSERT_EQ(::kill(pid, SIGSTOP), 0);
  std::this_thread::sleep_for(std::chrono::seconds(3));
  ASSERT_EQ(::kill(pid, SIGCONT), 0);
  ASSERT_TRUE(mission.Await([&] {
    const auto thrust = mission.Thrust();
    return thrust && thrust->zero_at && *thrust->zero_at > stopped.value();
  })) << mission.Said();
  ASSERT_TRUE(mission.Await([&] {
    const auto thrust = mission.Thrust();
    return thrust && thrust->greatest > 0.0;
  })) << mission.Said();
  EXPECT_EQ(mission.PidOf("LimpetDB"), pid);
  EXPECT_EQ(mission.Latest("PLAUNCH_STATUS").find("last=hung"), std::string::npos);
  ASSERT_EQ(::kill(mission.launcher(), SIGINT), 0);
  EXPECT_EQ(mission.AwaitEnd(), 0);
}

TEST(LaunchEnd, LeavesZeroThrustAsTheLastWord) {
  LiveMission mission;
  mission.Launch();
  ASSERT_TRUE(mission.AwaitDive()) << mission.Said();
  ASSERT_TRUE(mission.Await([&mission] { return !mission.Latest("PLAUNCH_MEMORY").empty(); }));
  EXPECT_GT(std::stod(mission.Latest("PLAUNCH_MEMORY")), 20.0) << "MiB of seven processes";
  ASSERT_TRUE(mission.Await([&mission] { return !mission.Latest("PLAUNCH_PROCESSOR").empty(); }));
  const auto load = DecodeRecord<ProcessorLoad>(mission.Latest("PLAUNCH_PROCESSOR"));
  ASSERT_TRUE(load);
  EXPECT_GT(load->percent, 0.0);
  EXPECT_LT(load->percent, 1000.0);
  EXPECT_THAT(load->app, testing::MatchesRegex("LimpetDB|[pu][A-Z].*"));
  ASSERT_EQ(::kill(mission.launcher(), SIGINT), 0);
  EXPECT_EQ(mission.AwaitEnd(), 0);
  EXPECT_EQ(mission.SourceOf("THRUSTER_COMMAND"), "pLaunch");
  EXPECT_EQ(mission.Latest("THRUSTER_COMMAND"), "t1=0,t2=0,t3=0,t4=0,t5=0,t6=0");
  EXPECT_THAT(mission.Said(), HasSubstr("thrusters off"));
}

TEST(LostProcess, BringsTheVehicleUpAndEndsTheMissionWhenAVitalAppIsGivenUp) {
  const LiveMission::Lines never{{"pHelm", "Restart = never"}};
  LiveMission mission(never);
  mission.Launch();
  ASSERT_TRUE(mission.AwaitDive()) << mission.Said();
  ASSERT_TRUE(mission.Await([&] {
    const auto truth = DecodeRecord<SimTruth>(mission.Latest("SIM_TRUTH"));
    return truth && truth->down > 0.6;
  })) << mission.Said();
  ASSERT_EQ(::kill(mission.PidOf("pHelm"), SIGKILL), 0);
  ASSERT_TRUE(mission.Await([&] { return !mission.Latest("MISSION_END").empty(); }))
      << mission.Said();
  EXPECT_EQ(mission.Latest("MISSION_END"), "aborted");
  const auto truth = DecodeRecord<SimTruth>(mission.Latest("SIM_TRUTH"));
  ASSERT_TRUE(truth);
  EXPECT_LT(truth->down, 0.7) << "the mission ends at the surface";
  EXPECT_EQ(mission.Thrust()->greatest, 0.0);
  EXPECT_EQ(mission.AwaitEnd(), 1);
  EXPECT_THAT(mission.Said(), HasSubstr("MISSION_END = aborted: pHelm is given up"));
}

TEST(LaunchDeploys, AlsoWhenTheHelmIsSlowToPostItsInitialValues) {
  // It is in the community at once, and says DEPLOY = false with its first tick.
  const LiveMission::Lines slow{{"pHelm", "  AppTick = 0.5"}};
  LiveMission mission({}, slow);
  mission.Launch();
  ASSERT_TRUE(mission.Await([&] {
    return mission.Latest("SURVEY_PHASE") == "ALIGN" || mission.Latest("SURVEY_PHASE") == "DIVE";
  })) << mission.Said();
  ASSERT_TRUE(mission.Await([&] { return mission.Latest("IVPHELM_ALLSTOP") == "clear"; }))
      << mission.Said();
  EXPECT_EQ(mission.Latest("DEPLOY"), "true");
}

}  // namespace
}  // namespace limpet

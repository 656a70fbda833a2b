// SPDX-License-Identifier: MIT
#include "limpet/launch/supervisor.hpp"

#include <fstream>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/core/clock.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class SupervisorTest : public testing::Test {
 protected:
  [[nodiscard]] static LaunchItem Shell(const std::string& name, const std::string& script) {
    return {.name = name, .program = "/bin/sh", .args = {"-c", script}};
  }
  /// Polls until nothing runs or `until` holds; false after 10 s.
  template <class Condition>
  bool PollUntil(Condition until) {
    const Seconds deadline = SteadyTime() + Seconds(10.0);
    while (SteadyTime() < deadline) {
      if (!supervisor_.Poll() || until()) {
        return true;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return false;
  }
  [[nodiscard]] std::string LogOf(const std::string& name) const {
    std::ifstream in(folder_.path() / (name + ".log"));
    return {std::istreambuf_iterator<char>(in), {}};
  }

  TemporaryFolder folder_;
  std::string said_;
  Supervisor supervisor_{folder_.path(),
                         {{"LIMPET_SESSION", "change"}},
                         [this](const std::string& text) { said_ += text + "\n"; }};
};

TEST_F(SupervisorTest, KeepsWhatAProcessPrints) {
  supervisor_.Start(Shell("pSay", "echo out; echo err >&2; echo $LIMPET_SESSION"));
  EXPECT_TRUE(PollUntil([] { return false; }));
  EXPECT_EQ(LogOf("pSay"), "out\nerr\nchange\n");
  EXPECT_FALSE(supervisor_.has_given_up());
}

TEST_F(SupervisorTest, RunsAProcessInItsFolder) {
  LaunchItem item = Shell("pWhere", "pwd");
  item.working_folder = "/usr";
  supervisor_.Start(item);
  EXPECT_TRUE(PollUntil([] { return false; }));
  EXPECT_EQ(LogOf("pWhere"), "/usr\n");
}

TEST_F(SupervisorTest, StartsAgainWhatFailed) {
  supervisor_.Start(Shell("pFail", "echo try; exit 1"));
  EXPECT_TRUE(PollUntil([this] { return LogOf("pFail").size() >= 8; }));
  EXPECT_THAT(said_, HasSubstr("pFail ended with code 1; again in 0.5 s"));
}

TEST_F(SupervisorTest, KeepsAProcessDownForAsLongAsItIsTold) {
  supervisor_.Start(Shell("pNap", "echo nap; exec sleep 60"));
  EXPECT_TRUE(PollUntil([this] { return LogOf("pNap") == "nap\n"; }));
  supervisor_.KeepDown("pNap", true);
  EXPECT_TRUE(
      PollUntil([this] { return supervisor_.Status().find("waiting") != std::string::npos; }));
  const Seconds later = SteadyTime() + Seconds(1.0);  // beyond its first pause
  EXPECT_TRUE(PollUntil([later] { return SteadyTime() > later; }));
  EXPECT_EQ(LogOf("pNap"), "nap\n");
  supervisor_.KeepDown("pNap", false);
  EXPECT_TRUE(PollUntil([this] { return LogOf("pNap") == "nap\nnap\n"; }));
}

TEST_F(SupervisorTest, HaltsNobodyWhoNeverBegan) {
  supervisor_.Start(Shell("pSay", "sleep 0.2; echo out"));
  supervisor_.Halt("pSay", true);
  EXPECT_TRUE(PollUntil([] { return false; }));
  EXPECT_EQ(LogOf("pSay"), "out\n") << "it gives no sign of life that could be missed";
}

TEST_F(SupervisorTest, TellsAProcessThatItWasStartedAgain) {
  supervisor_.Start(Shell("pFail", "echo \"again=$LIMPET_RESTARTED\"; exit 1"));
  EXPECT_TRUE(PollUntil([this] { return LogOf("pFail").size() >= 15; }));
  EXPECT_EQ(LogOf("pFail"), "again=\nagain=1\n");
}

TEST_F(SupervisorTest, GivesUpARefusedConfigurationAtOnce) {
  supervisor_.Start(Shell("pBad", "echo try; exit 2"));
  EXPECT_TRUE(PollUntil([] { return false; }));
  EXPECT_EQ(LogOf("pBad"), "try\n");
  EXPECT_TRUE(supervisor_.has_given_up());
  EXPECT_THAT(said_, HasSubstr("its configuration is refused"));
}

TEST_F(SupervisorTest, LeavesAProcessAloneThatIsNotToBeRestarted) {
  LaunchItem item = Shell("pOnce", "echo try; exit 3");
  item.restart = RestartPolicy::kNever;
  supervisor_.Start(item);
  EXPECT_TRUE(PollUntil([] { return false; }));
  EXPECT_EQ(LogOf("pOnce"), "try\n");
}

TEST_F(SupervisorTest, SaysWhatBecameOfEachProcess) {
  LaunchItem once = Shell("pOnce", "exit 3");
  once.restart = RestartPolicy::kNever;
  supervisor_.Start(once);
  supervisor_.Start(Shell("pFail", "exit 1"));
  supervisor_.Start(Shell("pWell", "exit 0"));
  EXPECT_TRUE(PollUntil([this] {
    return supervisor_.Status() ==
           "app=pOnce,state=given_up,restarts=0,last=ended with code 3,database=false # "
           "app=pFail,state=waiting,restarts=0,last=ended with code 1,database=false # "
           "app=pWell,state=ended,restarts=0,last=ended with code 0,database=false";
  }));
  EXPECT_TRUE(PollUntil([this] {
    return supervisor_.Status().find("app=pFail,state=waiting,restarts=1") != std::string::npos;
  }));
}

TEST_F(SupervisorTest, KnowsTheMemoryOfWhatRuns) {
  EXPECT_FALSE(supervisor_.ResidentMib());
  supervisor_.Start(Shell("pApp", "echo up; while :; do sleep 0.01; done"));
  EXPECT_TRUE(PollUntil([this] { return !LogOf("pApp").empty(); }));
  const double one = supervisor_.ResidentMib().value();
  EXPECT_GT(one, 0.1);
  supervisor_.Start(Shell("pOther", "echo up; while :; do sleep 0.01; done"));
  EXPECT_TRUE(PollUntil([this] { return !LogOf("pOther").empty(); }));
  EXPECT_NEAR(supervisor_.ResidentMib().value(), 2.0 * one, 0.5 * one);
}

TEST_F(SupervisorTest, EndsTheDatabaseLast) {
  LaunchItem database{.name = "LimpetDB", .program = "/bin/sh", .args = {}, .is_database = true};
  const std::string order = (folder_.path() / "order").string();
  const auto script = [&](const std::string& name) {
    return "trap 'echo " + name + " >> " + order +
           "; exit 0' TERM; echo ready; while :; do sleep 0.01; done";
  };
  database.args = {"-c", script("LimpetDB")};
  supervisor_.Start(database);
  supervisor_.Start(Shell("pApp", script("pApp")));
  EXPECT_TRUE(PollUntil([this] { return !LogOf("LimpetDB").empty() && !LogOf("pApp").empty(); }));
  supervisor_.End(Seconds(5.0));
  std::ifstream in(order);
  EXPECT_EQ((std::string{std::istreambuf_iterator<char>(in), {}}), "pApp\nLimpetDB\n");
}

TEST_F(SupervisorTest, KeepsAFileInMemoryForADatabaseThatFails) {
  LaunchItem database = Shell("LimpetDB",
                              "cat /proc/self/fd/$LIMPET_KEPT_FD; "
                              "echo kept > /proc/self/fd/$LIMPET_KEPT_FD; exit 1");
  database.is_database = true;
  supervisor_.Start(database);
  EXPECT_TRUE(PollUntil([this] { return LogOf("LimpetDB") == "kept\n"; }));
}

TEST_F(SupervisorTest, LetsADatabaseThatFailsAgainAndAgainStartEmpty) {
  LaunchItem database = Shell("LimpetDB",
                              "echo -n . >> /proc/self/fd/$LIMPET_KEPT_FD; "
                              "wc -c < /proc/self/fd/$LIMPET_KEPT_FD; exit 1");
  database.is_database = true;
  supervisor_.Start(database);
  EXPECT_TRUE(PollUntil([this] { return LogOf("LimpetDB") == "1\n2\n3\n1\n"; }));
  EXPECT_THAT(said_, HasSubstr("LimpetDB starts without its former values"));
}

/// Beats like one of ours, ten times, and then hangs: a shell that writes into the shared page.
LaunchItem HangsAfterABeat() {
  LaunchItem item{.name = "pHang", .program = "/bin/sh", .args = {}};
  item.args = {"-c",
               "printf '\\001' | dd of=/proc/self/fd/$LIMPET_BEAT_FD conv=notrunc 2>/dev/null; "
               "echo try; sleep 60"};
  item.hung_after = Seconds(0.3);
  return item;
}

TEST_F(SupervisorTest, KillsAndStartsAgainWhatHangs) {
  supervisor_.Start(HangsAfterABeat());
  EXPECT_TRUE(PollUntil([this] { return LogOf("pHang") == "try\ntry\n"; }));
  EXPECT_THAT(said_, HasSubstr("pHang hangs: no sign of life for"));
  EXPECT_THAT(said_, HasSubstr("pHang hung and was killed; again in 0.5 s"));
  EXPECT_THAT(supervisor_.Status(), HasSubstr("restarts=1,last=hung and was killed"));
  supervisor_.End(Seconds(0.1));
}

/// Its first life showed that it is one of ours.
TEST_F(SupervisorTest, KillsWhatHangsBeforeTheFirstSignOfItsSecondLife) {
  LaunchItem item = HangsAfterABeat();
  item.args.back() = "test -n \"$LIMPET_RESTARTED\" && echo mute && sleep 60; " +
                     item.args.back().substr(0, item.args.back().find("echo")) +
                     "sleep 0.3; exit 1";
  item.hung_after = Seconds(0.1);
  supervisor_.Start(item);
  EXPECT_TRUE(PollUntil([this] { return LogOf("pHang") == "mute\nmute\n"; })) << said_;
  EXPECT_THAT(said_, HasSubstr("pHang hangs: no sign of life for 1.0 s"));
  supervisor_.End(Seconds(0.1));
}

TEST_F(SupervisorTest, KillsWhatIsHaltedAsItStarts) {
  LaunchItem item = Shell("pHalted", "echo try; kill -STOP $$; echo went on");
  item.hung_after = Seconds(0.3);
  supervisor_.Start(item);
  EXPECT_TRUE(PollUntil([this] { return LogOf("pHalted") == "try\ntry\n"; })) << said_;
  EXPECT_THAT(said_, HasSubstr("pHalted hangs: no sign of life for 0.3 s"));
  supervisor_.End(Seconds(0.1));
}

TEST_F(SupervisorTest, LeavesAloneWhatIsHaltedForAMomentAsItStarts) {
  LaunchItem item = Shell("pHalted", "(sleep 0.4; kill -CONT $$) & kill -STOP $$; echo went on");
  item.hung_after = Seconds(2.0);
  supervisor_.Start(item);
  EXPECT_TRUE(PollUntil([this] { return LogOf("pHalted") == "went on\n"; })) << said_;
  EXPECT_THAT(said_, Not(HasSubstr("hangs")));
  supervisor_.End(Seconds(0.1));
}

TEST_F(SupervisorTest, LeavesAloneWhatNeverGaveASignOfLife) {
  LaunchItem item = Shell("pForeign", "echo try; sleep 60");
  item.hung_after = Seconds(0.1);
  supervisor_.Start(item);
  const Seconds begin = SteadyTime();
  EXPECT_TRUE(PollUntil([&] { return SteadyTime() - begin > Seconds(0.6); }));
  EXPECT_EQ(said_, "");
  supervisor_.End(Seconds(0.1));
}

TEST_F(SupervisorTest, LeavesAloneWhatIsNotToBeKilledForHanging) {
  LaunchItem item = HangsAfterABeat();
  item.hung_after = Seconds(0.0);
  supervisor_.Start(item);
  const Seconds begin = SteadyTime();
  EXPECT_TRUE(PollUntil([&] { return SteadyTime() - begin > Seconds(0.8); }));
  EXPECT_EQ(said_, "");
  supervisor_.End(Seconds(0.1));
}

TEST_F(SupervisorTest, KnowsWhichVitalProcessItHasGivenUp) {
  LaunchItem item = Shell("pNav", "exit 2");
  supervisor_.Start(item);
  item.name = "pHelm", item.is_vital = true;
  supervisor_.Start(item);
  EXPECT_TRUE(PollUntil([] { return false; }));
  EXPECT_EQ(supervisor_.LostVital(), "pHelm");
  EXPECT_FALSE(supervisor_.HasLostDatabase());
}

TEST_F(SupervisorTest, EndsInTwoWavesWithRoomForALastWord) {
  const std::string order = (folder_.path() / "order").string();
  const auto script = [&](const std::string& name) {
    return "trap 'echo " + name + " >> " + order +
           "; exit 0' TERM; echo ready; while :; do sleep 0.01; done";
  };
  supervisor_.Start(Shell("uDriver", script("uDriver")));
  supervisor_.Start(Shell("pPilot", script("pPilot")));
  EXPECT_TRUE(PollUntil([this] { return !LogOf("uDriver").empty() && !LogOf("pPilot").empty(); }));
  supervisor_.End(
      Seconds(5.0), [](const std::string& name) { return name == "uDriver"; },
      [&order] { std::ofstream(order, std::ios::app) << "zero\n"; });
  std::ifstream in(order);
  EXPECT_EQ((std::string{std::istreambuf_iterator<char>(in), {}}), "pPilot\nzero\nuDriver\n");
}

TEST_F(SupervisorTest, KillsWhatDoesNotEnd) {
  supervisor_.Start(Shell("pDeaf", "trap '' TERM; echo ready; while :; do sleep 0.05; done"));
  EXPECT_TRUE(PollUntil([this] { return !LogOf("pDeaf").empty(); }));
  supervisor_.End(Seconds(0.2));
  EXPECT_FALSE(supervisor_.Poll());
  EXPECT_THAT(said_, HasSubstr("pDeaf did not end"));
}

}  // namespace
}  // namespace limpet

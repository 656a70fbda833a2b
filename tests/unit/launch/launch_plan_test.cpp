// SPDX-License-Identifier: MIT
#include "limpet/launch/launch_plan.hpp"

#include <cstdlib>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class LaunchPlanTest : public testing::Test {
 protected:
  LaunchPlanTest() {
    for (const char* program : {"pEcho", "LimpetDB"}) {
      std::ofstream(programs() / program) << "#!/bin/sh\n";
      fs::permissions(programs() / program, fs::perms::owner_all);
    }
  }
  [[nodiscard]] const fs::path& programs() const { return folder_.path(); }
  [[nodiscard]] fs::path Mission(const std::string& antler) const {
    const fs::path file = folder_.path() / "m.moos";
    std::ofstream(file) << "Community = alpha\nMOOSTimeWarp = 2\nProcessConfig = ANTLER\n{\n"
                        << antler << "}\n";
    return file;
  }
  [[nodiscard]] LaunchPlan Plan(const std::string& antler,
                                std::vector<std::string> options = {}) const {
    options.insert(options.begin(), Mission(antler).string());
    return PlanLaunch(ReadLaunchCommand(options), programs());
  }
  std::string Complaint(const std::string& antler, std::vector<std::string> options = {}) const {
    try {
      static_cast<void>(Plan(antler, std::move(options)));
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "";
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(LaunchPlanTest, GivesEachProcessTheMissionAndItsName) {
  const LaunchPlan plan = Plan("  Run = pEcho @ NewConsole = false ~ pEchoTwo\n");
  ASSERT_EQ(plan.items.size(), 1U);
  EXPECT_EQ(plan.items[0].name, "pEchoTwo");
  EXPECT_THAT(plan.items[0].args, ElementsAre(plan.mission_file.string(), "pEchoTwo"));
  EXPECT_EQ(plan.items[0].restart, RestartPolicy::kOnFailure);
}

TEST_F(LaunchPlanTest, PassesOverLinesOfOtherPeoplesThatMoosDropsAndNotOfOurs) {
  const std::string lines = "  just words\n  Run = pEcho\n";
  EXPECT_EQ(Plan(lines + "  Run = MOOSDB\n").items.size(), 2U);
  EXPECT_THAT(Complaint(lines + "  Run = LimpetDB\n"), HasSubstr("`just words` is neither"));
}

TEST_F(LaunchPlanTest, RunsAProgramThatIsNotOursWhereTheMissionIs) {
  const std::string before = std::getenv("PATH");  // NOLINT(concurrency-mt-unsafe): one thread
  const TemporaryFolder stock;
  for (const fs::path& program : {stock.path() / "iStock", programs() / "pHelmIvP"}) {
    std::ofstream(program) << "#!/bin/sh\n";
    fs::permissions(program, fs::perms::owner_all);
  }
  ::setenv("PATH", (stock.path().string() + ":" + before).c_str(), 1);  // NOLINT
  const LaunchPlan plan = Plan("  Run = pEcho\n  Run = iStock\n  Run = pHelmIvP\n");
  ::setenv("PATH", before.c_str(), 1);  // NOLINT
  ASSERT_EQ(plan.items.size(), 3U);
  EXPECT_EQ(plan.items[0].working_folder, "");
  for (const std::size_t i : {1U, 2U}) {
    EXPECT_EQ(plan.items[i].working_folder, plan.mission_file.parent_path());
    EXPECT_TRUE(fs::path(plan.items[i].args.at(0)).is_absolute());
  }
}

TEST_F(LaunchPlanTest, StartsLimpetDbWhereAMissionNamesMoosdb) {
  const LaunchPlan plan = Plan("  Run = MOOSDB @ NewConsole = false\n");
  EXPECT_EQ(plan.items[0].program.filename(), "LimpetDB");
  EXPECT_TRUE(plan.items[0].is_database);
}

TEST_F(LaunchPlanTest, ReplacesLinesInACopyOfTheMission) {
  const LaunchPlan plan = Plan("  Run = pEcho\n", {"--MOOSTimeWarp=10"});
  EXPECT_TRUE(plan.mission_file.string().ends_with("m.moos++"));
  EXPECT_EQ(plan.warp, 10.0);
}

TEST_F(LaunchPlanTest, RefusesToLaunchACopyThatCannotBeWritten) {
  fs::create_directory(programs() / "m.moos++");
  EXPECT_THAT(Complaint("  Run = pEcho\n", {"--MOOSTimeWarp=10"}),
              HasSubstr("m.moos++: cannot rename"));
}

TEST_F(LaunchPlanTest, LaunchesOnlyWhatItIsAskedFor) {
  const LaunchPlan plan =
      Plan("  Run = pEcho ~ pOne\n  Run = pEcho ~ pTwo\n  Run = pEcho ~ pThree\n", {"pOne pThree"});
  ASSERT_EQ(plan.items.size(), 2U);
  EXPECT_EQ(plan.items[1].name, "pThree");
}

TEST_F(LaunchPlanTest, NamesTheLineOfAProgramThatIsNowhere) {
  EXPECT_THAT(Complaint("  Run = pNowhere\n"), HasSubstr("m.moos:5"));
  EXPECT_THAT(Complaint("  Run = pNowhere\n"), HasSubstr("no program `pNowhere`"));
}

TEST_F(LaunchPlanTest, RefusesARestartPolicyThatIsNone) {
  EXPECT_THAT(Complaint("  Run = pEcho @ Restart = often\n"),
              HasSubstr("allowed: never, on_failure, always"));
}

TEST_F(LaunchPlanTest, IsPatientForThreeStatusPeriodsUnlessToldOtherwise) {
  const LaunchPlan plan = Plan(
      "  Run = pEcho ~ pOne\n  Run = pEcho @ HungAfter_s = 30 ~ pTwo\n"
      "  Run = pEcho @ HungAfter_s = 0 ~ pThree\n");
  EXPECT_EQ(plan.items[0].hung_after, Seconds(6.0));
  EXPECT_EQ(plan.items[1].hung_after, Seconds(30.0));
  EXPECT_EQ(plan.items[2].hung_after, Seconds(0.0));
  EXPECT_THAT(Complaint("  Run = pEcho @ HungAfter_s = soon\n"),
              HasSubstr("allowed: 1 to 3600 s, 0 for never"));
}

TEST_F(LaunchPlanTest, KnowsWhatAMissionCannotDoWithout) {
  const LaunchPlan plan =
      Plan("  Run = LimpetDB\n  Run = pEcho\n  Run = pEcho @ Vital = true ~ pTwo\n");
  EXPECT_TRUE(plan.items[0].is_vital);
  EXPECT_FALSE(plan.items[1].is_vital);
  EXPECT_TRUE(plan.items[2].is_vital);
  EXPECT_THAT(Complaint("  Run = pEcho @ Vital = perhaps\n"), HasSubstr("allowed: true, false"));
}

TEST_F(LaunchPlanTest, TakesArgumentsFromTheParameterThatALineNames) {
  const LaunchPlan plan = Plan(
      "  Run = pEcho @ ExtraProcessParams = EchoArgs\n  EchoArgs = --loud, --moos_port=9001\n");
  EXPECT_THAT(plan.items[0].args, testing::Contains("--moos_port=9001"));
}

TEST_F(LaunchPlanTest, ReplacesLinesOfPlugsToo) {
  fs::create_directories(programs() / "plugs");
  std::ofstream(programs() / "plugs" / "plug_pEcho.moos")
      << "ProcessConfig = pEcho\n{\n  gain = $(GAIN)\n}\n";
  const LaunchPlan plan = Plan(
      "  Run = pEcho\n  Run = LimpetDB\n}\n#define GAIN 3\n#include plug_pEcho.moos\n"
      "ProcessConfig = pOther\n{\n",
      {"--gain=7"});
  EXPECT_EQ(LoadMission(plan.mission_file).Block("pEcho")->Find("gain")->value, "7");
}

TEST(WithReplacements, TouchesNoOtherLine) {
  EXPECT_EQ(WithReplacements("A = 1\n  B=2 // two\n# A = 3\n", {{"B", "5"}}),
            "A = 1\n  B= 5\n# A = 3\n");
}

TEST(ReadLaunchCommand, RefusesAnOptionItDoesNotKnow) {
  EXPECT_THROW(static_cast<void>(ReadLaunchCommand({"m.moos", "--deplyo"})), ConfigError);
}

}  // namespace
}  // namespace limpet

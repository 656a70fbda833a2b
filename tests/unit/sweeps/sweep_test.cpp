// SPDX-License-Identifier: MIT
// Sweeps whose survey is a script: what a run is worth depends on its seed and settings alone.
#include "limpet/sweeps/sweep.hpp"

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/console/command_output.hpp"
#include "limpet/core/program_search.hpp"
#include "limpet/sweeps/child_process.hpp"
#include "tests/support/limpet_command.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class SweepTest : public testing::Test {
 protected:
  SweepTest() {
    fs::create_directories(At("m"));
    std::ofstream(At("m/mission.moos")) << "Community = a\n";
    // Called as `survey <mission> --seed N --out DIR ...`. Seed 13 leaves no report; seed 3 is
    // refused while there is a file `refuses`. Who finds no folder to put DIR into notes `gone`.
    std::ofstream(At("survey.sh")) << fmt::format(
        "#!/bin/sh\n[ -d \"${{6%/*}}\" ] || echo >{}\necho \"$4\" >>{}\n[ \"$4\" = 13 ] && exit "
        "1\n[ \"$4\" = 3 ] && [ -e {} ] && "
        "exit 3\nseed=$4\nout=$6\nshift 6\nmkdir -p \"$out\"\nprintf "
        "'{{\"seed\": %s, \"options\": \"%s\", \"sessions\": {{\"discovery\": {{\"path_m\": %s.5, "
        "\"wall_s\": %s}}}}}}' \"$seed\" \"$*\" \"$seed\" \"$$\" >\"$out/report.json\"\n",
        At("gone").string(), At("runs.txt").string(), At("refuses").string());
    fs::permissions(At("survey.sh"), fs::perms::owner_all);
  }
  [[nodiscard]] fs::path At(const std::string& name) const { return folder_.path() / name; }
  [[nodiscard]] SweepPlan Plan(const std::string& out, const std::string& runner = "local") const {
    return {.mission_folder = At("m"),
            .out = At(out),
            .runner = {.runner = runner, .jobs = 2, .batch_folder = At(out) / "batch"},
            .program = At("survey.sh").string()};
  }
  [[nodiscard]] static std::vector<SweepTask> Tasks(std::uint64_t seeds) {
    std::vector<SweepTask> tasks;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed)
      tasks.push_back({.settings = {seed % 2 == 0 ? "a.b=1" : "a.b=2"}, .seed = seed});
    return tasks;
  }
  [[nodiscard]] std::size_t RunsMade() const {
    const std::string text = TextOfFile(At("runs.txt"));
    return static_cast<std::size_t>(std::ranges::count(text, '\n'));
  }
  /// The same results in the same files as of the local runner.
  void ExpectSameBytes(const std::string& runner, std::uint64_t seeds) const {
    const auto local = Sweep(Plan("by_local")).Results(Tasks(seeds));
    const auto other = Sweep(Plan("by_other", runner)).Results(Tasks(seeds));
    ASSERT_TRUE(local && other);
    EXPECT_EQ(*local, *other);
    for (const SweepTask& task : Tasks(seeds)) {
      const fs::path file = Sweep::ResultFile(task);
      EXPECT_EQ(TextOfFile(At("by_local") / file), TextOfFile(At("by_other") / file)) << file;
    }
  }
  TemporaryFolder folder_;
};

TEST_F(SweepTest, FliesEachTaskOnceAndGoesOnWithMore) {
  const auto first = Sweep(Plan("out")).Results(Tasks(4));
  ASSERT_TRUE(first);
  EXPECT_THAT(first->at(2), HasSubstr("\"path_m\": 3.5"));
  EXPECT_THAT(first->at(2), HasSubstr("--set=a.b=2"));
  EXPECT_THAT(first->at(2), testing::Not(HasSubstr("wall_s"))) << "the machine's, not the run's";
  Sweep again(Plan("out"));
  const auto more = again.Results(Tasks(6));
  EXPECT_EQ(RunsMade(), 6U);
  EXPECT_EQ(again.run(), 2U);
  EXPECT_EQ(again.found(), 4U);
  EXPECT_EQ(more->at(2), first->at(2));
  EXPECT_FALSE(fs::exists(At("out/work"))) << "of a run only its result is kept";
}

TEST_F(SweepTest, KeepsARunsFolderThoughAllOthersOfItsSettingHaveEnded) {
  SweepPlan one_by_one = Plan("out");
  one_by_one.runner.jobs = 1;
  ASSERT_TRUE(Sweep(one_by_one).Results(Tasks(5)));
  EXPECT_FALSE(fs::exists(At("gone")));
}

TEST_F(SweepTest, TakesWhatAKilledDriverHadNotTakenYet) {
  const SweepTask task = Tasks(1)[0];
  const fs::path left = At("out/work") / Sweep::ResultFile(task).parent_path().filename() / "1";
  {
    Sweep sweep(Plan("out"));
    fs::create_directories(left);
    std::ofstream(left / "report.json") << R"({"sessions": {"discovery": {"path_m": 77}}})";
  }
  const auto results = Sweep(Plan("out")).Results({task});
  EXPECT_THAT(results->at(0), HasSubstr("77"));
  EXPECT_EQ(RunsMade(), 0U);
}

TEST_F(SweepTest, SaysOfARunWithoutReportThatItFailed) {
  const auto results = Sweep(Plan("out")).Results({{.settings = {}, .seed = 13}});
  EXPECT_EQ(results->at(0), "{\"failed\": 1}\n");
}

TEST_F(SweepTest, StopsAtARefusedRunAndTriesItAgainNextTime) {
  std::ofstream(At("refuses")) << "x";
  EXPECT_THROW(static_cast<void>(Sweep(Plan("out")).Results(Tasks(3))), Refusal);
  fs::remove(At("refuses"));
  EXPECT_EQ(Sweep(Plan("out")).Results(Tasks(3))->size(), 3U);
}

TEST_F(SweepTest, RefusesAFolderOfAnotherMissionOrInUse) {
  ASSERT_TRUE(Sweep(Plan("out")).Results(Tasks(1)));
  {
    const Sweep held(Plan("out"));
    EXPECT_THROW(Sweep second(Plan("out")), Refusal);
  }
  std::ofstream(At("m/mission.moos")) << "Community = b\n";
  EXPECT_THROW(Sweep other(Plan("out")), Refusal);
}

TEST_F(SweepTest, GivesTheSameBytesByMpi) {
  if (!FindOnPath("mpirun") || !fs::exists(OwnProgram().parent_path() / "limpet_mpi")) {
    GTEST_SKIP() << "no mpirun or no limpet_mpi: ./limpet cluster installs the former";
  }
  ExpectSameBytes("mpi", 12);
}

TEST_F(SweepTest, GivesTheSameBytesBySlurmInside) {
  if (std::getenv("SLURM_CONF") == nullptr) {
    GTEST_SKIP() << "GivesTheSameBytesBySlurm runs this inside of a Slurm of its own";
  }
  ExpectSameBytes("slurm", 40);
}

TEST_F(SweepTest, GivesTheSameBytesBySlurm) {
  const fs::path script = fs::path(LIMPET_SOURCE_DIR) / "tests/support/one_node_slurm.sh";
  const int code =
      WaitForChild(StartChild({.args = {At("slurm").string(), OwnProgram().string(),
                                        "--gtest_filter=SweepTest.GivesTheSameBytesBySlurmInside"},
                               .log = At("slurm.txt"),
                               .program = script.string()},
                              SIGTERM));
  constexpr int kCannot = 77;
  if (code == kCannot) GTEST_SKIP() << TextOfFile(At("slurm.txt"));
  EXPECT_EQ(code, 0) << TextOfFile(At("slurm.txt"));
  EXPECT_THAT(TextOfFile(At("slurm.txt")), HasSubstr("[  PASSED  ] 1 test"));
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/sweeps/batch_runner.hpp"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/durable/durable_file.hpp"
#include "tests/support/limpet_command.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

/// Workers in this very process: each Start does `tasks_per_start` tasks at once.
class FakeLauncher final : public BatchLauncher {
 public:
  struct Log {
    int starts = 0, take_ups = 0, cancels = 0;
    std::size_t tasks_per_start = 1000;
  };
  explicit FakeLauncher(Log& log) : log_(log) {}
  void TakeUp(const fs::path&) override { ++log_.take_ups; }
  void Start(const fs::path& batch_folder, int) override {
    ++log_.starts;
    const BatchFolder folder(batch_folder);
    const TaskBatch batch = *folder.Batch();
    for (std::size_t i = 0; i < std::min(batch.tasks.size(), log_.tasks_per_start); ++i)
      static_cast<void>(folder.RunTask(batch, i));
  }
  [[nodiscard]] bool IsAlive() override { return false; }
  void Cancel() override { ++log_.cancels; }

 private:
  Log& log_;
};

class BatchRunnerTest : public testing::Test {
 protected:
  [[nodiscard]] ChildRun Shell(const std::string& name, const std::string& script) const {
    return {.args = {"-c", script}, .log = folder_.path() / (name + ".txt"), .program = "sh"};
  }
  [[nodiscard]] fs::path At(const std::string& name) const { return folder_.path() / name; }
  bool Run(const std::vector<ChildRun>& tasks, bool goes_on = true) {
    BatchRunner runner({.runner = "fake", .jobs = 2, .batch_folder = At("batch")},
                       std::make_unique<FakeLauncher>(log_));
    return runner.Run(tasks, [&](const ChildEnd& end) {
      EXPECT_TRUE(ends_.emplace(end.index, end.exit_code).second) << "reported twice";
      return goes_on;
    });
  }
  TemporaryFolder folder_;
  FakeLauncher::Log log_;
  std::map<std::size_t, int> ends_;
};

TEST_F(BatchRunnerTest, ReportsTheEndOfEachTaskOnce) {
  EXPECT_TRUE(Run({Shell("a", "echo from a"), Shell("b", "exit 1"), Shell("c", "exit 3")}));
  EXPECT_EQ(ends_, (std::map<std::size_t, int>{{0, 0}, {1, 1}, {2, 3}}));
  EXPECT_EQ(TextOfFile(At("a.txt")), "from a\n");
  EXPECT_FALSE(fs::exists(At("batch")));
  EXPECT_EQ(log_.starts, 1);
}

TEST_F(BatchRunnerTest, HandsOutAgainWhatAWorkerLostUntilItIsDone) {
  log_.tasks_per_start = 1;
  EXPECT_TRUE(Run({Shell("a", "true"), Shell("b", "true"), Shell("c", "true")}));
  EXPECT_EQ(ends_.size(), 3U);
  EXPECT_EQ(log_.starts, 3);
}

TEST_F(BatchRunnerTest, TriesThriceWhatIsKilledAndThenSaysSo) {
  EXPECT_TRUE(Run(
      {Shell("a", "echo x >> " + At("tries").string() + "; kill -KILL $$"), Shell("b", "true")}));
  EXPECT_EQ(ends_, (std::map<std::size_t, int>{{0, 128 + 9}, {1, 0}}));
  EXPECT_EQ(TextOfFile(At("tries")), "x\nx\nx\n");
}

TEST_F(BatchRunnerTest, ReportsWhatNoWorkerEverDoesAsLost) {
  log_.tasks_per_start = 0;
  EXPECT_TRUE(Run({Shell("a", "true")}));
  EXPECT_EQ(ends_.at(0), BatchRunner::kLost);
  EXPECT_EQ(log_.starts, BatchRunner::kMostAttempts);
}

TEST_F(BatchRunnerTest, TakesWhatEndedUnderADriverThatWasKilled) {
  const std::vector<ChildRun> tasks{Shell("a", "echo x >> " + At("runs").string()),
                                    Shell("b", "true")};
  const BatchFolder earlier(At("batch"));
  const TaskBatch batch{.folder = At(""), .tasks = {tasks[0]}};
  earlier.Begin(batch);
  EXPECT_EQ(earlier.RunTask(batch, 0), 0);
  EXPECT_TRUE(Run(tasks));
  EXPECT_EQ(log_.take_ups, 1);
  EXPECT_EQ(TextOfFile(At("runs")), "x\n");
  EXPECT_EQ(ends_.size(), 2U);
}

TEST_F(BatchRunnerTest, StopsWhenTheCallerHasSeenEnough) {
  EXPECT_FALSE(Run({Shell("a", "exit 3"), Shell("b", "true")}, false));
  EXPECT_EQ(ends_.size(), 1U);
  EXPECT_EQ(log_.cancels, 1);
  EXPECT_FALSE(fs::exists(At("batch"))) << "a refused task must be run again next time";
}

TEST_F(BatchRunnerTest, RunsNoTaskThatIsClaimedOrHasEnded) {
  const BatchFolder folder(At("batch"));
  const TaskBatch batch{.folder = At(""), .tasks = {Shell("a", "exit 4")}};
  folder.Begin(batch);
  EXPECT_EQ(folder.RunTask(batch, 0), 4);
  EXPECT_EQ(folder.RunTask(batch, 0), std::nullopt);
  EXPECT_EQ(folder.EndOf(0), 4);
}

TEST_F(BatchRunnerTest, KnowsWhetherAWorkerOfAnotherDriverIsStillThere) {
  EXPECT_FALSE(WorkerMark::IsAnyIn(At("")));
  {
    const WorkerMark one(At("")), other(At(""));
    EXPECT_TRUE(WorkerMark::IsAnyIn(At("")));
  }
  EXPECT_FALSE(WorkerMark::IsAnyIn(At("")));
}

TEST(TaskBatch, ComesBackFromItsTextAndFromNoOther) {
  const TaskBatch batch{.folder = "/work",
                        .tasks = {{.args = {"survey", "a b"}, .log = "x.txt", .program = "p"}}};
  const auto back = TaskBatch::FromText(batch.Text());
  ASSERT_TRUE(back);
  EXPECT_EQ(back->tasks.at(0).args, batch.tasks[0].args);
  EXPECT_EQ(back->Text(), batch.Text());
  for (const char* wrong : {"", "{}", "[]", R"({"format": "limpet-tasks-1", "folder": 1})",
                            R"({"format": "limpet-tasks-1", "folder": "f", "tasks": [{}]})"}) {
    EXPECT_FALSE(TaskBatch::FromText(wrong)) << wrong;
  }
}

}  // namespace
}  // namespace limpet

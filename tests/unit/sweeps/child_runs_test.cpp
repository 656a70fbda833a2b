// SPDX-License-Identifier: MIT
#include "limpet/sweeps/child_runs.hpp"

#include <filesystem>
#include <set>

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

/// Children are this very program: it lists its tests and ends.
class ChildRunsTest : public ::testing::Test {
 protected:
  [[nodiscard]] ChildRun Child(const std::string& log) const {
    return {{"--gtest_list_tests"}, folder_.path() / log};
  }
  TemporaryFolder folder_;
};

TEST_F(ChildRunsTest, EachRunIsReportedOnce) {
  std::vector<std::size_t> ended;
  EXPECT_TRUE(RunChildren({Child("a"), Child("b"), Child("c")}, 2, [&](const ChildEnd& end) {
    EXPECT_EQ(end.exit_code, 0);
    ended.push_back(end.index);
    return true;
  }));
  EXPECT_EQ(std::set<std::size_t>(ended.begin(), ended.end()), (std::set<std::size_t>{0, 1, 2}));
}

TEST_F(ChildRunsTest, OneWhoseLogCannotBeMadeIsNotRunIntoTheCallersOutput) {
  EXPECT_TRUE(RunChildren({Child("no folder/a")}, 1, [](const ChildEnd& end) {
    EXPECT_EQ(end.exit_code, 127);
    return true;
  }));
}

TEST_F(ChildRunsTest, NoneIsStartedOnceTheCallerHasSeenEnough) {
  int ended = 0;
  EXPECT_FALSE(RunChildren({Child("a"), Child("b")}, 1, [&](const ChildEnd&) {
    ++ended;
    return false;
  }));
  EXPECT_EQ(ended, 1);
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "b"));
}

}  // namespace
}  // namespace limpet

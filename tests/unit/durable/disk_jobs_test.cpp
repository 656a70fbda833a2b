// SPDX-License-Identifier: MIT
#include "limpet/durable/disk_jobs.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(DiskJobs, AreDoneAtOnceWithoutAThread) {
  bool is_done = false;
  DiskJobs jobs(false);
  jobs.Put([&is_done] { is_done = true; });
  EXPECT_TRUE(is_done);
  EXPECT_TRUE(jobs.is_idle());
}

TEST(DiskJobs, AreDoneInOrderOnAThread) {
  std::vector<int> done;
  DiskJobs jobs(true);
  for (int i = 0; i < 100; ++i) {
    jobs.Put([&done, i] { done.push_back(i); });
  }
  jobs.Wait();
  EXPECT_TRUE(jobs.is_idle());
  ASSERT_EQ(done.size(), 100U);
  EXPECT_TRUE(std::ranges::is_sorted(done));
}

}  // namespace
}  // namespace limpet

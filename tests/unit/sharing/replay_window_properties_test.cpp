// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>
#include <set>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/sharing/replay_window.hpp"

namespace limpet {
namespace {

TEST(ReplayWindowProperties, TakesEachCounterOnceAndNoneThatIsTooFarBehind) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed, "counters");
    ReplayWindow window;
    std::set<std::uint64_t> taken;
    std::uint64_t top = random.Index(5000);
    for (int i = 0; i < 1000; ++i) {
      const std::uint64_t behind = random.Index(1400);
      const std::uint64_t counter = random.Chance(0.3) ? top + random.Index(5)
                                    : top > behind     ? top - behind
                                                       : 0;
      const std::uint64_t highest = taken.empty() ? counter : *taken.rbegin();
      const bool is_new = !taken.contains(counter) && (counter > highest || taken.empty() ||
                                                       highest - counter < ReplayWindow::kWidth);
      ASSERT_EQ(window.IsNew(counter), is_new) << counter << " at " << highest;
      if (!is_new) continue;
      window.Take(counter);
      taken.insert(counter);
      top = std::max(top, counter);
    }
  }
}

TEST(ReplayWindowProperties, TheHighestCounterThereIsDoesNotWrapIt) {
  constexpr std::uint64_t kTop = std::numeric_limits<std::uint64_t>::max();
  ReplayWindow window;
  window.Take(3);
  EXPECT_TRUE(window.IsNew(kTop));
  window.Take(kTop);
  EXPECT_FALSE(window.IsNew(kTop));
  EXPECT_FALSE(window.IsNew(0));
  EXPECT_TRUE(window.IsNew(kTop - ReplayWindow::kWidth + 1));
  EXPECT_FALSE(window.IsNew(kTop - ReplayWindow::kWidth));
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
// What is left when the power is cut amid anything: two hundred cuts of every kind of file.
// `ninja -C build power_cuts && build/bin/power_cuts` makes ten thousand of each.
#include "tests/support/power_cuts.hpp"

#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

using ::testing::IsEmpty;

constexpr int kLives = 8, kCutsOfEach = 25;

void ExpectSound(const std::function<PowerCuts(std::uint64_t seed, int cuts)>& cut) {
  int lossy = 0;
  for (std::uint64_t seed = 1; seed <= kLives; ++seed) {
    const PowerCuts result = cut(seed, kCutsOfEach);
    EXPECT_EQ(result.cuts, kCutsOfEach);
    EXPECT_THAT(result.complaints, IsEmpty()) << "seed " << seed;
    lossy += result.lossy;
  }
  EXPECT_GT(lossy, kLives) << "a disk that never loses anything proves nothing";
}

TEST(PowerCut, LeavesALogThatOpensAndLacksNoMoreThanASecond) { ExpectSound(CutLog); }
TEST(PowerCut, LeavesAPackedLogOrThePlainOne) { ExpectSound(CutPackedLog); }
TEST(PowerCut, LeavesTheLastGenerationOfASession) { ExpectSound(CutSession); }
TEST(PowerCut, LeavesAJournalWithoutGapsThatLacksNoMoreThanASecond) { ExpectSound(CutJournal); }
TEST(PowerCut, LeavesTheOldFileOrTheNewOne) { ExpectSound(CutWholeFile); }

}  // namespace
}  // namespace limpet

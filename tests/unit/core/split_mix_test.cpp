// SPDX-License-Identifier: MIT
#include "limpet/core/split_mix.hpp"

#include <bit>

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(SplitMixed, DrawsWhatTheGeneratorsAuthorPublished) {
  // The first draws of java.util.SplittableRandom(0) and of splitmix64.c for state 1234567.
  EXPECT_EQ(SplitMixed(kGoldenStep), 0xe220a8397b1dcdafULL);
  EXPECT_EQ(SplitMixed(2 * kGoldenStep), 0x6e789e6aa1b965f4ULL);
  EXPECT_EQ(SplitMixed(3 * kGoldenStep), 0x06c45d188009454fULL);
  EXPECT_EQ(SplitMixed(1234567 + kGoldenStep), 6457827717110365317ULL);
  EXPECT_EQ(SplitMixed(1234567 + 2 * kGoldenStep), 3203168211198807973ULL);
}

TEST(SplitMixed, ChangesHalfOfTheBitsWithEachOfTheState) {
  int changed = 0;
  constexpr int kStates = 1000, kBits = 64;
  for (std::uint64_t state = 1; state <= kStates; ++state) {
    for (int bit = 0; bit < kBits; ++bit) {
      const std::uint64_t other = state ^ (std::uint64_t{1} << static_cast<unsigned>(bit));
      changed += std::popcount(SplitMixed(state) ^ SplitMixed(other));
    }
  }
  EXPECT_NEAR(changed, kStates * kBits * kBits / 2, 0.01 * kStates * kBits * kBits / 2);
}

}  // namespace
}  // namespace limpet

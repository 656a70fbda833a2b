// SPDX-License-Identifier: MIT
#include "limpet/launch/process_time.hpp"

#include <ctime>

#include <gtest/gtest.h>
#include <unistd.h>

namespace limpet {
namespace {

TEST(ProcessTime, GrowsByWhatAProcessComputes) {
  const Seconds before = ProcessorTime(::getpid()).value();
  const std::clock_t start = std::clock();
  while (std::clock() - start < CLOCKS_PER_SEC / 2) {
  }
  EXPECT_NEAR((ProcessorTime(::getpid()).value() - before).value(), 0.5, 0.1);
}

TEST(ProcessTime, IsNotKnownOfAProcessThatDoesNotExist) { EXPECT_FALSE(ProcessorTime(0x7ffffffe)); }

TEST(ProcessTime, IsReadBehindANameWithBlanksAndBrackets) {
  EXPECT_EQ(internal::ProcessorTicksIn("7 (a) S (b)) R 1 2 3 4 5 6 7 8 9 10 200 30 0 0"), 230.0);
  EXPECT_FALSE(internal::ProcessorTicksIn("7 (a) R 1 2 3 4 5 6 7 8 9 10 200"));
  EXPECT_FALSE(internal::ProcessorTicksIn(""));
}

}  // namespace
}  // namespace limpet

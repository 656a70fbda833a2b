// SPDX-License-Identifier: MIT
#include "limpet/launch/process_memory.hpp"

#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

namespace limpet {
namespace {

TEST(ProcessMemory, GrowsWithWhatAProcessUses) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "what the sanitizer keeps of each byte counts, too";
#endif
  const double before = ResidentMib(::getpid()).value();
  EXPECT_GT(before, 1.0);
  const std::vector<char> used(std::size_t{64} << 20U, 'x');
  EXPECT_NEAR(ResidentMib(::getpid()).value() - before, 64.0, 8.0) << used.back();
}

TEST(ProcessMemory, IsNotKnownOfAProcessThatDoesNotExist) { EXPECT_FALSE(ResidentMib(0x7ffffffe)); }

}  // namespace
}  // namespace limpet

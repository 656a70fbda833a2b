// SPDX-License-Identifier: MIT
#include "limpet/core/command_line_error.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(CommandLineError, SaysThatTheWordStandsOnTheCommandLine) {
  EXPECT_STREQ(CommandLineError("--seed", "is no number").what(),
               "command line: --seed: is no number");
}

}  // namespace
}  // namespace limpet

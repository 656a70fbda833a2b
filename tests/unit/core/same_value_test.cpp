// SPDX-License-Identifier: MIT
#include "limpet/core/same_value.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(SameValue, IsANumberHoweverItIsWritten) {
  EXPECT_TRUE(IsSameValue("0.5", "5e-1"));
  EXPECT_TRUE(IsSameValue("0", "0.0"));
  EXPECT_TRUE(IsSameValue("0.3", "0.30000000000000004"));
  EXPECT_FALSE(IsSameValue("0.3", "0.301"));
}

TEST(SameValue, IsTheSameTextIfEitherIsNoNumber) {
  EXPECT_TRUE(IsSameValue("salt", "salt"));
  EXPECT_FALSE(IsSameValue("salt", "Salt"));
  EXPECT_FALSE(IsSameValue("1", "1 m"));
}

}  // namespace
}  // namespace limpet

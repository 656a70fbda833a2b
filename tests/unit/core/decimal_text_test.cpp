// SPDX-License-Identifier: MIT
#include "limpet/core/decimal_text.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(DecimalText, CutsTrailingZeros) {
  EXPECT_EQ(DecimalText(3.10, 2), "3.1");
  EXPECT_EQ(DecimalText(100.0, 2), "100");
  EXPECT_EQ(DecimalText(-0.125, 2), "-0.12");
  EXPECT_EQ(DecimalText(43.825119934, 8), "43.82511993");
  EXPECT_EQ(DecimalText(10.0, 0), "10");
}

TEST(DecimalText, HasNoMinusZero) { EXPECT_EQ(DecimalText(-0.004, 2), "0"); }

TEST(DecimalText, WritesNothingThatIsNoNumber) {
  EXPECT_EQ(DecimalText(std::numeric_limits<double>::quiet_NaN(), 2), "0");
  EXPECT_EQ(DecimalText(std::numeric_limits<double>::infinity(), 2), "0");
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/core/letter_case.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(LetterCaseTest, NamesOfVariablesAreUpperCaseAndKeysLowerCase) {
  EXPECT_EQ(UpperCase("pHelm_status 2"), "PHELM_STATUS 2");
  EXPECT_EQ(LowerCase("ZAIC_Spd"), "zaic_spd");
  EXPECT_EQ(UpperCase(""), "");
}

TEST(LetterCaseTest, LettersBeyondAsciiStayWhole) {
  EXPECT_EQ(UpperCase("la Sp\u00e9zia"), "LA SP\u00e9ZIA");
}

}  // namespace
}  // namespace limpet

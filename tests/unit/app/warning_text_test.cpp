// SPDX-License-Identifier: MIT
#include "limpet/app/warning_text.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

using Warnings = std::map<std::string, std::string>;

TEST(WarningText, ComesApartAsItWasPutTogether) {
  const Warnings warnings{{"DVL_STALE", "no bottom lock: 3 s"}, {"NAV_LOST", "nothing heard"}};
  EXPECT_EQ(EncodeWarnings(warnings), "DVL_STALE: no bottom lock: 3 s; NAV_LOST: nothing heard");
  EXPECT_EQ(DecodeWarnings(EncodeWarnings(warnings)), warnings);
}

TEST(WarningText, ATextWithASemicolonStaysOneWarning) {
  const Warnings decoded =
      DecodeWarnings(EncodeWarnings({{"COVERAGE_STALLED", "not grown; GOING: home"}}));
  EXPECT_EQ(decoded, (Warnings{{"COVERAGE_STALLED", "not grown, GOING: home"}}));
}

TEST(WarningText, SaysNoneForNone) {
  EXPECT_EQ(EncodeWarnings({}), "none");
  EXPECT_TRUE(DecodeWarnings("none").empty());
  EXPECT_TRUE(DecodeWarnings("").empty());
}

TEST(WarningText, TakesWhatIsNoListForAnId) {
  EXPECT_EQ(DecodeWarnings("nonsense"), (Warnings{{"nonsense", ""}}));
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/topics/bid.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(Bid, SaysItsReasonsInALine) {
  EXPECT_EQ(WhyText({.value = 7.0, .why = {{"useful", 11.0}, {"length", 4.004}}}),
            "useful=11.00 length=4.00");
  EXPECT_EQ(WhyText({.value = 7.0}), "");
}

TEST(Bid, SaysOfAVetoWhatItIs) {
  EXPECT_EQ(WhyText({.why = {{"useful", 11.0}}, .veto = "too long"}), "too long");
}

TEST(Bid, HasItsReasonsBackFromTheLine) {
  const std::vector<Reason> reasons = ReasonsIn("useful=11.00 odd =3 length=4.50 rate=fast");
  ASSERT_EQ(reasons.size(), 3U);
  EXPECT_EQ(reasons[0].name, "useful");
  EXPECT_EQ(reasons[0].value, 11.0);
  EXPECT_EQ(reasons[1].name, "") << "as it is written";
  EXPECT_EQ(reasons[2].name, "length");
  EXPECT_EQ(reasons[2].value, 4.5);
  EXPECT_TRUE(ReasonsIn("").empty());
}

TEST(WeightedBid, IsWorthItsValueTimesTheWeight) {
  EXPECT_EQ((WeightedBid{.behavior = "cover", .weight = 0.5, .bid = {.value = 8.0}}).Worth(), 4.0);
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/decision/deciding_bid.hpp"

#include <gtest/gtest.h>

#include "limpet/decision/merit.hpp"

namespace limpet {
namespace {

WeightedBid Cover(double value) {
  return {"cover", 1.0, {.value = value, .why = {{"useful", 9.0}, {"length", 11.0}}}};
}
WeightedBid Look(double value) {
  return {"revisit", 1.0, {.value = value, .why = {{"looks_worth", 3.0}}}};
}
WeightedBid Late(double value) {
  return {"in_time", 1.0, {.value = value, .why = {{"overrun", 0.0}}}};
}
WeightedBid Region() { return {"region", 1.0, {}}; }

/// Options of 10 m in the order in which the helm lists them.
HelmBids Bids(const std::vector<std::vector<WeightedBid>>& options) {
  HelmBids bids;
  for (const auto& list : options) {
    BiddenOption option;
    option.length = 10.0;
    option.bids = list;
    option.total = TotalOf(list);
    option.rate = option.total / option.length;
    bids.options.push_back(option);
  }
  return bids;
}

std::string WhoDecides(const std::vector<std::vector<WeightedBid>>& options) {
  const auto deciding = DecidingBidOf(Bids(options));
  return deciding ? deciding->behavior : "nobody";
}

TEST(DecidingBid, IsTheLookWhereLooksAreMostOfThePathsWorth) {
  EXPECT_EQ(WhoDecides({{Cover(2.0), Look(6.0), Region()}, {Cover(5.0), Look(0.0), Region()}}),
            "revisit");
  EXPECT_EQ(DecidingBidOf(Bids({{Cover(-5.0), Look(20.0)}}))->purpose, BidPurpose::kLook);
}

TEST(DecidingBid, IsCoverWhereAnObjectOnlyLiesOnTheWay) {
  EXPECT_EQ(WhoDecides({{Cover(7.0), Look(1.0)}, {Cover(5.0), Look(1.0)}}), "cover");
}

TEST(DecidingBid, IsTheLookAlsoWhereEveryListedOptionLeadsToTheObject) {
  EXPECT_EQ(WhoDecides({{Cover(-5.0), Look(20.0)}, {Cover(-5.2), Look(20.0)}}), "revisit");
}

TEST(DecidingBid, IsTheCostThatRulesOutWhatWouldElseHaveWon) {
  EXPECT_EQ(WhoDecides({{Cover(2.0), Late(0.0)}, {Cover(8.0), Late(-500.0)}}), "in_time");
}

TEST(DecidingBid, IsNotTheOneThatOnlyForbids) {
  const WeightedBid home{"home", 1.0, {.value = -30.0, .why = {{"to_go", 30.0}}}};
  EXPECT_EQ(WhoDecides({{home, Region()}}), "home");
}

TEST(DecidingBid, MindsTheWeights) {
  WeightedBid heavy = Look(2.0);
  heavy.weight = 5.0;
  EXPECT_EQ(WhoDecides({{Cover(6.0), heavy}}), "revisit");
}

TEST(DecidingBid, IsNobodysWithoutBids) {
  EXPECT_EQ(WhoDecides({}), "nobody");
  EXPECT_EQ(WhoDecides({{Region()}}), "nobody");
}

}  // namespace
}  // namespace limpet

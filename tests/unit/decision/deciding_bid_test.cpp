// SPDX-License-Identifier: MIT
#include "limpet/decision/deciding_bid.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

OptionBid Cover(double value) { return {"cover", value, 1.0, false, "useful=9.00 length=11.00"}; }
OptionBid Look(double value) { return {"revisit", value, 1.0, false, "looks_worth=3.00"}; }
OptionBid Late(double value) { return {"in_time", value, 1.0, false, "overrun=0.00"}; }
OptionBid Region() { return {"region", 0.0, 1.0, false, ""}; }

/// Options of 10 m in the order in which the helm lists them.
HelmBids Bids(const std::vector<std::vector<OptionBid>>& options) {
  HelmBids bids;
  for (const auto& list : options) {
    BiddenOption option;
    option.length = 10.0;
    option.bids = list;
    for (const OptionBid& bid : list)
      option.total += bid.weight * bid.value;
    option.rate = option.total / option.length;
    bids.options.push_back(option);
  }
  return bids;
}

std::string WhoDecides(const std::vector<std::vector<OptionBid>>& options) {
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
  EXPECT_EQ(WhoDecides({{{"home", -30.0, 1.0, false, "to_go=30.00"}, Region()}}), "home");
}

TEST(DecidingBid, MindsTheWeights) {
  OptionBid heavy = Look(2.0);
  heavy.weight = 5.0;
  EXPECT_EQ(WhoDecides({{Cover(6.0), heavy}}), "revisit");
}

TEST(DecidingBid, IsNobodysWithoutBids) {
  EXPECT_EQ(WhoDecides({}), "nobody");
  EXPECT_EQ(WhoDecides({{Region()}}), "nobody");
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/decision/merit.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

BiddenOption Option(double length, std::vector<WeightedBid> bids) {
  BiddenOption option;
  option.length = length;
  option.bids = std::move(bids);
  option.total = TotalOf(option.bids);
  option.rate = RateOf(option.total, option);
  return option;
}

WeightedBid GroundBid(double value) { return {"cover", 2.0, {.value = value}}; }
WeightedBid Forbids() { return {"region", 1.0, {.veto = "leaves the operating region"}}; }

TEST(Merit, IsTheWeightedSumPerMetreOrTheSumAlone) {
  HelmBids bids;
  bids.options = {Option(10.0, {GroundBid(6.0)}), Option(2.0, {GroundBid(3.0)})};
  EXPECT_EQ(ChoiceOf(bids), 1U) << "6 for 2 m beat 12 for 10 m";
  bids.order = OptionOrder::kBySum;
  EXPECT_EQ(ChoiceOf(bids), 0U);
}

TEST(Merit, NeverGoesToWhatSomebodyForbids) {
  HelmBids bids;
  bids.options = {Option(5.0, {GroundBid(50.0), Forbids()}), Option(5.0, {GroundBid(-3.0)})};
  EXPECT_EQ(ChoiceOf(bids), 1U);
  EXPECT_EQ(VetoOn(bids.options[0])->behavior, "region");
  bids.options.pop_back();
  EXPECT_EQ(ChoiceOf(bids), std::nullopt);
}

TEST(Merit, OfEqualsGoesToTheFirst) {
  HelmBids bids;
  bids.options = {Option(5.0, {GroundBid(1.0)}), Option(5.0, {GroundBid(1.0)})};
  EXPECT_EQ(ChoiceOf(bids), 0U);
}

TEST(Merit, OfAnOptionIsTheSumOfItsBidsShares) {
  const BiddenOption option = Option(4.0, {GroundBid(6.0), {"home", 0.5, {.value = -3.0}}});
  double sum = 0.0;
  for (const WeightedBid& bid : option.bids) {
    sum += ShareOf(bid, option, OptionOrder::kPerMetre);
  }
  EXPECT_NEAR(sum, option.rate, 1e-12);
  EXPECT_EQ(ShareOf(option.bids[0], option, OptionOrder::kBySum), 12.0);
}

}  // namespace
}  // namespace limpet

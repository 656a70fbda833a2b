// SPDX-License-Identifier: MIT
#include "limpet/decision/flip.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/decision/merit.hpp"

namespace limpet {
namespace {

struct Offer {
  double length = 10.0;
  std::vector<WeightedBid> bids;
};

HelmBids Table(const std::vector<Offer>& offers, OptionOrder order = OptionOrder::kPerMetre) {
  HelmBids bids;
  bids.order = order;
  for (const Offer& offer : offers) {
    BiddenOption option;
    option.length = offer.length;
    option.bids = offer.bids;
    bids.options.push_back(option);
  }
  return Reweighted(bids, "", 0.0);
}

WeightedBid Says(const char* behavior, double value, double weight = 1.0) {
  return {behavior, weight, {.value = value}};
}
WeightedBid Outside() { return {"region", 1.0, {.veto = "outside"}}; }

TEST(Flip, IsTheWeightAtWhichTheRunnerUpOvertakes) {
  const HelmBids bids = Table({{10.0, {Says("cover", 8.0), Says("look", 0.0)}},
                               {10.0, {Says("cover", 5.0), Says("look", 2.0)}}});
  const auto more_look = FlipOf(bids, "look");
  ASSERT_TRUE(more_look);
  EXPECT_NEAR(more_look->new_weight, 1.5, 1e-6);
  EXPECT_GT(more_look->new_weight, 1.5) << "at 1.5 they are level";
  EXPECT_EQ(more_look->to, 1U);
  const auto less_cover = FlipOf(bids, "cover");
  ASSERT_TRUE(less_cover);
  EXPECT_NEAR(less_cover->new_weight, 2.0 / 3.0, 1e-6);
}

TEST(Flip, IsTheNearestOfMany) {
  const HelmBids bids = Table({{10.0, {Says("cover", 8.0), Says("look", 1.0)}},
                               {10.0, {Says("cover", 0.0), Says("look", 9.0)}},
                               {10.0, {Says("cover", 7.0), Says("look", 0.0)}},
                               {10.0, {Says("cover", 6.0), Says("look", 2.9)}}});
  const auto flip = FlipOf(bids, "look");
  ASSERT_TRUE(flip);
  EXPECT_EQ(flip->to, 1U) << "level with it at weight 1, with the last at 1.05";
}

TEST(Flip, IsNotThereWhereNoWeightHelps) {
  const HelmBids bids =
      Table({{10.0, {Says("cover", 8.0), Says("region", 0.0)}}, {10.0, {Says("cover", 5.0)}}});
  EXPECT_EQ(FlipOf(bids, "region"), std::nullopt) << "it says nothing in metres";
  EXPECT_EQ(FlipOf(bids, "nobody"), std::nullopt);
  EXPECT_EQ(FlipOf(bids, "cover"), std::nullopt)
      << "at weight 0 they are level, and the first wins";
}

TEST(Flip, NeverLeadsToWhatSomebodyForbids) {
  HelmBids bids =
      Table({{10.0, {Says("cover", 8.0)}}, {10.0, {Says("cover", 5.0), Says("look", 3.0)}}});
  bids.options[1].bids.push_back(Outside());
  EXPECT_EQ(FlipOf(bids, "look"), std::nullopt);
}

TEST(Flip, IsNotThereWhereTheBidsDifferByRounding) {
  const HelmBids bids = Table({{10.0, {Says("cover", 8.0), Says("home", 0.3)}},
                               {10.0, {Says("cover", 5.0), Says("home", 0.1 + 0.2)}}});
  ASSERT_NE(0.1 + 0.2, 0.3);
  EXPECT_EQ(FlipOf(bids, "home"), std::nullopt) << "a weight of 6e16 is no advice";
}

/// Of a survey: without `cover` only the way home counts, and the rest of a plan ends where the
/// whole plan does, to rounding.
TEST(Flip, IsNotThereWhereRoundingWouldDecideAtWeightZero) {
  const double home = 0.3, same_home = 0.1 + 0.2;
  ASSERT_GT(same_home, home);
  const HelmBids less = Table({{10.0, {Says("cover", 8.0), Says("home", home)}},
                               {10.0, {Says("cover", 5.0), Says("home", same_home)}}});
  EXPECT_EQ(ChoiceOf(Reweighted(less, "cover", 0.0)), 1U) << "by rounding";
  EXPECT_EQ(FlipOf(less, "cover"), std::nullopt);
}

TEST(Flip, LeadsToWeightZeroWhereAnotherIsClearlyAheadThere) {
  const HelmBids bids = Table({{10.0, {Says("cover", 8.0), Says("home", 0.0)}},
                               {10.0, {Says("cover", 5.0), Says("home", 1e-7)}}});
  const auto flip = FlipOf(bids, "cover");
  ASSERT_TRUE(flip);
  EXPECT_EQ(flip->to, 1U);
  EXPECT_LT(flip->new_weight, 1e-7 / 3.0);
  EXPECT_EQ(ChoiceOf(Reweighted(bids, "cover", flip->new_weight)), 1U);
}

TEST(Flip, LeadsPastAnOptionThatIsWorthTheSame) {
  const HelmBids bids = Table({{246.2, {Says("cover", 100.3), Says("look", 0.3)}},
                               {246.2, {Says("cover", 100.3), Says("look", 0.1 + 0.2)}},
                               {246.2, {Says("cover", 90.0), Says("look", 5.0)}}});
  const std::optional<std::size_t> chosen = ChoiceOf(bids);
  ASSERT_LT(*chosen, 2U);
  for (const char* behavior : {"cover", "look"}) {
    const auto flip = FlipOf(bids, behavior);
    ASSERT_TRUE(flip) << behavior;
    EXPECT_EQ(flip->to, 2U) << behavior;
    EXPECT_EQ(ChoiceOf(Reweighted(bids, behavior, flip->new_weight)), 2U) << behavior;
  }
  const auto look = FlipOf(bids, "look");
  EXPECT_NEAR(look->new_weight, 10.3 / 4.7, 1e-6);
}

/// Against a scan over weights: no smaller change flips, and the one found does.
TEST(Flip, AgreesWithTryingEveryWeight) {
  Random random(11, "flip");
  int flips = 0;
  for (int run = 0; run < 300; ++run) {
    std::vector<Offer> offers(2 + random.Index(6));
    for (Offer& offer : offers) {
      offer.length = random.Uniform(0.5, 30.0);
      for (const char* name : {"cover", "look", "home"}) {
        if (!random.Chance(0.2)) {
          offer.bids.push_back(Says(name, random.Uniform(-10.0, 10.0), 1.3));
        }
      }
      if (random.Chance(0.1)) {
        offer.bids.push_back(Outside());
      }
    }
    const HelmBids bids =
        Table(offers, random.Chance(0.5) ? OptionOrder::kPerMetre : OptionOrder::kBySum);
    const auto chosen = ChoiceOf(bids);
    for (const std::string& behavior : BiddersOf(bids)) {
      const auto flip = FlipOf(bids, behavior);
      const double reach = flip ? std::abs(flip->new_weight - flip->weight) * 0.999 : 20.0;
      for (int i = 0; i <= 100; ++i) {
        const double weight = 1.3 + reach * (2.0 * i / 100.0 - 1.0);
        if (weight >= 0.0) {
          EXPECT_EQ(ChoiceOf(Reweighted(bids, behavior, weight)), chosen) << behavior << weight;
        }
      }
      if (flip) {
        ++flips;
        EXPECT_EQ(ChoiceOf(Reweighted(bids, behavior, flip->new_weight)), flip->to);
        EXPECT_NE(flip->to, *chosen);
      }
    }
  }
  EXPECT_GT(flips, 300);
}

}  // namespace
}  // namespace limpet

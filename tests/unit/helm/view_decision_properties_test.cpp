// SPDX-License-Identifier: MIT
// Where next, over random options and bids, against a plain sum of bids times weights.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/decision/merit.hpp"
#include "limpet/helm/view_decision.hpp"

namespace limpet {
namespace {

/// Bids what it was told for each option, by source.
class ToldBehavior final : public Behavior {
 public:
  [[nodiscard]] std::optional<Bid> Value(const Prospect& prospect,
                                         const Situation&) const override {
    const auto told = bids.find(prospect.option->source);
    return told == bids.end() ? std::nullopt : std::optional(told->second);
  }
  std::map<std::string, Bid> bids;
};

class ViewDecisionProperties : public ::testing::Test {
 protected:
  ViewDecisionProperties() {
    now_.ground = &ground_;
    now_.region = &region_;
  }
  void Draw(Random& random, double veto_chance) {
    options_.clear();
    for (ToldBehavior& behavior : behaviors_)
      behavior.bids.clear();
    const std::size_t count = 1 + random.Index(9);
    for (std::size_t i = 0; i < count; ++i) {
      const std::string source = "option" + std::to_string(i);
      options_.push_back(
          {.source = source,
           .path = DubinsPath({}, {{random.Uniform(-0.2, 0.2), random.Uniform(0.2, 12.0)}})});
      for (ToldBehavior& behavior : behaviors_) {
        if (random.Chance(0.2)) continue;  // no opinion
        Bid bid{.value = random.Uniform(-20.0, 20.0), .why = {{"drawn", 1.0}}, .veto = {}};
        if (random.Chance(veto_chance)) bid.veto = "drawn so";
        behavior.bids[source] = bid;
      }
    }
    for (double& weight : weights_)
      weight = random.Uniform(0.1, 3.0);
  }
  [[nodiscard]] ViewDecision Decide(OptionOrder order = OptionOrder::kPerMetre,
                                    double scale = 1.0) {
    std::vector<WeightedBehavior> running;
    for (std::size_t i = 0; i < behaviors_.size(); ++i) {
      running.push_back({"b" + std::to_string(i), scale * weights_[i], &behaviors_[i]});
    }
    return DecideView(running, now_, options_, sight_, order);
  }
  [[nodiscard]] bool IsVetoed(const Option& option) const {
    return std::ranges::any_of(behaviors_, [&option](const ToldBehavior& behavior) {
      const auto bid = behavior.bids.find(option.source);
      return bid != behavior.bids.end() && bid->second.veto;
    });
  }
  [[nodiscard]] double SumOf(const Option& option) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < behaviors_.size(); ++i) {
      const auto bid = behaviors_[i].bids.find(option.source);
      if (bid != behaviors_[i].bids.end()) sum += weights_[i] * bid->second.value;
    }
    return sum;
  }
  [[nodiscard]] double MeritOf(const Option& option, OptionOrder order) const {
    const double sum = SumOf(option);
    return order == OptionOrder::kBySum ? sum : sum / std::max(option.path.length(), 1.0);
  }

  SurveyArea area_{.north_min = -10, .north_max = 10, .east_min = -10, .east_max = 10};
  SurveyGrid grid_{area_};
  Ground ground_{grid_, Footprint({.altitude = 4.0, .object_height_max = 2.0}, CameraModel{})};
  Region region_{area_};
  SeenAlong sight_{ground_};
  Situation now_;
  std::array<ToldBehavior, 3> behaviors_;
  std::array<double, 3> weights_{};
  std::vector<Option> options_;
};

TEST_F(ViewDecisionProperties, TakesTheGreatestSumOfWhatNobodyForbids) {
  Random random(1, "view");
  for (int run = 0; run < 400; ++run) {
    Draw(random, 0.15);
    for (const OptionOrder order : {OptionOrder::kPerMetre, OptionOrder::kBySum}) {
      double best = -std::numeric_limits<double>::infinity();
      std::optional<std::string> expected;
      for (const Option& option : options_) {
        if (!IsVetoed(option) && MeritOf(option, order) > best) {
          best = MeritOf(option, order);
          expected = option.source;
        }
      }
      const ViewDecision decision = Decide(order);
      ASSERT_EQ(decision.chosen.has_value(), expected.has_value());
      if (expected) {
        EXPECT_EQ(decision.chosen->source, *expected);
      }
    }
  }
}

TEST_F(ViewDecisionProperties, NoBidBuysAVetoOff) {
  Random random(2, "view");
  for (int run = 0; run < 200; ++run) {
    Draw(random, 0.0);
    const std::string forbidden = options_[random.Index(options_.size())].source;
    behaviors_[0].bids[forbidden] = {.value = 1e12, .why = {}, .veto = {}};
    behaviors_[2].bids[forbidden] = {.value = 1e12, .why = {}, .veto = "no"};
    const ViewDecision decision = Decide();
    EXPECT_EQ(decision.chosen.has_value(), options_.size() > 1);
    EXPECT_TRUE(!decision.chosen || decision.chosen->source != forbidden);
  }
}

TEST_F(ViewDecisionProperties, WeightsCountInProportionOnly) {
  Random random(3, "view");
  for (int run = 0; run < 200; ++run) {
    Draw(random, 0.1);
    const ViewDecision plain = Decide(), heavy = Decide(OptionOrder::kPerMetre, 7.0);
    ASSERT_EQ(plain.chosen.has_value(), heavy.chosen.has_value());
    if (plain.chosen) {
      EXPECT_EQ(plain.chosen->source, heavy.chosen->source);
    }
    EXPECT_NEAR(heavy.bids.options[0].total, 7.0 * plain.bids.options[0].total, 1e-9);
  }
}

TEST_F(ViewDecisionProperties, OfEqualsTheFirstOfferedIsTaken) {
  Random random(4, "view");
  for (int run = 0; run < 50; ++run) {
    Draw(random, 0.0);
    for (ToldBehavior& behavior : behaviors_)
      behavior.bids.clear();
    for (Option& option : options_)
      option.path = DubinsPath({}, {{0.0, 5.0}});
    EXPECT_EQ(Decide().chosen->source, "option0");
    std::ranges::reverse(options_);
    EXPECT_EQ(Decide().chosen->source, options_[0].source);
  }
}

TEST_F(ViewDecisionProperties, AWorthlessOptionMoreChangesNothing) {
  Random random(5, "view");
  for (int run = 0; run < 200; ++run) {
    Draw(random, 0.1);
    const ViewDecision before = Decide();
    options_.push_back({.source = "worthless", .path = DubinsPath({}, {{0.0, 4.0}})});
    behaviors_[0].bids["worthless"] = {.value = -1e6, .why = {}, .veto = {}};
    const ViewDecision after = Decide();
    if (before.chosen) {
      EXPECT_EQ(after.chosen->source, before.chosen->source);
    }
    EXPECT_EQ(after.bids.considered, before.bids.considered + 1);
  }
}

TEST_F(ViewDecisionProperties, TheListIsEveryOptionBestFirstWithEveryBid) {
  Random random(6, "view");
  for (int run = 0; run < 200; ++run) {
    Draw(random, 0.2);
    const ViewDecision decision = Decide();
    EXPECT_EQ(decision.bids.considered, static_cast<int>(options_.size()));
    ASSERT_EQ(decision.bids.options.size(), options_.size());
    bool has_come_to_vetoes = false;
    double last = std::numeric_limits<double>::infinity();
    for (const BiddenOption& listed : decision.bids.options) {
      const bool is_vetoed = VetoOn(listed) != nullptr;
      EXPECT_FALSE(has_come_to_vetoes && !is_vetoed) << "what is forbidden comes last";
      if (is_vetoed && !has_come_to_vetoes) last = std::numeric_limits<double>::infinity();
      has_come_to_vetoes = is_vetoed;
      EXPECT_LE(listed.rate, last);
      last = listed.rate;
      double total = 0.0;
      for (const WeightedBid& weighted : listed.bids)
        total += weighted.weight * weighted.bid.value;
      EXPECT_NEAR(listed.total, total, 1e-9);
    }
  }
}

TEST_F(ViewDecisionProperties, AnOptionOfNoLengthIsNotInfinitelyGood) {
  options_ = {{.source = "nowhere", .path = DubinsPath({}, {})},
              {.source = "far", .path = DubinsPath({}, {{0.0, 10.0}})}};
  weights_ = {1.0, 1.0, 1.0};
  behaviors_[0].bids["nowhere"] = {.value = 0.5, .why = {}, .veto = {}};
  behaviors_[0].bids["far"] = {.value = 20.0, .why = {}, .veto = {}};
  const ViewDecision decision = Decide();
  EXPECT_EQ(decision.chosen->source, "far") << "2 a metre, against 0.5 for the first metre";
}

TEST_F(ViewDecisionProperties, WithoutOptionsNothingIsChosen) {
  const ViewDecision decision = Decide();
  EXPECT_FALSE(decision.chosen);
  EXPECT_EQ(decision.bids.considered, 0);
  EXPECT_TRUE(decision.bids.options.empty());
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/helm/view_decision.hpp"

#include <functional>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

namespace limpet {
namespace {

using Judge = std::function<std::optional<Bid>(const Prospect&)>;

class JudgingBehavior final : public Behavior {
 public:
  explicit JudgingBehavior(Judge judge) : judge_(std::move(judge)) {}
  [[nodiscard]] std::optional<Bid> Value(const Prospect& prospect,
                                         const Situation&) const override {
    return judge_(prospect);
  }

 private:
  Judge judge_;
};

class ViewDecisionTest : public ::testing::Test {
 protected:
  static Option Straight(const std::string& source, double length) {
    return {.source = source, .path = DubinsPath({}, {{.curvature = 0.0, .length = length}})};
  }
  ViewDecision Decide(std::vector<WeightedBehavior> behaviors, AnswerWatch* watch = nullptr) {
    Situation now;
    now.ground = &ground_;
    now.region = &region_;
    return DecideView(behaviors, now, {Straight("short", 3.0), Straight("long", 9.0)}, sight_,
                      OptionOrder::kPerMetre, watch);
  }

  SurveyArea area_{.north_min = -10, .north_max = 10, .east_min = -10, .east_max = 10};
  SurveyGrid grid_{area_};
  Ground ground_{grid_, Footprint({.altitude = 4.0, .object_height_max = 2.0}, CameraModel{})};
  Region region_{area_};
  SeenAlong sight_{ground_};
};

TEST_F(ViewDecisionTest, AddsWeightedBidsAndTakesTheBest) {
  JudgingBehavior likes_long([](const Prospect& p) {
    return Bid{.value = p.length() * p.length(), .why = {}, .veto = {}};
  });
  JudgingBehavior likes_short([](const Prospect& p) {
    return Bid{.value = -p.length() * p.length(), .why = {}, .veto = {}};
  });
  EXPECT_EQ(Decide({{"a", 1.0, &likes_long}, {"b", 0.5, &likes_short}}).chosen->source, "long");
  EXPECT_EQ(Decide({{"a", 1.0, &likes_long}, {"b", 2.0, &likes_short}}).chosen->source, "short");
}

TEST_F(ViewDecisionTest, DropsVetoedOptionsHoweverGood) {
  JudgingBehavior likes_long([](const Prospect& p) {
    return Bid{.value = p.length() * p.length(), .why = {}, .veto = {}};
  });
  JudgingBehavior forbids_long([](const Prospect& p) {
    Bid bid;
    if (p.length() > 5.0) {
      bid.veto = "too long";
    }
    return bid;
  });
  const ViewDecision decision = Decide({{"a", 1.0, &likes_long}, {"b", 1.0, &forbids_long}});
  EXPECT_EQ(decision.chosen->source, "short");
  EXPECT_EQ(decision.bids.options.back().bids.back().bid.veto, "too long");
}

TEST_F(ViewDecisionTest, ChoosesNothingWhenAllIsVetoed) {
  JudgingBehavior forbids(
      [](const Prospect&) { return Bid{.value = 0.0, .why = {}, .veto = "no"}; });
  EXPECT_FALSE(Decide({{"a", 1.0, &forbids}}).chosen.has_value());
}

TEST_F(ViewDecisionTest, HearsTheOthersWhenOneTakesTooLong) {
  Seconds time(0.0);
  AnswerWatch watch([&time] { return time; });
  int asked = 0;
  JudgingBehavior sleeper([&](const Prospect& p) {
    ++asked, time += Seconds(1.0);
    return Bid{.value = 100.0 * p.length() * p.length(), .why = {}, .veto = {}};
  });
  JudgingBehavior likes_short([](const Prospect& p) {
    return Bid{.value = -p.length() * p.length(), .why = {}, .veto = {}};
  });
  const std::vector<WeightedBehavior> both{{"sleeper", 1.0, &sleeper},
                                           {"other", 1.0, &likes_short}};
  EXPECT_EQ(Decide(both).chosen->source, "long") << "without a clock, as embedded, nobody is late";
  asked = 0;
  const ViewDecision decision = Decide(both, &watch);
  EXPECT_EQ(decision.chosen->source, "short");
  EXPECT_EQ(asked, 1) << "not asked about the other option";
  ASSERT_EQ(decision.late.size(), 1U);
  EXPECT_EQ(decision.late[0].owner, "sleeper");
  EXPECT_EQ(decision.late[0].warning.id.name(), "BHV_LATE_sleeper");
  static_cast<void>(Decide(both, &watch));
  asked = 0;
  EXPECT_EQ(Decide(both, &watch).chosen->source, "short");
  EXPECT_EQ(asked, 0) << "after two in a row it rests";
}

TEST_F(ViewDecisionTest, HearsTheOthersWhenOneThrowsOrBidsNoNumber) {
  JudgingBehavior likes_long([](const Prospect& p) {
    return Bid{.value = p.length() * p.length(), .why = {}, .veto = {}};
  });
  JudgingBehavior throws([](const Prospect& p) -> std::optional<Bid> {
    if (p.length() > 5.0) {
      throw std::runtime_error("no chart");
    }
    return Bid{.value = 1e9, .why = {}, .veto = {}};
  });
  JudgingBehavior bids_nan([](const Prospect&) {
    return Bid{.value = std::numeric_limits<double>::quiet_NaN(), .why = {}, .veto = {}};
  });
  const ViewDecision decision =
      Decide({{"a", 1.0, &likes_long}, {"broken", 1.0, &throws}, {"nan", 1.0, &bids_nan}});
  EXPECT_EQ(decision.chosen->source, "long");
  ASSERT_EQ(decision.failures.size(), 2U);
  EXPECT_EQ(decision.failures[0].owner, "broken");
  EXPECT_EQ(decision.failures[0].text, "it has thrown: no chart");
  EXPECT_EQ(decision.failures[1].owner, "nan");
  for (const BiddenOption& option : decision.bids.options) {
    ASSERT_EQ(option.bids.size(), 1U) << "what it bid before it threw does not count either";
  }
}

TEST_F(ViewDecisionTest, ExplainsEachBidWithItsReasons) {
  JudgingBehavior behavior([](const Prospect& p) {
    return Bid{.value = 1.0, .why = {{"length", p.length()}}, .veto = {}};
  });
  const BiddenOption first = Decide({{"a", 1.0, &behavior}}).bids.options.front();
  EXPECT_EQ(WhyText(first.bids.front().bid), "length=3.00");
}

}  // namespace
}  // namespace limpet

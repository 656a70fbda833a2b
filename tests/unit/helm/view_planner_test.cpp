// SPDX-License-Identifier: MIT
#include "limpet/helm/view_planner.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

/// Wants its own straight way on, so long, and nothing else.
class StraightOn final : public Behavior {
 public:
  explicit StraightOn(double length) : length_(length) {}
  [[nodiscard]] bool WantsView() const override { return true; }
  void Offer(const Situation& now, std::vector<Option>& options) const override {
    options.push_back({.source = "straight_on",
                       .path = DubinsPath(now.pose, {{.curvature = 0.0, .length = length_}}),
                       .own_m = length_});
  }
  [[nodiscard]] std::optional<Bid> Value(const Prospect& prospect,
                                         const Situation&) const override {
    Bid bid{.value = 1.0, .why = {}, .veto = {}};
    if (prospect.option->source != "straight_on") bid.veto = "another's";
    return bid;
  }

 private:
  double length_;
};

/// How far it was flown along a path of that length before the helm decided anew [m].
double FlownOf(double length) {
  ViewParams params;
  params.generators = "home";
  ViewPlanner planner(params, Random(1, "test"));
  planner.SetArea({.north_min = -20, .north_max = 20, .east_min = -20, .east_max = 20});
  StraightOn behavior(length);
  const std::vector<WeightedBehavior> running{{.name = "straight_on", .behavior = &behavior}};
  NavState nav;
  nav.down = 3.5;
  nav.altitude = 4.0;
  const auto first = planner.DecideIfDue(running, nav, Seconds(0.0));
  EXPECT_TRUE(first && first->chosen);
  constexpr double kStep = 0.05;  // [m]
  for (double flown = kStep; flown < 2.0 * length; flown += kStep) {
    nav.north = flown;
    static_cast<void>(planner.Guide(nav));
    if (planner.DecideIfDue(running, nav, Seconds(flown))) return flown;
  }
  return 2.0 * length;
}

TEST(ViewPlanner, DecidesAnewAMomentBeforeAPathEnds) {
  EXPECT_NEAR(FlownOf(4.0), 4.0 - ViewParams{}.arrival.value(), 0.06);
}

TEST(ViewPlanner, APathShorterThanThatMomentIsFlownToItsEndInsteadOfDecidedInEachTick) {
  EXPECT_NEAR(FlownOf(0.4), 0.4, 0.06);
}

}  // namespace
}  // namespace limpet

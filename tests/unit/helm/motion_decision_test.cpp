// SPDX-License-Identifier: MIT
// How now: which behaviors count, how much, and what the mission's domain allows.
#include "limpet/helm/motion_decision.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/core/frames.hpp"
#include "limpet/core/random.hpp"

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::SizeIs;

class MovingBehavior final : public Behavior {
 public:
  MovingBehavior() = default;
  explicit MovingBehavior(MotionBid bid) : bid_(std::move(bid)) {}
  [[nodiscard]] MotionBid Move(const VehicleState&) override {
    ++asked;
    return bid_;
  }
  int asked = 0;

 private:
  MotionBid bid_;
};

MotionBid Course(double course, double turn_rate = 0.0) {
  MotionBid bid;
  bid.course = Peak{.summit = course, .flat_half_width = 0.0, .base_half_width = 3.1};
  bid.turn_rate = turn_rate;
  return bid;
}
MotionBid Speed(double speed) {
  MotionBid bid;
  bid.speed = Peak{.summit = speed, .flat_half_width = 0.0, .base_half_width = 1.0};
  return bid;
}
MotionBid Depth(double depth) {
  MotionBid bid;
  bid.depth = Peak{.summit = depth, .flat_half_width = 0.0, .base_half_width = 5.0};
  return bid;
}

TEST(MotionDecision, NamesWhatNobodyBidOn) {
  MovingBehavior course(Course(1.0)), depth(Depth(3.0));
  const std::vector<WeightedBehavior> running{{"course", 100.0, &course}, {"depth", 1.0, &depth}};
  EXPECT_EQ(DecideMotion(running, {}, {}).Missing({}), "speed");
  EXPECT_EQ(DecideMotion({}, {}, {}).Missing({}), "course,speed,depth");
  EXPECT_THAT(DecideMotion(running, {}, {}).active, ElementsAre("course", "depth"));
}

TEST(MotionDecision, LetsABehaviorWithoutWeightActAndHaveNoSay) {
  MovingBehavior silent(Course(1.0)), loud(Course(-1.0));
  const std::vector<WeightedBehavior> running{{"silent", 0.0, &silent}, {"loud", 1.0, &loud}};
  const MotionDecision decision = DecideMotion(running, {}, {});
  EXPECT_EQ(silent.asked, 1) << "it may post, and complete";
  EXPECT_THAT(decision.turns, SizeIs(2));
  EXPECT_NEAR(*decision.course, -1.0, 1e-12);
  EXPECT_THAT(decision.active, ElementsAre("loud"));
}

TEST(MotionDecision, TurnsAsTheHeaviestBidderOnCourseSays) {
  MovingBehavior light(Course(1.0, 0.1)), heavy(Course(1.2, 0.2)), deep(Depth(3.0));
  const std::vector<WeightedBehavior> running{
      {"light", 1.0, &light}, {"heavy", 5.0, &heavy}, {"deep", 50.0, &deep}};
  EXPECT_EQ(*DecideMotion(running, {}, {}).turn_rate, 0.2);
  const std::vector<WeightedBehavior> turned(running.rbegin(), running.rend());
  EXPECT_EQ(*DecideMotion(turned, {}, {}).turn_rate, 0.2) << "whatever their order";
}

TEST(MotionDecision, KeepsSpeedAndDepthInsideTheMissionsDomain) {
  Random random(1, "domain");
  for (int run = 0; run < 300; ++run) {
    MotionDomain domain;
    domain.speed = MotionAxis{.low = 0.2, .high = 1.5, .points = 14};
    domain.depth = MotionAxis{.low = 1.0, .high = 20.0, .points = 20};
    const double speed = random.Uniform(-2.0, 4.0), depth = random.Uniform(-10.0, 40.0);
    MovingBehavior fast(Speed(speed)), deep(Depth(depth));
    const std::vector<WeightedBehavior> running{{"fast", 1.0, &fast}, {"deep", 1.0, &deep}};
    const MotionDecision decision = DecideMotion(running, {}, domain);
    EXPECT_EQ(*decision.speed, std::clamp(speed, 0.2, 1.5));
    EXPECT_EQ(*decision.depth, std::clamp(depth, 1.0, 20.0));
  }
}

TEST(MotionDecision, IsAtAPointOfTheDomainIfAsked) {
  MotionDomain domain;
  domain.speed = MotionAxis{.low = 0.0, .high = 4.0, .points = 21};
  MotionArbiter arbiter(domain, {}, true);
  for (const auto& [speed, point] :
       {std::pair{1.3, 1.2}, {1.29, 1.2}, {1.31, 1.4}, {0.05, 0.0}, {9.0, 4.0}}) {
    MovingBehavior fast(Speed(speed));
    EXPECT_NEAR(*arbiter.Decide({{{"fast", 1.0, &fast}}}, {}).speed, point, 1e-12) << speed;
  }
  for (const auto& [course, point] : {std::pair{10.4, 10.0}, {-0.4, 0.0}, {-1.2, 359.0}}) {
    MovingBehavior turning(Course(RadiansFromDegrees(course)));
    const double decided = *arbiter.Decide({{{"turning", 1.0, &turning}}}, {}).course;
    EXPECT_NEAR(WrapAngle(decided - RadiansFromDegrees(point)), 0.0, 1e-12) << course;
  }
}

TEST(MotionDecision, DependsOnWeightsInProportionAndOnNoOrder) {
  Random random(2, "weights");
  for (int run = 0; run < 200; ++run) {
    std::vector<MovingBehavior> behaviors;
    for (int i = 0; i < 4; ++i)
      behaviors.emplace_back(Course(random.Uniform(-3.1, 3.1)));
    std::vector<WeightedBehavior> running, scaled;
    for (MovingBehavior& behavior : behaviors) {
      const double weight = random.Uniform(0.5, 5.0);
      running.push_back({"b", weight, &behavior});
      scaled.push_back({"b", 10.0 * weight, &behavior});
    }
    const double course = *DecideMotion(running, {}, {}).course;
    std::ranges::reverse(running);
    EXPECT_EQ(*DecideMotion(running, {}, {}).course, course);
    EXPECT_NEAR(WrapAngle(*DecideMotion(scaled, {}, {}).course - course), 0.0, 1e-12);
  }
}

TEST(CourseArbitration, TurnsWithTheWorld) {
  Random random(3, "turn");
  for (int run = 0; run < 200; ++run) {
    std::vector<WeightedPeak> peaks, turned;
    const double turn = random.Uniform(-3.0, 3.0);
    for (int i = 0; i < 3; ++i) {
      const WeightedPeak peak{{.summit = random.Uniform(-3.1, 3.1),
                               .flat_half_width = random.Uniform(0.0, 0.3),
                               .base_half_width = random.Uniform(0.4, 3.1)},
                              random.Uniform(0.5, 2.0)};
      peaks.push_back(peak);
      turned.push_back(peak);
      turned.back().peak.summit = WrapAngle(peak.peak.summit + turn);
    }
    const auto value = [](const std::vector<WeightedPeak>& all, double x) {
      double sum = 0.0;
      for (const WeightedPeak& p : all) {
        sum += p.weight * PeakValue(p.peak, WrapAngle(x - p.peak.summit));
      }
      return sum;
    };
    const double best = MaximizeOverCircle(peaks);
    EXPECT_GT(best, -std::numbers::pi);
    EXPECT_LE(best, std::numbers::pi);
    EXPECT_NEAR(value(turned, MaximizeOverCircle(turned)), value(peaks, best), 1e-9);
    for (double x = -3.14; x < 3.15; x += 0.02)
      EXPECT_LE(value(peaks, x), value(peaks, best) + 1e-9);
  }
}

}  // namespace
}  // namespace limpet

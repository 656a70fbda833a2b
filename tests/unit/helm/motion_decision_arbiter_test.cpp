// SPDX-License-Identifier: MIT
// Behaviors that join variables, that fail, and that bid on what the vehicle does not have.
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/core/frames.hpp"
#include "limpet/core/units.hpp"
#include "limpet/helm/motion_decision.hpp"
#include "tests/support/allocation_count.hpp"

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using enum MotionVariable;

MotionDomain FieldDomain() {
  return {.course = MotionAxis{.low = 0.0, .high = RadiansFromDegrees(359.0), .points = 360},
          .speed = MotionAxis{.low = 0.0, .high = 4.0, .points = 41},
          .depth = MotionAxis{.low = 0.0, .high = 49.0, .points = 50}};
}

/// Leads north at 2 m/s, 10 m deep.
class Transit final : public Behavior {
 public:
  [[nodiscard]] MotionBid Move(const VehicleState&) override {
    MotionBid bid;
    bid.course = Peak{.summit = 0.0, .flat_half_width = 0.0, .base_half_width = std::numbers::pi};
    bid.speed = Peak{.summit = 2.0, .flat_half_width = 0.0, .base_half_width = 2.0};
    bid.depth = Peak{.summit = 10.3, .flat_half_width = 0.0, .base_half_width = 5.0};
    bid.turn_rate = 0.05;
    return bid;
  }
};

/// Keeps off what is ahead, unless slow.
class Avoid final : public Behavior {
 public:
  void Start(const VehicleState& state) override {
    table_.emplace(state.domain, std::initializer_list<MotionVariable>{kCourse, kSpeed});
  }
  [[nodiscard]] MotionBid Move(const VehicleState&) override {
    table_->Fill([this](const MotionPoint& point) {
      return std::abs(point.course) < half_width_ && point.speed > 0.45 ? 0.0 : 1.0;
    });
    MotionBid bid;
    bid.table = &*table_;
    return bid;
  }
  double half_width_ = RadiansFromDegrees(20.5);

 private:
  std::optional<MotionTable> table_;
};

class Failing final : public Behavior {
 public:
  enum class Way { kThrows, kThrowsNumber, kNan, kInfinite, kNoBase };
  explicit Failing(Way way) : way_(way) {}
  [[nodiscard]] MotionBid Move(const VehicleState&) override {
    if (way_ == Way::kThrows) throw std::runtime_error("no bathymetry");
    if (way_ == Way::kThrowsNumber) throw 4;  // NOLINT(hicpp-exception-baseclass): what others do
    MotionBid bid;
    bid.speed = Peak{.summit = way_ == Way::kNan        ? std::nan("")
                               : way_ == Way::kInfinite ? std::numeric_limits<double>::infinity()
                                                        : 1.0,
                     .flat_half_width = 0.0,
                     .base_half_width = way_ == Way::kNoBase ? 0.0 : 1.0};
    return bid;
  }

 private:
  Way way_;
};

struct Fleet {
  MotionDomain domain = FieldDomain();
  Transit transit;
  Avoid avoid;
  VehicleState state;

  Fleet() {
    state.domain = domain;
    avoid.Start(state);
  }
};

TEST(MotionArbiter, GoesRoundWhatATableForbidsAndKeepsTheDepthThatNoTableJoins) {
  Fleet fleet;
  MotionArbiter arbiter(fleet.domain);
  const std::vector<WeightedBehavior> running{{"transit", 100.0, &fleet.transit},
                                              {"avoid", 200.0, &fleet.avoid}};
  const MotionDecision& decision = arbiter.Decide(running, fleet.state);
  EXPECT_NEAR(MoosHeadingFromYaw(*decision.course), 21.0, 1e-9);
  EXPECT_DOUBLE_EQ(*decision.speed, 2.0);
  EXPECT_EQ(*decision.depth, 10.3) << "between the points: nobody joins depth to anything";
  EXPECT_FALSE(decision.turn_rate) << "it is of a course that was not taken";
  EXPECT_THAT(decision.active, ElementsAre("transit", "avoid"));
  fleet.avoid.half_width_ = 0.0;
  EXPECT_EQ(*arbiter.Decide(running, fleet.state).turn_rate, 0.05);
}

TEST(MotionArbiter, SlowsDownWhereThatIsTheLesserEvil) {
  Fleet fleet;
  fleet.avoid.half_width_ = RadiansFromDegrees(179.9);
  MotionArbiter arbiter(fleet.domain);
  const std::vector<WeightedBehavior> running{{"transit", 100.0, &fleet.transit},
                                              {"avoid", 200.0, &fleet.avoid}};
  const MotionDecision& decision = arbiter.Decide(running, fleet.state);
  EXPECT_NEAR(*decision.course, 0.0, 1e-9);
  EXPECT_DOUBLE_EQ(*decision.speed, 0.4);
}

TEST(MotionArbiter, AllocatesNothingWhileTheSameBehaviorsRun) {
  Fleet fleet;
  MotionArbiter arbiter(fleet.domain);
  const std::vector<WeightedBehavior> running{
      {"a_name_that_fits_no_small_string", 100.0, &fleet.transit}, {"avoid", 200.0, &fleet.avoid}};
  static_cast<void>(arbiter.Decide(running, fleet.state));
  const long before = AllocationCount();
  for (int i = 0; i < 10; ++i) {
    static_cast<void>(arbiter.Decide(running, fleet.state));
  }
  EXPECT_EQ(AllocationCount() - before, 0);
}

class FailingBid : public ::testing::TestWithParam<std::pair<Failing::Way, const char*>> {};

TEST_P(FailingBid, IsLostAndReportedAndTheOthersGoOn) {
  Fleet fleet;
  Failing failing(GetParam().first);
  const std::vector<WeightedBehavior> running{{"failing", 1000.0, &failing},
                                              {"transit", 100.0, &fleet.transit}};
  const MotionDecision decision = DecideMotion(running, fleet.state, fleet.domain);
  EXPECT_EQ(*decision.speed, 2.0);
  EXPECT_EQ(decision.Missing(fleet.domain), "");
  EXPECT_THAT(decision.active, ElementsAre("transit"));
  ASSERT_EQ(decision.failures.size(), 1U);
  EXPECT_EQ(decision.failures[0].owner, "failing");
  EXPECT_THAT(decision.failures[0].text, HasSubstr(GetParam().second));
  ASSERT_EQ(decision.warnings.size(), 1U);
  EXPECT_EQ(decision.warnings[0].warning.id.name(), "BHV_FAILED_failing");
}

INSTANTIATE_TEST_SUITE_P(
    InEveryWay, FailingBid,
    ::testing::Values(std::pair{Failing::Way::kThrows, "it has thrown: no bathymetry"},
                      std::pair{Failing::Way::kThrowsNumber, "no exception of C++"},
                      std::pair{Failing::Way::kNan, "NaN or infinity in its bid on speed"},
                      std::pair{Failing::Way::kInfinite, "NaN or infinity in its bid on speed"},
                      std::pair{Failing::Way::kNoBase, "a base of 0 under a flat top of 0"}));

/// Answers after a second; then in no time.
class Sluggish final : public Behavior {
 public:
  explicit Sluggish(Seconds& time) : time_(time) {}
  [[nodiscard]] MotionBid Move(const VehicleState&) override {
    time_ += takes;
    MotionBid bid;
    bid.speed = Peak{.summit = 1.0, .flat_half_width = 0.0, .base_half_width = 0.5};
    bid.acts.emplace_back(BehaviorPost{.variable = "SLUGGISH", .value = 1.0});
    return bid;
  }
  Seconds takes{1.0};

 private:
  Seconds& time_;
};

TEST(MotionArbiter, DoesNotHearABidThatComesLateAndNamesItsBehavior) {
  Fleet fleet;
  Seconds time(0.0);
  Sluggish sluggish(time);
  MotionArbiter arbiter(fleet.domain, [&time] { return time; });
  const std::vector<WeightedBehavior> running{{"sluggish", 1000.0, &sluggish},
                                              {"transit", 100.0, &fleet.transit}};
  const MotionDecision& decision = arbiter.Decide(running, fleet.state);
  EXPECT_EQ(*decision.speed, 2.0);
  EXPECT_THAT(decision.active, ElementsAre("transit"));
  EXPECT_THAT(decision.failures, IsEmpty());
  ASSERT_EQ(decision.warnings.size(), 1U);
  EXPECT_EQ(decision.warnings[0].warning.id.name(), "BHV_LATE_sluggish");
  ASSERT_EQ(decision.turns.size(), 2U);
  EXPECT_EQ(decision.turns[0].acts.size(), 1U) << "what it did is done";
  sluggish.takes = Seconds(0.4);
  static_cast<void>(arbiter.Decide(running, fleet.state));
  EXPECT_EQ(*decision.speed, 1.0);
  EXPECT_THAT(decision.warnings, IsEmpty());
}

TEST(MotionArbiter, DoesNotAskOneForLongThatIsLateTwiceInARow) {
  Fleet fleet;
  Seconds time(0.0);
  Sluggish sluggish(time);
  MotionArbiter arbiter(fleet.domain, [&time] { return time; });
  const std::vector<WeightedBehavior> running{{"sluggish", 1000.0, &sluggish},
                                              {"transit", 100.0, &fleet.transit}};
  for (int i = 0; i < 500; ++i) {
    const MotionDecision& decision = arbiter.Decide(running, fleet.state);
    EXPECT_EQ(*decision.speed, 2.0);
    EXPECT_EQ(decision.warnings.size(), 1U) << "while it rests, too";
    time += Seconds(0.1);
  }
  EXPECT_NEAR(time.value(), 50.0 + 2.0, 1e-6) << "held up twice in 50 s";
}

TEST(MotionArbiter, WaitsForEveryAnswerWithoutAClock) {
  Fleet fleet;
  Seconds time(0.0);
  Sluggish sluggish(time);
  MotionArbiter arbiter(fleet.domain);
  const std::vector<WeightedBehavior> running{{"sluggish", 1000.0, &sluggish},
                                              {"transit", 100.0, &fleet.transit}};
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(*arbiter.Decide(running, fleet.state).speed, 1.0);
  }
}

TEST(MotionArbiter, DoesNotHearATableWithNumbersThatAreNone) {
  Fleet fleet;
  class BadTable final : public Behavior {
   public:
    explicit BadTable(const MotionDomain& domain) : table_(domain, {kSpeed}) {
      table_.Fill([](const MotionPoint& point) { return point.speed / 0.0; });
    }
    [[nodiscard]] MotionBid Move(const VehicleState&) override {
      MotionBid bid;
      bid.table = &table_;
      return bid;
    }
    MotionTable table_;
  };
  BadTable bad(fleet.domain);
  MotionDomain other = fleet.domain;
  other.speed->points = 11;
  BadTable foreign(other);
  foreign.table_.Fill([](const MotionPoint&) { return 1.0; });
  const std::vector<WeightedBehavior> running{
      {"bad", 1000.0, &bad}, {"foreign", 1000.0, &foreign}, {"transit", 1.0, &fleet.transit}};
  const MotionDecision decision = DecideMotion(running, fleet.state, fleet.domain);
  EXPECT_EQ(*decision.speed, 2.0);
  ASSERT_EQ(decision.failures.size(), 2U);
  EXPECT_THAT(decision.failures[0].text, HasSubstr("NaN in its function"));
  EXPECT_THAT(decision.failures[1].text, HasSubstr("made for another domain"));
}

TEST(MotionArbiter, LeavesToOthersWhatTheDomainLacks) {
  Fleet fleet;
  MotionDomain surface = fleet.domain;
  surface.depth.reset();
  const std::vector<WeightedBehavior> running{{"transit", 100.0, &fleet.transit}};
  const MotionDecision decision = DecideMotion(running, fleet.state, surface);
  EXPECT_FALSE(decision.depth.has_value());
  EXPECT_EQ(decision.Missing(surface), "");
}

TEST(MotionArbiter, MissesNoVariableThatIsOptional) {
  MotionDomain domain = FieldDomain();
  domain.depth->is_optional = true;
  EXPECT_EQ(DecideMotion({}, {}, domain).Missing(domain), "course,speed");
}

TEST(MotionArbiter, CallsNobodyActiveWhoBidsOnlyOnWhatTheDomainLacks) {
  class Diver final : public Behavior {
   public:
    [[nodiscard]] MotionBid Move(const VehicleState&) override {
      MotionBid bid;
      bid.depth = Peak{.summit = 5.0, .flat_half_width = 0.0, .base_half_width = 5.0};
      return bid;
    }
  };
  Diver diver;
  MotionDomain surface = FieldDomain();
  surface.depth.reset();
  const std::vector<WeightedBehavior> running{{"diver", 100.0, &diver}};
  EXPECT_THAT(DecideMotion(running, {}, surface).active, IsEmpty());
}

}  // namespace
}  // namespace limpet

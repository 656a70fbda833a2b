// SPDX-License-Identifier: MIT
#include "limpet/helm/motion_record.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace limpet {
namespace {

class OpinionatedBehavior final : public Behavior {
 public:
  explicit OpinionatedBehavior(MotionBid bid) : bid_(std::move(bid)) {}
  [[nodiscard]] MotionBid Move(const VehicleState&) override { return bid_; }

 private:
  MotionBid bid_;
};

MotionBid PeaksAt(double course, double speed, double depth) {
  MotionBid bid;
  bid.course = Peak{.summit = course, .flat_half_width = 0.0, .base_half_width = 1.0};
  bid.speed = Peak{.summit = speed, .flat_half_width = 0.1, .base_half_width = 1.0};
  bid.depth = Peak{.summit = depth, .flat_half_width = 0.0, .base_half_width = 5.0};
  return bid;
}

TEST(MotionRecord, SaysWhatThePresentCourseCountsBesides) {
  MotionBid bid = PeaksAt(0.0, 0.5, 3.0);
  bid.present_course = Peak{.summit = std::numbers::pi / 2.0,
                            .flat_half_width = 0.5,
                            .base_half_width = 4.0,
                            .share = 0.2};
  OpinionatedBehavior way(bid);
  MotionArbiter arbiter(MotionDomain{});
  const std::vector<WeightedBehavior> running{{"way", 100.0, &way}};
  const HelmMotion motion = RecordOf(arbiter, arbiter.Decide(running, {}));
  ASSERT_EQ(motion.opinions.size(), 4U);
  EXPECT_EQ(motion.opinions[3].variables, "course");
  EXPECT_NEAR(motion.opinions[3].weight, 20.0, 1e-9);
  EXPECT_NEAR(motion.opinions[3].summit.value_or(-1.0), 90.0, 1e-9);
}

TEST(MotionRecord, SaysWhatEachWantsAndWhatItGets) {
  OpinionatedBehavior heavy(PeaksAt(-std::numbers::pi / 2.0, 0.5, 3.0));
  MotionBid shallow;
  shallow.depth = Peak{.summit = 1.0, .flat_half_width = 0.0, .base_half_width = 5.0};
  OpinionatedBehavior light(shallow);
  MotionArbiter arbiter(MotionDomain{});
  const std::vector<WeightedBehavior> running{{"follow", 100.0, &heavy}, {"shallow", 1.0, &light}};
  const HelmMotion motion = RecordOf(arbiter, arbiter.Decide(running, {}));
  EXPECT_NEAR(motion.course_deg.value_or(-1.0), 270.0, 1e-9);
  EXPECT_NEAR(motion.depth_m.value_or(-1.0), 3.0, 1e-9);
  ASSERT_EQ(motion.opinions.size(), 4U);
  EXPECT_EQ(motion.opinions[0].variables, "course");
  EXPECT_NEAR(motion.opinions[0].summit.value_or(-1.0), 270.0, 1e-9);
  EXPECT_NEAR(motion.opinions[0].base_half_width.value_or(-1.0), 57.3, 0.01);
  EXPECT_EQ(motion.opinions[0].value, 1.0);
  EXPECT_EQ(motion.opinions[3].behavior, "shallow");
  EXPECT_NEAR(motion.opinions[3].value, 0.6, 1e-9) << "2 m off, of 5";
}

TEST(MotionRecord, GivesATablesValueAtWhatWasChosen) {
  const MotionDomain domain;
  MotionTable table(domain, {MotionVariable::kCourse, MotionVariable::kSpeed});
  table.Fill([](const MotionPoint& point) {
    return std::abs(point.course - 0.5) < 0.01 && std::abs(point.speed - 0.4) < 0.01 ? 0.75 : 0.0;
  });
  MotionBid bid = PeaksAt(0.5, 0.4, 2.0);
  bid.course.reset();
  bid.speed.reset();
  bid.table = &table;
  OpinionatedBehavior behavior(bid);
  MotionArbiter arbiter(domain);
  const std::vector<WeightedBehavior> running{{"avoid", 1.0, &behavior}};
  const HelmMotion motion = RecordOf(arbiter, arbiter.Decide(running, {}));
  ASSERT_EQ(motion.opinions.size(), 2U);
  EXPECT_EQ(motion.opinions[1].variables, "course+speed");
  EXPECT_NEAR(motion.opinions[1].value, 0.75, 1e-6);
  EXPECT_EQ(motion.opinions[1].summit, std::nullopt);
}

TEST(MotionRecord, IsDueOnceASecondAndWhenOthersHaveASay) {
  MotionRecordRate rate;
  MotionDecision decision;
  decision.active = {"a"};
  EXPECT_TRUE(rate.IsDue(decision, Seconds(10.0)));
  EXPECT_FALSE(rate.IsDue(decision, Seconds(10.5)));
  EXPECT_TRUE(rate.IsDue(decision, Seconds(11.0)));
  decision.active = {"a", "b"};
  EXPECT_TRUE(rate.IsDue(decision, Seconds(11.1)));
}

TEST(MotionRecord, SaysAtPointsWhatEachGetsAtThePointThatWasChosen) {
  MotionBid narrow, heavy;
  narrow.speed = Peak{.summit = 0.26, .flat_half_width = 0.0, .base_half_width = 0.003};
  heavy.speed = Peak{.summit = 0.9, .flat_half_width = 0.0, .base_half_width = 1.0, .share = 0.5};
  OpinionatedBehavior one(narrow), other(heavy);
  MotionArbiter arbiter(MotionDomain{}, {}, true);
  const std::vector<WeightedBehavior> running{{"one", 100.0, &one}, {"other", 100.0, &other}};
  const MotionDecision& decision = arbiter.Decide(running, {});
  EXPECT_NEAR(decision.speed.value_or(-1.0), 0.25, 1e-9);
  const HelmMotion motion = RecordOf(arbiter, decision);
  EXPECT_EQ(motion.opinions.at(0).value, 1.0);
  EXPECT_NEAR(motion.opinions.at(0).summit.value_or(-1.0), 0.25, 1e-9);
  EXPECT_NEAR(motion.opinions.at(1).value, 0.35, 1e-9);
  EXPECT_EQ(motion.opinions.at(1).weight, 50.0) << "the share that speed has";
}

}  // namespace
}  // namespace limpet

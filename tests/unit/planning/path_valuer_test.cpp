// SPDX-License-Identifier: MIT
// Searches value paths step by step; the sum is what the whole path is worth.
#include "limpet/planning/path_valuer.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/planning/objective.hpp"
#include "tests/unit/planning/search_scene.hpp"

namespace limpet {
namespace {

/// Counts how often the path crosses north of a line, once per metre of the line.
class LineTerm final : public SearchTerm {
 public:
  explicit LineTerm(double north) : north_(north) {}
  [[nodiscard]] std::size_t event_count() const override { return 1; }
  [[nodiscard]] double Worth(const PathStep& step, TermEvents& events) const override {
    double worth = 0.0;
    step.Sample([&](const Pose2& pose, double) {
      if (pose.north < north_ || events.Has(0)) return;
      events.Add(0);
      worth = 10.0;
    });
    return worth;
  }

 private:
  double north_;
};

class PathValuerProperties : public ::testing::TestWithParam<int> {
 protected:
  PathValuerProperties() {
    objective_.target_decay_m = 60.0;
    for (int i = 0; i < 6; ++i) {
      objective_.targets.push_back({.north = random_.Uniform(-12.0, 12.0),
                                    .east = random_.Uniform(-15.0, 15.0),
                                    .window = {1.5, 2.0},
                                    .value = random_.Uniform(1.0, 20.0)});
    }
    objective_.terms.push_back(std::make_shared<LineTerm>(random_.Uniform(-5.0, 10.0)));
    const double radius = 3.0;
    for (int i = 0; i < 12; ++i) {
      const double turn = static_cast<double>(random_.Index(3)) - 1.0;
      path_.Append({.curvature = turn / radius, .length = random_.Uniform(0.5, 5.0)});
    }
  }
  /// The path's own segments, one by one, from a valuer.
  [[nodiscard]] double SumOfSteps(PathValuer& valuer, const DubinsPath& path) const {
    double sum = 0.0, before = 0.0;
    Pose2 from = path.start();
    for (const PathSegment& segment : path.segments()) {
      sum += valuer.Worth({.from = from, .motion = segment, .before = before});
      from = Advance(from, segment);
      before += segment.length;
    }
    return sum;
  }
  Random random_{static_cast<std::uint64_t>(GetParam()), "valuer"};
  /// Flown once for all.
  [[nodiscard]] static const Ground& SeenGround() {
    static const scene::HalfSeen seen;
    return seen.ground;
  }
  Objective objective_;
  DubinsPath path_{Pose2{0.0, 0.0, random_.Uniform(-3.0, 3.0)}, {}};
};

TEST_P(PathValuerProperties, TargetsAlongThePathAreWorthWhatTheObjectiveSays) {
  Objective targets = objective_;
  targets.terms.clear();
  PathValuer valuer(targets, SeenGround(), path_.start(), 1e3);
  EXPECT_NEAR(SumOfSteps(valuer, path_), TargetValueOf(path_, targets),
              0.05 * (1.0 + TargetValueOf(path_, targets)));
}

TEST_P(PathValuerProperties, TheSameWayAgainShowsNothingNew) {
  PathValuer valuer(objective_, SeenGround(), path_.start(), 1e3);
  const double first = SumOfSteps(valuer, path_);
  EXPECT_EQ(SumOfSteps(valuer, path_), 0.0);
  EXPECT_GE(first, 0.0);
}

TEST_P(PathValuerProperties, GoingBackTakesEveryEventBack) {
  PathValuer valuer(objective_, SeenGround(), path_.start(), 1e3);
  const std::size_t start = valuer.Mark();
  const double first = SumOfSteps(valuer, path_);
  valuer.Rewind(start);
  EXPECT_EQ(SumOfSteps(valuer, path_), first);
}

TEST_P(PathValuerProperties, EventsOfOnePathMayBeReplayedInAnother) {
  PathValuer valuer(objective_, SeenGround(), path_.start(), 1e3);
  static_cast<void>(SumOfSteps(valuer, path_));
  const auto since = valuer.EventsSince(0);
  const std::vector<std::uint32_t> events(since.begin(), since.end());
  PathValuer other(objective_, SeenGround(), path_.start(), 1e3);
  other.Replay(events);
  EXPECT_EQ(SumOfSteps(other, path_), 0.0);
}

TEST_P(PathValuerProperties, TargetsBeyondReachAreLeftOut) {
  Objective far = objective_;
  far.terms.clear();
  for (Target& target : far.targets)
    target.north += 500.0;
  PathValuer valuer(far, SeenGround(), path_.start(), 100.0);
  EXPECT_EQ(SumOfSteps(valuer, path_), 0.0);
  EXPECT_TRUE(valuer.EventsSince(0).empty());
}

TEST_P(PathValuerProperties, ATermIsWorthTheSameHoweverThePathIsCut) {
  const LineTerm term(2.0);
  EXPECT_EQ(WorthAlong(path_, term), WorthAlong(path_, term));
  DubinsPath halves(path_.start());
  for (const PathSegment& segment : path_.segments()) {
    halves.Append({.curvature = segment.curvature, .length = 0.5 * segment.length});
    halves.Append({.curvature = segment.curvature, .length = 0.5 * segment.length});
  }
  EXPECT_EQ(WorthAlong(halves, term), WorthAlong(path_, term));
}

INSTANTIATE_TEST_SUITE_P(Drawn, PathValuerProperties, ::testing::Range(1, 9));

TEST(PathEvents, UndoInTheOrderTheyCame) {
  PathEvents events(4);
  events.Add(2);
  const std::size_t mark = events.Mark();
  events.Add(0), events.Add(3);
  EXPECT_TRUE(events.Has(0) && events.Has(2) && events.Has(3));
  events.Rewind(mark);
  EXPECT_TRUE(events.Has(2));
  EXPECT_FALSE(events.Has(0) || events.Has(3));
  EXPECT_EQ(events.Since(0).size(), 1U);
}

TEST(TermEvents, OfTwoTermsAreKeptApart) {
  PathEvents all(5);
  TermEvents one(all, 0), other(all, 2);
  one.Add(1), other.Add(0);
  EXPECT_TRUE(one.Has(1));
  EXPECT_FALSE(one.Has(0));
  EXPECT_TRUE(other.Has(0));
  EXPECT_TRUE(all.Has(1) && all.Has(2));
}

}  // namespace
}  // namespace limpet

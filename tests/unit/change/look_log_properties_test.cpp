// SPDX-License-Identifier: MIT
// What must hold of the evidence of looks and passes, whatever the frames.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "estimation/change/look_log.hpp"
#include "limpet/core/random.hpp"
#include "tests/unit/change/lambda.hpp"

namespace limpet {
namespace {

const LookParams kParams;
/// Likelihood of one frame's answer, when a detector gives a box with that chance.
double Likelihood(double chance, bool has_box) { return has_box ? chance : 1.0 - chance; }
double Either(double detects, double false_alarm) {
  return 1.0 - (1.0 - detects) * (1.0 - false_alarm);
}

/// What was seen, from the definition: a look is the geometric mean of its frames, a pass their
/// product under each state of the world, a session the product of its passes.
double SessionLambda(const std::vector<std::vector<std::vector<FrameEvidence>>>& passes) {
  double whole = 1.0, overgrown = 1.0, bare = 1.0, faint_copy = 1.0;
  for (const auto& looks : passes) {
    double object = 1.0, faint = 1.0, failing = 1.0;
    for (const std::vector<FrameEvidence>& look : looks) {
      const double share = 1.0 / static_cast<double>(look.size());
      for (const FrameEvidence& frame : look) {
        const double f = frame.false_alarm, d = frame.detects(0);
        const auto seen = [&](double chance) {
          return std::pow(Likelihood(chance, frame.has_box), share);
        };
        object *= seen(Either(d, f));
        failing *= seen(Either(kParams.failing_detects * d, f));
        bare *= seen(f);
        faint *= seen(Either(kParams.clutter_detects * d, f));
      }
    }
    const auto may_fail = [&](double seen) {
      return (1.0 - kParams.pass_failure) * seen + kParams.pass_failure * failing;
    };
    whole *= may_fail(object);
    overgrown *= failing;
    faint_copy *= may_fail(faint);
  }
  return std::log((1.0 - kParams.place_failure) * whole + kParams.place_failure * overgrown) -
         std::log((1.0 - trial::kLookalike) * bare +
                  trial::kLookalike * 0.5 * (whole + faint_copy));
}

/// `looks` looks of one pass, a metre apart, with one to four frames each.
std::vector<std::vector<FrameEvidence>> RandomPass(Random& random, int looks) {
  std::vector<std::vector<FrameEvidence>> pass;
  for (int i = 0; i < looks; ++i) {
    std::vector<FrameEvidence>& look = pass.emplace_back();
    const auto frames = 1 + random.Index(4);
    for (std::uint64_t k = 0; k < frames; ++k) {
      look.push_back({.time = 0.0,
                      .p_OC = {1.0 * i - 2.0, 0.0, -3.0},
                      .detects = random.Uniform(0.2, 0.97),
                      .false_alarm = random.Uniform(0.001, 0.02),
                      .has_box = random.Chance(0.6)});
    }
  }
  return pass;
}

/// Adds a pass, four frames a second from `start` on.
void Add(const std::vector<std::vector<FrameEvidence>>& pass, double start, LookLog& log) {
  double t = start;
  for (const std::vector<FrameEvidence>& look : pass) {
    for (FrameEvidence frame : look) {
      frame.time = t += 0.25;
      log.Add(frame);
    }
  }
}
double LambdaOf(const std::vector<std::vector<FrameEvidence>>& pass) {
  LookLog log(kParams);
  Add(pass, 0.0, log);
  return trial::Lambda(log);
}

class LookLogProperties : public ::testing::TestWithParam<std::uint64_t> {
 protected:
  Random random_{GetParam()};
  const std::vector<std::vector<FrameEvidence>> pass_ = RandomPass(random_, 4);
};

TEST_P(LookLogProperties, LambdaIsTheLogOfTheLikelihoodRatioByDefinition) {
  EXPECT_NEAR(LambdaOf(pass_), SessionLambda({pass_}), 1e-9);
}

TEST_P(LookLogProperties, TheOrderOfFramesWithinALookDoesNotMatter) {
  auto shuffled = pass_;
  for (std::vector<FrameEvidence>& look : shuffled)
    std::ranges::reverse(look);
  EXPECT_NEAR(LambdaOf(shuffled), LambdaOf(pass_), 1e-12);
}

TEST_P(LookLogProperties, APlaceThatIsFlownOverTheOtherWayTellsTheSame) {
  auto backward = pass_;
  std::ranges::reverse(backward);
  EXPECT_NEAR(LambdaOf(backward), LambdaOf(pass_), 1e-12);
}

TEST_P(LookLogProperties, FramesThatRepeatTheirLookAddNothing) {
  auto twice = pass_;
  for (std::vector<FrameEvidence>& look : twice)
    look.insert(look.end(), look.begin(), look.end());
  EXPECT_NEAR(LambdaOf(twice), LambdaOf(pass_), 1e-9);
}

TEST_P(LookLogProperties, PassesShareWhatLastsInAnyOrder) {
  const auto other = RandomPass(random_, 3);
  LookLog one_first(kParams), other_first(kParams);
  Add(pass_, 0.0, one_first);
  Add(other, 100.0, one_first);
  Add(other, 0.0, other_first);
  Add(pass_, 100.0, other_first);
  EXPECT_NEAR(trial::Lambda(one_first), SessionLambda({pass_, other}), 1e-9);
  EXPECT_NEAR(trial::Lambda(one_first), trial::Lambda(other_first), 1e-9);
  EXPECT_EQ(one_first.passes(), 2);
}

TEST_P(LookLogProperties, ABoxMoreNeverSpeaksAgainstPresence) {
  for (std::size_t look = 0; look < pass_.size(); ++look) {
    for (std::size_t frame = 0; frame < pass_[look].size(); ++frame) {
      auto with = pass_, without = pass_;
      with[look][frame].has_box = true;
      without[look][frame].has_box = false;
      EXPECT_GT(LambdaOf(with), LambdaOf(without));
    }
  }
}

TEST_P(LookLogProperties, TheWorldsPlaceAndTheClockDoNotMatter) {
  auto turned = pass_;
  for (std::vector<FrameEvidence>& look : turned) {
    for (FrameEvidence& frame : look)
      frame.p_OC = {frame.p_OC.y(), -frame.p_OC.x(), frame.p_OC.z()};
  }
  LookLog log(kParams);
  Add(turned, 1e6, log);
  EXPECT_NEAR(trial::Lambda(log), LambdaOf(pass_), 1e-9);
}

TEST_P(LookLogProperties, NoNumberOfPassesIsSurerThanWhatLastsAllows) {
  LookLog never(kParams), always(kParams);
  for (int pass = 0; pass < 8; ++pass) {
    auto seen = pass_, missed = pass_;
    for (std::size_t look = 0; look < pass_.size(); ++look) {
      for (std::size_t frame = 0; frame < pass_[look].size(); ++frame) {
        seen[look][frame].has_box = true;
        missed[look][frame].has_box = false;
      }
    }
    Add(seen, 100.0 * pass, always);
    Add(missed, 100.0 * pass, never);
  }
  constexpr double kLooks = 8.0 * 4.0;
  EXPECT_GT(trial::Lambda(never),
            std::log(kParams.place_failure) + kLooks * std::log(1.0 - kParams.failing_detects));
  EXPECT_LT(trial::Lambda(always), -std::log(0.5 * trial::kLookalike));
}

INSTANTIATE_TEST_SUITE_P(Seeds, LookLogProperties, ::testing::Range<std::uint64_t>(1, 13));

FrameEvidence FrameAt(const Eigen::Vector3d& p_OC, double time, bool has_box = true) {
  return {.time = time, .p_OC = p_OC, .detects = 0.9, .false_alarm = 0.003, .has_box = has_box};
}

TEST(LookLogBorders, ANewLookBeginsAtHalfAMetre) {
  for (const auto& [moved, looks] : {std::pair{0.49, 1}, std::pair{0.51, 2}}) {
    LookLog log(kParams);
    log.Add(FrameAt({0.0, 0.0, -4.0}, 0.0));
    log.Add(FrameAt({0.0, 0.0, -4.0 + moved}, 1.0));
    EXPECT_EQ(log.looks()(0), looks) << moved << " m";
  }
}

TEST(LookLogBorders, ANewLookBeginsAtFifteenDegrees) {
  for (const auto& [degrees, looks] : {std::pair{14.0, 1}, std::pair{16.0, 2}}) {
    const double angle = degrees * std::numbers::pi / 180.0;
    LookLog log(kParams);
    log.Add(FrameAt({0.0, 0.0, -1.0}, 0.0));
    log.Add(FrameAt({0.0, std::sin(angle), -std::cos(angle)}, 1.0));
    EXPECT_EQ(log.looks()(0), looks) << degrees << " degrees";
  }
}

TEST(LookLogBorders, ANewPassBeginsAfterEightSecondsOutOfSight) {
  for (const auto& [pause, passes] : {std::pair{7.9, 1}, std::pair{8.1, 2}}) {
    LookLog log(kParams);
    log.Add(FrameAt({0.0, 0.0, -3.0}, 0.0));
    log.Add(FrameAt({1.0, 0.0, -3.0}, pause));
    EXPECT_EQ(log.passes(), passes) << pause << " s";
  }
}

TEST(LookLogBorders, ADetectorThatSeesNothingHereTellsNothing) {
  LookLog log(kParams);
  log.Add({.time = 0.0, .p_OC = {0, 0, -3}, .detects = 0.0, .false_alarm = 0.01, .has_box = false});
  EXPECT_NEAR(trial::Lambda(log), 0.0, 1e-12);
}

}  // namespace
}  // namespace limpet

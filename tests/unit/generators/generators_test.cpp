// SPDX-License-Identifier: MIT
// What every generator must keep to, however it finds its paths, and what each is for.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/helm/generator_registry.hpp"
#include "tests/unit/planning/scene.hpp"

namespace limpet {
namespace {

using scene::kArea;
using scene::kRadius;
using ::testing::IsEmpty;

/// Half of Table 1's area has been seen; the vehicle is somewhere.
class HalfSurveyed {
 public:
  explicit HalfSurveyed(const Pose2& at) {
    for (const double north : {-13.0, -9.5, -6.0}) {
      scene::Fly(grid_, DubinsPath({north, -18.0, 0.5 * std::numbers::pi}, {{0.0, 36.0}}));
    }
    ground_.Update(grid_);
    now.pose = at;
    now.ground = &ground_;
    now.region = &region_;
    now.turn_radius = kRadius;
    goals.objective.ground = {.cover = 1.0, .frontier = 0.5};
    goals.objective.targets = {{.north = 4.0, .east = 1.0, .window = {1.5, 1.5}, .value = 40.0},
                               {.north = -6.0, .east = -5.0, .window = {1.5, 1.5}, .value = 40.0}};
    goals.destinations = {{.north = 0.0, .east = 0.0}};
    goals.leads_into_region = true;
  }
  /// What the generator called `name` offers after `options`.
  [[nodiscard]] std::vector<Option> OffersOf(const std::string& name,
                                             std::vector<Option> options = {}) const {
    const std::size_t before = options.size();
    GeneratorParams().Build(name, Random(3)).front()->Offer(now, goals, options);
    options.erase(options.begin(), options.begin() + static_cast<std::ptrdiff_t>(before));
    return options;
  }
  [[nodiscard]] const Region& region() const { return region_; }

  Situation now;
  SearchGoals goals;

 private:
  SurveyGrid grid_{kArea};
  Ground ground_{grid_, scene::TableFootprint()};
  Region region_{kArea};
};

const Pose2 kInside{-12.5, -15.5, 0.5 * std::numbers::pi};

std::vector<std::string> Names() {
  std::vector<std::string> names;
  for (const auto& [name, plan] : GeneratorRegistry()) {
    names.push_back(name);
  }
  return names;
}

class EveryGenerator : public ::testing::TestWithParam<std::string> {};

TEST_P(EveryGenerator, OffersPathsThatJoinThePoseAndStayInside) {
  Random random(11);
  for (int i = 0; i < 8; ++i) {
    const Pose2 at{random.Uniform(-12.0, 12.0), random.Uniform(-15.0, 15.0),
                   random.Uniform(-std::numbers::pi, std::numbers::pi)};
    const HalfSurveyed survey(at);
    for (const Option& option : survey.OffersOf(GetParam())) {
      EXPECT_LT(Distance(option.path.start(), at), 1e-9);
      EXPECT_NEAR(std::remainder(option.path.start().yaw - at.yaw, 2.0 * std::numbers::pi), 0.0,
                  1e-9);
      EXPECT_GT(option.path.length(), 0.0);
      EXPECT_TRUE(survey.region().Contains(option.path)) << option.source;
      EXPECT_EQ(option.source, GetParam() == "gaps" ? "gap" : GetParam());
    }
  }
}

TEST_P(EveryGenerator, OffersTheSameForTheSame) {
  const HalfSurveyed survey(kInside);
  const std::vector<Option> a = survey.OffersOf(GetParam()), b = survey.OffersOf(GetParam());
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].path.length(), b[i].path.length());
    EXPECT_EQ(a[i].path.end().north, b[i].path.end().north);
  }
}

TEST_P(EveryGenerator, OffersNothingThatNobodySeeks) {
  HalfSurveyed survey(kInside);
  survey.goals = {};
  EXPECT_THAT(survey.OffersOf(GetParam()), IsEmpty());
}

TEST_P(EveryGenerator, LeavesWhatOthersOfferAsItIs) {
  const HalfSurveyed survey(kInside);
  std::vector<Option> options{{.source = "other", .path = DubinsPath(kInside, {{0.0, 7.0}})}};
  GeneratorParams().Build(GetParam(), Random(3)).front()->Offer(survey.now, survey.goals, options);
  ASSERT_FALSE(options.empty());
  EXPECT_EQ(options.front().source, "other");
  EXPECT_EQ(options.front().path.length(), 7.0);
}

INSTANTIATE_TEST_SUITE_P(OfTheRegistry, EveryGenerator, ::testing::ValuesIn(Names()),
                         [](const auto& generator) { return generator.param; });

TEST(GeneratorParams, HaveKeysThatNoTwoGeneratorsShare) {
  GeneratorParams params;
  std::multiset<std::string> keys;
  for (const ParamSpec& spec : DescribeParams(params)) {
    keys.insert(spec.name);
  }
  for (const std::string& key : keys) {
    EXPECT_EQ(keys.count(key), 1U) << key;
  }
}

TEST(GeneratorParams, ReachTheGeneratorTheyAreOf) {
  GeneratorParams params;
  ConfigBlock block;
  block.entries = {{.key = "horizon_m", .value = "12.5", .where = {}}};
  ASSERT_THAT(ApplyBlock(block, DescribeParams(params)), IsEmpty());
  const GeneratorParams copy = params;
  const HalfSurveyed survey(kInside);
  std::vector<Option> options;
  copy.Build("beam", Random(1)).front()->Offer(survey.now, survey.goals, options);
  ASSERT_FALSE(options.empty());
  EXPECT_NEAR(options.front().path.length(), 12.5, 1e-9);
}

TEST(GeneratorParams, RefuseAGeneratorThatNobodyKnows) {
  EXPECT_THROW(static_cast<void>(GeneratorParams().Build("beam, bream", Random(1))), ConfigError);
}

TEST(TransitGenerator, FindsTheWayInFromAnyStartOutside) {
  for (const double away : {5.0, 50.0, 120.0}) {
    for (int i = 0; i < 16; ++i) {
      const double bearing = 2.0 * std::numbers::pi * i / 16;
      const Pose2 start{(20.0 + away) * std::cos(bearing) * 1.5,
                        (20.0 + away) * std::sin(bearing) * 1.5, 0.7 * i};
      const HalfSurveyed survey(start);
      const std::vector<Option> ways = survey.OffersOf("transit");
      ASSERT_EQ(ways.size(), 1U);
      EXPECT_TRUE(survey.region().IsRecoverable(ways.front().path.end(), kRadius));
      EXPECT_LT(ways.front().path.length(), survey.region().Outside(start) + 25.0);
    }
  }
}

TEST(TransitGenerator, LeavesTheWayInToOthersWhereTheyKnowOne) {
  const HalfSurveyed survey({40.0, 0.0, 0.0});
  std::vector<Option> others = survey.OffersOf("transit");
  EXPECT_THAT(survey.OffersOf("transit", others), IsEmpty());
  others.front().source = "home";  // the way home is no way in
  EXPECT_EQ(survey.OffersOf("transit", others).size(), 1U);
}

TEST(PaperGenerator, GoesOnWithTheBranchThatWasChosen) {
  const HalfSurveyed survey(kInside);
  const auto generators = GeneratorParams().Build("paper", Random(3));
  std::vector<Option> options;
  generators.front()->Offer(survey.now, survey.goals, options);
  const auto longest = std::ranges::max_element(
      options, {}, [](const Option& option) { return option.views.size(); });
  ASSERT_GE(longest->views.size(), 3U);
  const Pose2 second = longest->views[1];
  HalfSurveyed next(longest->path.end());
  generators.front()->OnChoice(*longest);
  std::vector<Option> after;
  generators.front()->Offer(next.now, next.goals, after);
  ASSERT_FALSE(after.empty());
  EXPECT_LT(Distance(after.front().path.end(), second), 1e-9);
}

/// Decided anew at each step on its way out of a basin, round two corners: it goes on with what it
/// flies rather than begin another way in the middle of a turn.
TEST(HomeGenerator, ArrivesByTheWayThatItBeganHoweverOftenItIsDecided) {
  const Region region(scene::Basin(), Meters(0.4));
  Random random(4);
  for (int run = 0; run < 40; ++run) {
    HalfSurveyed survey({random.Uniform(-18.0, -3.0), random.Uniform(0.0, 20.0),
                         random.Uniform(-std::numbers::pi, std::numbers::pi)});
    survey.now.region = &region;
    survey.goals.destinations = {{.north = 12.0, .east = 36.0}};
    const auto home = std::move(GeneratorParams().Build("home", Random(3)).front());
    double planned = -1.0;
    for (double left = 1e9; left > 0.5;) {
      std::vector<Option> options;
      home->Offer(survey.now, survey.goals, options);
      ASSERT_EQ(options.size(), 1U);
      home->OnChoice(options[0]);
      const double step = std::min(options[0].path.length(), random.Uniform(0.5, 8.0));
      survey.now.pose = options[0].path.At(step);
      survey.now.travelled += step;
      left = options[0].path.length() - step;
      if (planned < 0.0) planned = options[0].path.length();
      ASSERT_LT(survey.now.travelled, planned + 0.1) << run;
    }
  }
}

}  // namespace
}  // namespace limpet

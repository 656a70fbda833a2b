// SPDX-License-Identifier: MIT
// What every registered generator must keep to, however it finds its paths.
#include "limpet/helm/generator_registry.hpp"

#include <cmath>
#include <numbers>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/generators/half_surveyed.hpp"

namespace limpet {
namespace {

using ::testing::IsEmpty;

std::vector<std::string> GeneratorNames() {
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

INSTANTIATE_TEST_SUITE_P(OfTheRegistry, EveryGenerator, ::testing::ValuesIn(GeneratorNames()),
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

}  // namespace
}  // namespace limpet

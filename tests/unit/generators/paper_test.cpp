// SPDX-License-Identifier: MIT
#include <algorithm>

#include <gtest/gtest.h>

#include "limpet/helm/generator_registry.hpp"
#include "tests/unit/generators/half_surveyed.hpp"

namespace limpet {
namespace {

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

}  // namespace
}  // namespace limpet

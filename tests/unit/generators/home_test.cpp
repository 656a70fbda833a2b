// SPDX-License-Identifier: MIT
#include <algorithm>
#include <numbers>

#include <gtest/gtest.h>

#include "limpet/helm/generator_registry.hpp"
#include "tests/unit/generators/half_surveyed.hpp"
#include "tests/unit/planning/scene.hpp"

namespace limpet {
namespace {

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

// SPDX-License-Identifier: MIT
#include "limpet/imaging/caustics.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace limpet {
namespace {

struct Moments {
  double mean = 0.0, sigma = 0.0;
};
Moments MomentsOf(const Caustics::Layer& layer) {
  double sum = 0.0;
  double sum2 = 0.0;
  constexpr int kSide = 200;
  for (int i = 0; i < kSide; ++i) {
    for (int j = 0; j < kSide; ++j) {
      const double light = layer.LightAt({0.0613 * i, 0.0591 * j});
      sum += light;
      sum2 += light * light;
    }
  }
  const double mean = sum / (kSide * kSide);
  return {mean, std::sqrt(sum2 / (kSide * kSide) - mean * mean)};
}

TEST(Caustics, GatherLightWithoutMakingAny) {
  const Caustics caustics(0.4, 3);
  const Moments shallow = MomentsOf(caustics.At({0.0, 0.0, 1.0}, Seconds(0.0)));
  EXPECT_NEAR(shallow.mean, 1.0, 0.03);
  EXPECT_NEAR(shallow.sigma, 0.4, 0.06);
}

TEST(Caustics, FadeWithDepth) {
  const Caustics caustics(0.4, 3);
  const double at_1_m = MomentsOf(caustics.At({0.0, 0.0, 1.0}, Seconds(0.0))).sigma;
  EXPECT_NEAR(MomentsOf(caustics.At({0.0, 0.0, 6.0}, Seconds(0.0))).sigma, 0.5 * at_1_m,
              0.05 * at_1_m);
}

TEST(Caustics, MoveWithTimeAndRepeatWithTheSeed) {
  const Caustics one(0.4, 3);
  const Caustics same(0.4, 3);
  const Caustics other(0.4, 4);
  EXPECT_EQ(one.At({0.0, 0.0, 2.0}, Seconds(1.5)).LightAt({3.1, 2.2}),
            same.At({0.0, 0.0, 2.0}, Seconds(1.5)).LightAt({3.1, 2.2}));
  EXPECT_NE(one.At({0.0, 0.0, 2.0}, Seconds(1.5)).LightAt({3.1, 2.2}),
            one.At({0.0, 0.0, 2.0}, Seconds(1.7)).LightAt({3.1, 2.2}));
  EXPECT_NE(one.At({0.0, 0.0, 2.0}, Seconds(1.5)).LightAt({3.1, 2.2}),
            other.At({0.0, 0.0, 2.0}, Seconds(1.5)).LightAt({3.1, 2.2}));
}

TEST(Caustics, DoNotDependOnWhereAFrameIsTaken) {
  const Caustics caustics(0.4, 3);
  for (const double place : {0.3, 7.9, -1234.5}) {
    const auto seen_from = [&](double north, double east) {
      return caustics.At({north, east, 2.0}, Seconds(1.5))
          .LightAt({place + 1.0, 2.0 * place - 2.0});
    };
    EXPECT_NEAR(seen_from(place, 2.0 * place), seen_from(place - 3.0, 2.0 * place + 1.0), 2e-3);
  }
}

TEST(Caustics, WithoutContrastAreFlat) {
  const Caustics none(0.0, 3);
  EXPECT_TRUE(none.At({0.0, 0.0, 2.0}, Seconds(0.0)).is_flat());
  EXPECT_EQ(none.At({0.0, 0.0, 2.0}, Seconds(0.0)).LightAt({1.0, 1.0}), 1.0F);
}

}  // namespace
}  // namespace limpet

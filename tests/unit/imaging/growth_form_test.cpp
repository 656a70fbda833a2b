// SPDX-License-Identifier: MIT
#include "limpet/imaging/growth_form.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace limpet {
namespace {

const Eigen::Vector3f kSun = Eigen::Vector3f(0.5F, 0.0F, 0.8F).normalized();

Growth Of(GrowthKind kind) {
  return {.kind = kind, .turn = 0.3F, .form = 0.4F, .color = {0.1F, 0.2F, 0.3F}};
}

constexpr auto kAllKinds = {GrowthKind::kStone, GrowthKind::kPlant, GrowthKind::kStarfish,
                            GrowthKind::kUrchin, GrowthKind::kShell};

TEST(GrowthForm, CoversSomeOfItsCircleAndNothingFarAway) {
  for (const GrowthKind kind : kAllKinds) {
    double cover = 0.0;
    for (int i = -20; i <= 20; ++i) {
      for (int j = -20; j <= 20; ++j) {
        const GrowthSample sample =
            GrowthAt(Of(kind), 0.05F * static_cast<float>(i), 0.05F * static_cast<float>(j), kSun);
        EXPECT_GE(sample.cover, 0.0F);
        EXPECT_LE(sample.cover, 1.0F);
        EXPECT_TRUE((sample.albedo >= 0.0F).all());
        cover += sample.cover / (20.0 * 20.0);
      }
    }
    EXPECT_GT(cover, 0.3);  // of a circle of area pi
    EXPECT_EQ(GrowthAt(Of(kind), 1.6F, 0.0F, kSun).cover, 0.0F);
  }
}

TEST(GrowthForm, StoneIsBrightTowardsTheSunAndThrowsItsShadowAway) {
  const Growth stone = Of(GrowthKind::kStone);
  EXPECT_GT(GrowthAt(stone, 0.5F, 0.0F, kSun).albedo(1),
            1.5F * GrowthAt(stone, -0.5F, 0.0F, kSun).albedo(1));
  EXPECT_GT(GrowthAt(stone, -1.1F, 0.0F, kSun).cover,
            GrowthAt(stone, 1.1F, 0.0F, kSun).cover + 0.1F);
}

TEST(GrowthForm, StarfishHasFiveArms) {
  Growth star = Of(GrowthKind::kStarfish);
  star.turn = 0.0F;
  int arms = 0;
  bool was_inside = true;  // towards 0 there is an arm
  for (int i = 1; i <= 360; ++i) {
    const float angle = static_cast<float>(i) * 3.14159265F / 180.0F;
    const bool is_inside =
        GrowthAt(star, 0.7F * std::cos(angle), 0.7F * std::sin(angle), kSun).cover > 0.5F;
    if (is_inside && !was_inside) ++arms;
    was_inside = is_inside;
  }
  EXPECT_EQ(arms, 5);
}

}  // namespace
}  // namespace limpet

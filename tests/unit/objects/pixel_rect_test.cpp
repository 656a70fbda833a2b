// SPDX-License-Identifier: MIT
#include "limpet/objects/pixel_rect.hpp"

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

PixelRect RandomRect(Random& random) {
  const double left = random.Uniform(-50.0, 600.0);
  const double top = random.Uniform(-50.0, 400.0);
  return {left, top, left + random.Uniform(1.0, 200.0), top + random.Uniform(1.0, 200.0)};
}

TEST(PixelRect, OfABoxHasItsMiddleAndItsSize) {
  const Box box{.u = 100.0, .v = 50.0, .w = 30.0, .h = 12.0, .color = {}};
  const PixelRect rect = RectOf(box);
  EXPECT_EQ(rect.left, 85.0);
  EXPECT_EQ(rect.bottom, 56.0);
  EXPECT_EQ(rect.area(), 360.0);
}

TEST(PixelRect, GivesTheBoxBackThatItWasMadeOf) {
  Random random(3, "boxes");
  for (int i = 0; i < 200; ++i) {
    const PixelRect rect = RandomRect(random);
    Box box;
    SetRect(rect, box);
    EXPECT_NEAR(RectOf(box).left, rect.left, 1e-9);
    EXPECT_NEAR(RectOf(box).top, rect.top, 1e-9);
    EXPECT_NEAR(RectOf(box).right, rect.right, 1e-9);
    EXPECT_NEAR(RectOf(box).bottom, rect.bottom, 1e-9);
  }
}

TEST(PixelRect, OverlapIsOneWithItselfSymmetricAndNothingApart) {
  Random random(4, "rectangles");
  for (int i = 0; i < 200; ++i) {
    const PixelRect a = RandomRect(random);
    const PixelRect b = RandomRect(random);
    EXPECT_NEAR(Overlap(a, a), 1.0, 1e-12);
    EXPECT_EQ(Overlap(a, b), Overlap(b, a));
    EXPECT_GE(Overlap(a, b), 0.0);
    EXPECT_LE(Overlap(a, b), 1.0);
    EXPECT_EQ(Overlap(a, {a.right + 1.0, a.top, a.right + 9.0, a.bottom}), 0.0);
  }
}

TEST(PixelRect, OverlapOfHalfAndWholeIsAHalf) {
  EXPECT_NEAR(Overlap({0.0, 0.0, 10.0, 10.0}, {0.0, 0.0, 5.0, 10.0}), 0.5, 1e-12);
}

TEST(PixelRect, TurnedInsideOutHasNoArea) {
  EXPECT_EQ((PixelRect{10.0, 0.0, 5.0, 8.0}.area()), 0.0);
  EXPECT_EQ(Intersection({0.0, 0.0, 4.0, 4.0}, {6.0, 0.0, 9.0, 4.0}).area(), 0.0);
}

}  // namespace
}  // namespace limpet

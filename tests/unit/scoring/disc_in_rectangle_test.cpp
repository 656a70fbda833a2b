// SPDX-License-Identifier: MIT
#include "limpet/scoring/disc_in_rectangle.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

TEST(DiscInRectangle, IsWholeInTheMiddle) {
  EXPECT_EQ(ShareOfDiscInRectangle({0.0, 0.0}, 0.5, {2.0, 1.0}), 1.0);
}

TEST(DiscInRectangle, IsHalfOnAnEdge) {
  EXPECT_NEAR(ShareOfDiscInRectangle({2.0, 0.0}, 0.5, {2.0, 1.0}), 0.5, 1e-12);
}

TEST(DiscInRectangle, IsAQuarterOnACorner) {
  EXPECT_NEAR(ShareOfDiscInRectangle({-2.0, 1.0}, 0.5, {2.0, 1.0}), 0.25, 1e-12);
}

TEST(DiscInRectangle, IsTheRectanglesShareWhenTheDiscIsTheLarger) {
  EXPECT_NEAR(ShareOfDiscInRectangle({0.3, -0.2}, 10.0, {2.0, 1.0}),
              8.0 / (100.0 * 3.14159265358979), 1e-9);
}

TEST(DiscInRectangle, AgreesWithCountingPointsAnywhere) {
  Random random(7);
  for (int trial = 0; trial < 20; ++trial) {
    const double x = random.Uniform(-2.0, 2.0), y = random.Uniform(-2.0, 2.0);
    int inside = 0, points = 0;
    for (double a = -0.995; a < 1.0; a += 0.01) {
      for (double b = -0.995; b < 1.0; b += 0.01) {
        if (a * a + b * b > 1.0) continue;
        ++points;
        inside += std::abs(x + a) <= 1.3 && std::abs(y + b) <= 0.7 ? 1 : 0;
      }
    }
    EXPECT_NEAR(ShareOfDiscInRectangle({x, y}, 1.0, {1.3, 0.7}),
                static_cast<double>(inside) / points, 0.01);
  }
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/survey/inscribed_circle.hpp"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace limpet {
namespace {

double RadiusIn(std::vector<PlanePoint> corners) {
  const Expected<SimplePolygon> polygon = SimplePolygon::Of(std::move(corners));
  return polygon ? InscribedRadius(*polygon) : -1.0;
}

TEST(InscribedCircle, IsHalfAsWideAsARectangle) {
  EXPECT_NEAR(RadiusIn({{-13.0, 6.0}, {-10.0, 6.0}, {-10.0, 16.0}, {-13.0, 16.0}}), 1.5, 0.03);
  EXPECT_NEAR(RadiusIn({{0.0, 0.0}, {1000.0, 0.0}, {1000.0, 0.4}, {0.0, 0.4}}), 0.2, 0.01);
}

TEST(InscribedCircle, IsATrianglesOwn) {
  EXPECT_NEAR(RadiusIn({{0.0, 0.0}, {30.0, 0.0}, {0.0, 40.0}}), 10.0, 0.2);
}

TEST(InscribedCircle, LiesWhereABentZoneIsWidest) {
  // Two arms of 2 m that meet in a square of 2 m: its middle is 1 m from the outer walls, and the
  // corner between the arms lets it be a little farther from all.
  const double radius =
      RadiusIn({{0.0, 0.0}, {20.0, 0.0}, {20.0, 2.0}, {2.0, 2.0}, {2.0, 20.0}, {0.0, 20.0}});
  EXPECT_NEAR(radius, 2.0 * std::numbers::sqrt2 / (1.0 + std::numbers::sqrt2), 0.03);
}

TEST(InscribedCircle, OfARoundZoneIsItsRadius) {
  std::vector<PlanePoint> corners;
  for (int i = 0; i < 400; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 400.0;
    corners.emplace_back(70.0 * std::cos(angle), 70.0 * std::sin(angle));
  }
  EXPECT_NEAR(RadiusIn(corners), 70.0, 1.4);
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/survey/simple_polygon.hpp"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

using testing::HasSubstr;

/// An L of 20 x 20 m without its north-eastern quarter, (north, east).
/// The corner of this index points into the polygon, whose corners run counter-clockwise.
bool IsReflex(const SimplePolygon& polygon, std::size_t i) {
  const std::vector<PlanePoint>& corners = polygon.corners();
  const std::size_t size = corners.size();
  const PlanePoint in = corners[i] - corners[(i + size - 1) % size];
  const PlanePoint out = corners[(i + 1) % size] - corners[i];
  return in.y() * out.x() - in.x() * out.y() < 0.0;
}

const std::vector<PlanePoint> kEll{{0, 0}, {0, 20}, {10, 20}, {10, 10}, {20, 10}, {20, 0}};

std::string ProblemWith(const std::vector<PlanePoint>& corners) {
  const auto polygon = SimplePolygon::Of(corners);
  return polygon ? "" : polygon.error().text;
}

TEST(SimplePolygon, HoldsWhatIsInsideOfANonConvexOne) {
  const SimplePolygon ell = *SimplePolygon::Of(kEll);
  EXPECT_TRUE(ell.Contains({5, 15}));
  EXPECT_TRUE(ell.Contains({15, 5}));
  EXPECT_FALSE(ell.Contains({15, 15}));
  EXPECT_DOUBLE_EQ(ell.Area(), 300.0);
  EXPECT_EQ(ell.low(), PlanePoint(0, 0));
  EXPECT_EQ(ell.high(), PlanePoint(20, 20));
}

TEST(SimplePolygon, TellsHowDeepAPlaceIsInsideOrHowFarOutside) {
  const SimplePolygon ell = *SimplePolygon::Of(kEll);
  EXPECT_DOUBLE_EQ(ell.Depth({5, 15}), 5.0);
  EXPECT_DOUBLE_EQ(ell.Depth({13, 14}), -3.0);
  EXPECT_DOUBLE_EQ(ell.Depth({7, 6}), 5.0);  // to the corner that points inwards
  EXPECT_DOUBLE_EQ(ell.Depth({-3, -4}), -5.0);
}

TEST(SimplePolygon, IsTheSameEitherWayRoundAndWithItsFirstCornerRepeated) {
  std::vector<PlanePoint> other(kEll.rbegin(), kEll.rend());
  other.push_back(other.front());
  const SimplePolygon ell = *SimplePolygon::Of(other);
  EXPECT_EQ(ell.size(), 6U);
  EXPECT_DOUBLE_EQ(ell.Area(), 300.0);
  int reflex = 0;
  for (std::size_t i = 0; i < ell.size(); ++i) {
    if (IsReflex(ell, i)) {
      ++reflex;
      EXPECT_EQ(ell.corners()[i], PlanePoint(10, 10));
    }
  }
  EXPECT_EQ(reflex, 1);
}

TEST(SimplePolygon, RefusesOneThatCrossesItselfAndSaysWhere) {
  EXPECT_THAT(ProblemWith({{0, 0}, {10, 10}, {10, 0}, {0, 10}}),
              HasSubstr("crosses or touches itself at 5.00,5.00"));
  EXPECT_THAT(ProblemWith({{0, 0}, {10, 0}, {10, 10}, {0, 5}, {10, 3}}), HasSubstr("itself"));
  EXPECT_THAT(ProblemWith({{0, 0}, {0, 10}, {0, 4}, {5, 5}}), HasSubstr("itself"));
}

TEST(SimplePolygon, RefusesWhatIsNoPolygon) {
  EXPECT_THAT(ProblemWith({{0, 0}, {0, 10}}), HasSubstr("has 2 corners"));
  EXPECT_THAT(ProblemWith({{0, 0}, {0, 10}, {0, 10}, {0, 0}}), HasSubstr("has 2 corners"));
  EXPECT_THAT(ProblemWith({{0, 0}, {0, 1e9}, {5, 5}}), HasSubstr("no place within"));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(ProblemWith({{0, 0}, {0, nan}, {5, 5}}), HasSubstr("no place within"));
}

}  // namespace
}  // namespace limpet

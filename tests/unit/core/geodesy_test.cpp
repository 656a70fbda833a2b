// SPDX-License-Identifier: MIT
#include "limpet/core/geodesy.hpp"

#include <cmath>

#include <gtest/gtest.h>
#include <mrpt/topography/conversions.h>

namespace limpet {
namespace {

TEST(LocalGrid, ItsOriginIsTheDatum) {
  const GeoPoint place = LocalGrid({.latitude_deg = 43.721, .longitude_deg = 10.283}).At(0.0, 0.0);
  EXPECT_NEAR(place.latitude_deg, 43.721, 1e-10);
  EXPECT_NEAR(place.longitude_deg, 10.283, 1e-10);
}

TEST(LocalGrid, AMetreIsWhatTheTablesOfTheEllipsoidSay) {
  // One degree of latitude at 45 deg is 111 131.8 m, of longitude 78 846.8 m (WGS84).
  const LocalGrid grid({.latitude_deg = 45.0, .longitude_deg = 0.0});
  EXPECT_NEAR(grid.At(100.0, 0.0).latitude_deg - 45.0, 100.0 / 111131.8, 1e-8);
  EXPECT_NEAR(grid.At(0.0, 100.0).longitude_deg, 100.0 / 78846.8, 1e-8);
}

TEST(DistanceBetween, IsRightNearAndFarAndRoundTheDateLine) {
  EXPECT_NEAR(DistanceBetween({43.72100, 10.283}, {43.72102, 10.283}), 2.22, 0.01);
  EXPECT_NEAR(DistanceBetween({0.0, 0.0}, {0.0, 180.0}), 20015e3, 1e3);
  EXPECT_NEAR(DistanceBetween({-17.5, -179.9}, {-17.5, 180.1}), 0.0, 1e-3);
  const LocalGrid grid({.latitude_deg = 60.0, .longitude_deg = 20.0});
  EXPECT_NEAR(DistanceBetween({60.0, 20.0}, grid.At(300.0, 400.0)), 500.0, 3.0);
}

TEST(LocalGrid, WorksSouthAndWest) {
  const GeoPoint place =
      LocalGrid({.latitude_deg = -33.0, .longitude_deg = -71.0}).At(-1000.0, -1000.0);
  EXPECT_LT(place.latitude_deg, -33.0);
  EXPECT_LT(place.longitude_deg, -71.0);
}

/// By MRPT: north and east of the place on the plane that touches the ellipsoid at the datum, with
/// the height at which its vertical meets that plane.
Eigen::Vector2d NorthEastByMrpt(const GeoPoint& datum, const GeoPoint& place) {
  mrpt::math::TPoint3D p;
  double height = 0.0;
  for (int i = 0; i < 5; ++i) {
    mrpt::topography::geodeticToENU_WGS84({place.latitude_deg, place.longitude_deg, height}, p,
                                          {datum.latitude_deg, datum.longitude_deg, 0.0});
    height -= p.z;
  }
  return {p.y, p.x};
}

class LocalGridByMrpt : public ::testing::TestWithParam<double> {};

TEST_P(LocalGridByMrpt, PlacesAreTheSameUpToAHundredKilometres) {
  const GeoPoint datum{.latitude_deg = GetParam(), .longitude_deg = 10.283};
  const LocalGrid grid(datum);
  for (const double distance : {1.0, 1e3, 1e4, 1e5}) {
    for (int k = 0; k < 16; ++k) {
      const Eigen::Vector2d p(distance * std::cos(0.4 * k), distance * std::sin(0.4 * k));
      const Eigen::Vector2d by_mrpt = NorthEastByMrpt(datum, grid.At(p.x(), p.y()));
      EXPECT_LT((by_mrpt - p).norm(), 1e-6 + 1e-11 * distance) << distance << " m, " << k;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Latitudes, LocalGridByMrpt, ::testing::Values(-71.0, -33.0, 0.0, 43.721));

}  // namespace
}  // namespace limpet

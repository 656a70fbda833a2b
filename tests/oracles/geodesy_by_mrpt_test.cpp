// SPDX-License-Identifier: MIT
#include <cmath>

#include <Eigen/Core>
#include <gtest/gtest.h>
#include <mrpt/topography/conversions.h>

#include "limpet/core/geodesy.hpp"

namespace limpet {
namespace {

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
      const Eigen::Vector2d by_mrpt = NorthEastByMrpt(datum, grid.At(p));
      EXPECT_LT((by_mrpt - p).norm(), 1e-6 + 1e-11 * distance) << distance << " m, " << k;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Latitudes, LocalGridByMrpt, ::testing::Values(-71.0, -33.0, 0.0, 43.721));

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/core/geodesy.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(LocalGrid, ItsOriginIsTheDatum) {
  const GeoPoint place =
      LocalGrid({.latitude_deg = 43.721, .longitude_deg = 10.283}).At({0.0, 0.0});
  EXPECT_NEAR(place.latitude_deg, 43.721, 1e-10);
  EXPECT_NEAR(place.longitude_deg, 10.283, 1e-10);
}

TEST(LocalGrid, AMetreIsWhatTheTablesOfTheEllipsoidSay) {
  // One degree of latitude at 45 deg is 111 131.8 m, of longitude 78 846.8 m (WGS84).
  const LocalGrid grid({.latitude_deg = 45.0, .longitude_deg = 0.0});
  EXPECT_NEAR(grid.At({100.0, 0.0}).latitude_deg - 45.0, 100.0 / 111131.8, 1e-8);
  EXPECT_NEAR(grid.At({0.0, 100.0}).longitude_deg, 100.0 / 78846.8, 1e-8);
}

TEST(DistanceBetween, IsRightNearAndFarAndRoundTheDateLine) {
  EXPECT_NEAR(DistanceBetween({43.72100, 10.283}, {43.72102, 10.283}), 2.22, 0.01);
  EXPECT_NEAR(DistanceBetween({0.0, 0.0}, {0.0, 180.0}), 20015e3, 1e3);
  EXPECT_NEAR(DistanceBetween({-17.5, -179.9}, {-17.5, 180.1}), 0.0, 1e-3);
  const LocalGrid grid({.latitude_deg = 60.0, .longitude_deg = 20.0});
  EXPECT_NEAR(DistanceBetween({60.0, 20.0}, grid.At({300.0, 400.0})), 500.0, 3.0);
}

TEST(LocalGrid, WorksSouthAndWest) {
  const GeoPoint place =
      LocalGrid({.latitude_deg = -33.0, .longitude_deg = -71.0}).At({-1000.0, -1000.0});
  EXPECT_LT(place.latitude_deg, -33.0);
  EXPECT_LT(place.longitude_deg, -71.0);
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/preflight/survey_facts.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/survey/survey_grid.hpp"

namespace limpet {
namespace {

Setting Says(double value) {
  Setting setting;
  setting.text = std::to_string(value);
  return setting;
}

SurveyFacts Survey(double north_extent, double east_extent, double altitude, double band) {
  SurveyFacts facts;
  facts.area.north_min = -0.5 * north_extent;
  facts.area.north_max = 0.5 * north_extent;
  facts.area.east_min = -0.5 * east_extent;
  facts.area.east_max = 0.5 * east_extent;
  facts.wanted_m2 = north_extent * east_extent;
  facts.altitude = Says(altitude);
  facts.band = Says(band);
  facts.turning_radius = 1.5;
  return facts;
}

TEST(SurveyFacts, IsOutsideByTheShortestWay) {
  const SurveyFacts facts = Survey(20.0, 40.0, 4.0, 2.0);
  EXPECT_EQ(facts.Outside({3.0, -19.0}), 0.0);
  EXPECT_EQ(facts.Outside({10.0, 20.0}), 0.0) << "the edge belongs to the area";
  EXPECT_DOUBLE_EQ(facts.Outside({12.0, 0.0}), 2.0);
  EXPECT_DOUBLE_EQ(facts.Outside({0.0, -25.0}), 5.0);
  EXPECT_DOUBLE_EQ(facts.Outside({-13.0, 24.0}), 5.0) << "off a corner";
}

TEST(PathEstimate, IsTheAreaOverTheWidthOfTheImage) {
  const SurveyFacts facts = Survey(30.0, 36.0, 4.0, 2.0);
  // 80 degrees across; above the bottom an object counts once it is wholly in the image.
  const double tangent = std::tan(40.0 * std::numbers::pi / 180.0);
  const double bottom = 8.0 * tangent;
  const double top = 4.0 * tangent - 2.0 * SurveyGrid::kDiscInset;
  const double band = 6.0 * tangent - 0.75 * 2.0 * SurveyGrid::kDiscInset;
  EXPECT_NEAR(EstimatePath(facts, "seabed", 1.0).lanes_m, 30.0 * 36.0 / bottom, 1e-6);
  EXPECT_NEAR(EstimatePath(facts, "top", 1.0).lanes_m, 30.0 * 36.0 / top, 1e-6);
  EXPECT_NEAR(EstimatePath(facts, "band", 1.0).lanes_m, 30.0 * 36.0 / band, 1e-6);
}

TEST(PathEstimate, TurnsOnceBetweenTwoLanes) {
  const double swath = 8.0 * std::tan(40.0 * std::numbers::pi / 180.0);
  const SurveyFacts one = Survey(swath * 0.99, 100.0, 4.0, 2.0);
  EXPECT_EQ(EstimatePath(one, "seabed", 1.0).turns_m, 0.0);
  const SurveyFacts three = Survey(swath * 2.99, 100.0, 4.0, 2.0);
  EXPECT_NEAR(EstimatePath(three, "seabed", 1.0).turns_m, 2.0 * std::numbers::pi * 1.5, 1e-9);
}

TEST(PathEstimate, OfAFlatBandIsThatOfTheBottom) {
  const SurveyFacts facts = Survey(30.0, 36.0, 4.0, 0.0);
  EXPECT_NEAR(EstimatePath(facts, "band", 0.9).total(), EstimatePath(facts, "seabed", 0.9).total(),
              1e-9);
}

TEST(PathEstimate, IsNothingWhereTheBandReachesTheCamera) {
  EXPECT_EQ(EstimatePath(Survey(30.0, 36.0, 2.0, 2.0), "top", 0.95).total(), 0.0);
}

class AnySurvey : public ::testing::TestWithParam<int> {};

TEST_P(AnySurvey, TakesALongerWayForMoreAreaMoreShareAndLessAltitude) {
  Random random(static_cast<std::uint64_t>(GetParam()));
  const double north = random.Uniform(5.0, 200.0), east = random.Uniform(5.0, 200.0);
  const double altitude = random.Uniform(2.5, 8.0), share = random.Uniform(0.3, 0.9);
  const auto way = [&](double n, double e, double a, double s) {
    return EstimatePath(Survey(n, e, a, 1.5), "top", s).lanes_m;
  };
  const double reference = way(north, east, altitude, share);
  EXPECT_NEAR(way(2.0 * north, east, altitude, share), 2.0 * reference, 1e-9 * reference);
  EXPECT_GT(way(north, east, altitude, share + 0.1), reference);
  EXPECT_GT(way(north, east, 0.9 * altitude, share), reference);
  EXPECT_NEAR(way(east, north, altitude, share), reference, 1e-9 * reference)
      << "an area turned by 90 degrees is the same work";
}

INSTANTIATE_TEST_SUITE_P(Seeds, AnySurvey, ::testing::Range(1, 9));

}  // namespace
}  // namespace limpet

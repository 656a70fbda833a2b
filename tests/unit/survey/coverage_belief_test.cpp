// SPDX-License-Identifier: MIT
#include "limpet/survey/coverage_belief.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

const SurveyArea kBeliefArea{.north_min = 0.0,
                             .north_max = 20.0,
                             .east_min = 0.0,
                             .east_max = 24.0,
                             .margin = 2.0,
                             .object_height_max = 2.0};
constexpr double kAltitude_m = 4.0, kDown_m = 3.5;
/// Half of what a level image shows across, at the band's top [m].
const double kHalfTop = 2.0 * std::tan(0.5 * 80.0 * std::numbers::pi / 180.0) - 0.08;

/// What flew over the area: the map and what is believed of it.
struct SurveyOf {
  SurveyGrid grid{kBeliefArea};
  CoverageBelief belief{kBeliefArea, grid};
  CameraModel camera{};
  double t = 0.0;

  /// A lane due north at `east`, from edge to edge and a little beyond.
  void FlyLane(double east, const PlaceSigma& sigma = {}) {
    for (double north = -3.0; north <= 23.0; north += 0.125) {
      const PlacedView view{.t = t,
                            .X_WB = {{north, east, kDown_m}, 0.0, 0.0, 0.0},
                            .altitude = kAltitude_m,
                            .sigma = sigma};
      grid.Observe(view.X_WB, view.altitude, camera);
      belief.Observe(view, camera, grid);
      t += 0.25;
    }
    t += 60.0;
  }
  /// Lanes whose images just meet at the band's top, `apart` further apart than that; they reach
  /// `over` beyond the area's edges.
  void FlyLanes(double apart, double over, const PlaceSigma& first, const PlaceSigma& later) {
    const double width = 2.0 * kHalfTop;
    bool is_first = true;
    for (double east = kHalfTop - over; east - kHalfTop < 24.0 + over; east += width + apart) {
      FlyLane(east, is_first ? first : later);
      is_first = false;
    }
  }
  [[nodiscard]] Coverage Claim() const { return belief.Expected(grid); }
};

constexpr PlaceSigma kExact{};

TEST(CoverageBelief, ClaimsWhatTheGridShowsWhereTheVehicleKnewItsPlaceExactly) {
  SurveyOf survey;
  survey.FlyLane(4.0);
  survey.FlyLane(9.0);
  const Coverage shown = survey.grid.coverage(), claim = survey.Claim();
  EXPECT_NEAR(claim.seabed, shown.seabed, 1e-9);
  EXPECT_NEAR(claim.band_top, shown.band_top, 1e-3);
  EXPECT_NEAR(claim.band, shown.band, 0.005);
}

TEST(CoverageBelief, ClaimsNoMoreOfOnePassThanItShowsOnAverage) {
  SurveyOf exact, unsure;
  exact.FlyLane(12.0);
  unsure.FlyLane(12.0, {.absolute = 0.0, .beside = 0.6});
  EXPECT_NEAR(unsure.Claim().band_top, exact.Claim().band_top, 0.01);
}

TEST(CoverageBelief, ClaimsLessOfLanesThatMayHaveComeApart) {
  SurveyOf exact, unsure;
  exact.FlyLanes(0.0, 0.5, kExact, kExact);
  unsure.FlyLanes(0.0, 0.5, kExact, {.absolute = 0.0, .beside = 0.4});
  EXPECT_GT(exact.Claim().band_top, 0.99);
  EXPECT_LT(unsure.Claim().band_top, 0.96);
  EXPECT_GT(unsure.Claim().seabed, 0.995) << "where images overlap nothing opens";
}

TEST(CoverageBelief, ClaimsTheMeanOfWhatDriftedLanesReallyShow) {
  constexpr double kDrift = 0.4;  // 1-sigma between lanes that are neighbours [m]
  SurveyOf believed;
  believed.FlyLanes(0.0, 0.5, kExact, {.absolute = 0.0, .beside = kDrift});
  Random random(7, "drift");
  double truth = 0.0;
  constexpr int kWorlds = 40;
  for (int world = 0; world < kWorlds; ++world) {
    SurveyOf real;
    for (double east = kHalfTop - 0.5; east - kHalfTop < 24.5; east += 2.0 * kHalfTop) {
      real.FlyLane(east + random.Normal(kDrift / std::numbers::sqrt2));
    }
    truth += real.grid.coverage().band_top / kWorlds;
  }
  EXPECT_NEAR(believed.Claim().band_top, truth, 0.015);
}

TEST(CoverageBelief, ClaimsTheMeanOfWhatAMapShowsThatIsOffAsAWhole) {
  constexpr double kOff = 0.8;  // [m]
  SurveyOf believed;
  believed.FlyLanes(-0.5, 0.0, {.absolute = kOff, .beside = 0.0},
                    {.absolute = kOff, .beside = 0.0});
  Random random(8, "fix");
  double truth = 0.0;
  constexpr int kWorlds = 60;
  for (int world = 0; world < kWorlds; ++world) {
    SurveyOf real;
    const double off = random.Normal(kOff);
    for (double east = kHalfTop; east - kHalfTop < 24.0; east += 2.0 * kHalfTop - 0.5) {
      real.FlyLane(east + off);
    }
    truth += real.grid.coverage().band_top / kWorlds;
  }
  EXPECT_NEAR(believed.Claim().band_top, truth, 0.015);
  EXPECT_LT(believed.Claim().band_top, 0.99) << "the edges lie elsewhere";
}

TEST(CoverageBelief, IsSurerOfWhatASecondPassShows) {
  SurveyOf once, twice;
  const PlaceSigma sigma{.absolute = 0.0, .beside = 0.4};
  once.FlyLanes(0.0, 0.5, kExact, sigma);
  twice.FlyLanes(0.0, 0.5, kExact, sigma);
  twice.FlyLanes(0.0, 0.5, kExact, sigma);
  EXPECT_GT(twice.Claim().band_top, once.Claim().band_top + 0.01);
}

TEST(CoverageBelief, HearsOnePassOnceHoweverManyImagesItHas) {
  SurveyOf survey;
  const PlacedView view{.t = 0.0,
                        .X_WB = {{10.0, 12.0, kDown_m}, 0.0, 0.0, 0.0},
                        .altitude = kAltitude_m,
                        .sigma = {.absolute = 0.0, .beside = 0.5}};
  survey.belief.Observe(view, survey.camera, survey.grid);
  const Coverage one = survey.Claim();
  for (int again = 1; again < 20; ++again) {
    PlacedView later = view;
    later.t = 0.25 * again;
    survey.belief.Observe(later, survey.camera, survey.grid);
  }
  EXPECT_EQ(survey.Claim().band_top, one.band_top);
}

TEST(CoverageBelief, ClaimsNothingThatWasOutOfReachInTheWater) {
  SurveyOf survey;
  survey.FlyLanes(-0.5, 0.5, kExact, kExact);
  survey.grid.SetReach(3.0);  // the bottom, 4 m below, is out of sight
  EXPECT_EQ(survey.Claim().seabed, 0.0);
  EXPECT_GT(survey.Claim().band_top, 0.9);
}

/// The mean of what a normal error takes off an edge that was seen `over` beyond [m].
double LostOnAverage(double sigma, double over) {
  const double z = over / sigma;
  return sigma * (std::exp(-0.5 * z * z) / std::sqrt(2.0 * std::numbers::pi) -
                  0.5 * z * std::erfc(z / std::numbers::sqrt2));
}

TEST(CoverageBelief, ExpectsAtTheEdgesWhatMapsOfThatSigmaLoseOnAverage) {
  for (const double absolute : {0.098, 0.34, 0.48}) {
    for (const double over : {0.0, 0.25, 0.5}) {  // whole cells
      const PlaceSigma adrift{.absolute = absolute, .beside = 0.0};
      SurveyOf survey, exact;
      for (SurveyOf* of : {&survey, &exact}) {
        for (double reach = -over; reach < 26.0; reach += 2.0 * kHalfTop - 0.3)
          of->FlyLane(reach + kHalfTop, of == &survey ? adrift : kExact);
      }
      const double lost = LostOnAverage(absolute, over) / 24.0;
      EXPECT_NEAR(exact.Claim().band_top - survey.Claim().band_top, lost, 0.1 * lost + 2.5e-4)
          << absolute << " " << over;
    }
  }
}

TEST(CoverageBelief, CountsNoGroundOfAZone) {
  SurveyArea area = kBeliefArea;
  area.keep_out = "{8,6:16,6:16,14:8,14}";
  SurveyGrid grid(area);
  CoverageBelief belief(area, grid);
  const CameraModel camera;
  const Pose X_WB{{10.0, 11.0, kDown_m}, 0.0, 0.0, 0.0};
  grid.Observe(X_WB, kAltitude_m, camera);
  belief.Observe({.t = 0.0, .X_WB = X_WB, .altitude = kAltitude_m, .sigma = {}}, camera, grid);
  EXPECT_NEAR(belief.Expected(grid).seabed, grid.coverage().seabed, 1e-9);
}

TEST(CoverageBelief, CountsNoGroundThatSomethingStandsOnWhereverTheMapLies) {
  SurveyOf survey;
  const PlaceSigma adrift{.absolute = 0.5, .beside = 0.0};
  survey.FlyLanes(0.0, 3.0, adrift, adrift);
  const double before = survey.Claim().seabed;
  std::vector<std::uint32_t> standing;
  for (std::uint32_t row = 30; row < 50; ++row) {
    for (std::uint32_t column = 40; column < 60; ++column)
      standing.push_back(row * 96 + column);
  }
  survey.grid.SetStanding(standing);
  survey.belief.CountAnew();
  EXPECT_NEAR(survey.Claim().seabed, before, 0.01);
  EXPECT_GT(before, 0.9);
}

TEST(CoverageBelief, ClaimsNothingBehindAnObstacle) {
  const SightObstacles pile(
      {{.id = 1, .outline = {{11.0, 11.5}, {11.0, 12.5}, {11.5, 12.5}, {11.5, 11.5}}, .top = 0.0}});
  const PlacedView view{.t = 0.0,
                        .X_WB = {{10.0, 12.0, kDown_m}, 0.0, 0.0, 0.0},
                        .altitude = kAltitude_m,
                        .sigma = {.absolute = 0.0, .beside = 0.3}};
  SurveyOf hidden, clear;
  const Shadows shadows = pile.From(view.X_WB.p_WB, 6.0);
  hidden.grid.Observe(view.X_WB, view.altitude, hidden.camera, 0.0, shadows);
  hidden.belief.Observe(view, hidden.camera, hidden.grid, shadows);
  clear.grid.Observe(view.X_WB, view.altitude, clear.camera);
  clear.belief.Observe(view, clear.camera, clear.grid);
  EXPECT_LT(hidden.Claim().seabed, 0.96 * clear.Claim().seabed);
  EXPECT_GT(hidden.Claim().seabed, 0.8 * clear.Claim().seabed);
}

}  // namespace
}  // namespace limpet

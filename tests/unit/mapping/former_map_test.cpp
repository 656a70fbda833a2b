// SPDX-License-Identifier: MIT
#include "estimation/mapping/former_map.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "limpet/core/config.hpp"

namespace limpet {
namespace {

FormerView ViewAt(double t, std::optional<double> altitude, double age = 0.5) {
  FormerView view;
  view.frame.exposure = Seconds(t);
  view.frame.frame = static_cast<int>(t);
  view.frame.altitude = altitude;
  view.altitude_age = Seconds(age);
  return view;
}

using Keys = std::vector<std::array<std::string, 2>>;

/// A block of pMap that says its camera, and these.
Keys BlockWith(const Keys& more) {
  Keys keys{{"camera_fov_across_deg", "70"},
            {"camera_fov_along_deg", "50"},
            {"camera_width_px", "800"},
            {"camera_height_px", "600"}};
  keys.insert(keys.end(), more.begin(), more.end());
  return keys;
}

TEST(FormerViews, AreJudgedByTheMissionsOwnParametersWhereThePriorHasNone) {
  MapParams own;
  own.status.object_radius = Meters(0.35);
  own.status.detection.best = 0.77;
  const FormerViews views = FormerViewsOf(SessionPrior{}, own);
  EXPECT_EQ(views.model.look.object_radius, 0.35);
  EXPECT_EQ(views.model.look.detection.best, 0.77);
}

TEST(FormerViews, AreJudgedByTheParametersOfTheirOwnMission) {
  SessionPrior prior;
  prior.map_parameters = BlockWith({{"object_radius_m", "0.8"},
                                    {"visibility_m", "3"},
                                    {"new_look_distance_m", "0.7"},
                                    {"AppTick", "4"}});
  const FormerViews views = FormerViewsOf(prior, MapParams{});
  EXPECT_EQ(views.model.look.object_radius, 0.8);
  EXPECT_NEAR(views.water.estimate().visibility.value(), 3.0, 0.1);
  EXPECT_EQ(views.looks.new_look_distance.value(), 0.7);
  EXPECT_EQ(views.model.look.camera.width_px, 800);
  EXPECT_NEAR(views.model.look.camera.fov_across(), RadiansFromDegrees(70.0), 1e-9);
}

TEST(FormerViews, BelieveTheWaterThatTheFormerSessionFoundNotTheOneItExpected) {
  SessionPrior prior;
  prior.map_parameters = BlockWith({{"object_radius_m", "0.5"}, {"visibility_m", "8"}});
  prior.water = WaterVisibility{.visibility = Meters(2.5), .sd = Meters(1.2)};
  const WaterVisibility found = FormerViewsOf(prior, MapParams{}).water.estimate();
  EXPECT_NEAR(found.visibility.value(), 2.5, 0.1);
  EXPECT_NEAR(found.sd.value(), 1.2, 0.15) << "as unsure as it was";
  prior.water.reset();  // it gave none
  const WaterVisibility expected = FormerViewsOf(prior, MapParams{}).water.estimate();
  EXPECT_NEAR(expected.visibility.value(), 8.0, 0.3);
  EXPECT_GT(expected.sd.value(), 4.0);
}

TEST(FormerViews, OfParametersThatAreNoneAreRefused) {
  SessionPrior prior;
  prior.session = "old";
  prior.map_parameters = BlockWith({{"object_radius_m", "0.5"}});
  EXPECT_NO_THROW((void)FormerViewsOf(prior, MapParams{}));
  prior.map_parameters = BlockWith({{"object_radius_m", "0.5"}, {"no_such_key", "1"}});
  EXPECT_THROW((void)FormerViewsOf(prior, MapParams{}), ConfigError);
  prior.map_parameters = BlockWith({{"object_radius_m", "-3"}});
  EXPECT_THROW((void)FormerViewsOf(prior, MapParams{}), ConfigError);
  prior.map_parameters = {{"object_radius_m", "0.5"}};  // which camera?
  EXPECT_THROW((void)FormerViewsOf(prior, MapParams{}), ConfigError);
}

TEST(FormerViews, LeaveOutFramesThatTheMapDidNotUse) {
  SessionPrior prior;
  prior.views = {ViewAt(1.0, 4.0), ViewAt(2.0, std::nullopt, 0.0), ViewAt(3.0, 9.0),
                 ViewAt(20.0, 4.0, 12.0), ViewAt(21.0, 4.0)};
  const FormerViews views = FormerViewsOf(prior, MapParams{});
  std::vector<int> kept;
  for (const ObservedFrame& frame : views.frames)
    kept.push_back(frame.frame);
  // The second has the altitude of the first; the third is too high, the fourth's altitude too old.
  EXPECT_EQ(kept, (std::vector{1, 2, 21}));
}

TEST(FormerViews, BeforeAnyAltitudeTellNothing) {
  SessionPrior prior;
  prior.views = {ViewAt(1.0, std::nullopt), ViewAt(2.0, std::nullopt)};
  EXPECT_TRUE(FormerViewsOf(prior, MapParams{}).frames.empty());
}

}  // namespace
}  // namespace limpet

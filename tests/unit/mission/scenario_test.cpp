// SPDX-License-Identifier: MIT
#include "limpet/mission/scenario.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/mission/seabed.hpp"
#include "tests/unit/mission/scenario_errors.hpp"

namespace limpet {
namespace {

using ::testing::HasSubstr;

TEST(Scenario, LoadsTheTruthOfTable1) {
  const Scenario scenario =
      LoadScenario(std::filesystem::path(LIMPET_SOURCE_DIR) / "missions/table1/scenario.yaml");
  ASSERT_EQ(scenario.opis.size(), 5U);
  EXPECT_DOUBLE_EQ(scenario.seabed.depth_m, 7.5);
  EXPECT_EQ(scenario.opis[1].color, "orange");
  EXPECT_EQ(scenario.opis[1].Place("discovery"), Eigen::Vector3d(2, 10, 7));
  EXPECT_EQ(scenario.opis[1].Place("change"), std::nullopt);
  EXPECT_EQ(scenario.opis[4].Place("discovery"), std::nullopt);
}

TEST(Scenario, TakesDefaultsForWhatIsAbsent) {
  const Scenario scenario = ParseScenario("camera: boxes\n", "s.yaml");
  EXPECT_EQ(scenario.camera, "boxes");
  EXPECT_DOUBLE_EQ(scenario.water.visibility_m, 8.0);
}

TEST(Scenario, NamesUnknownKeysWithTheNearest) {
  EXPECT_THAT(ScenarioErrorsOf("seabed:\n  depht_m: 7\n"),
              HasSubstr("s.yaml:2: seabed.depht_m: unknown key; did you mean `depth_m`?"));
  EXPECT_THAT(ScenarioErrorsOf("watr: {}\n"), HasSubstr("did you mean `water`?"));
}

TEST(Scenario, ReportsEveryProblemAtOnce) {
  const std::string errors = ScenarioErrorsOf(
      "seabed: {depth_m: -3}\nwater: {visibility_m: clear}\ncamera: renderd\nsensors: [1]\n");
  EXPECT_THAT(errors, HasSubstr("s.yaml:1: seabed.depth_m: `-3` is not allowed; allowed: 0.5 to"));
  EXPECT_THAT(errors, HasSubstr("s.yaml:2: water.visibility_m: `clear`"));
  EXPECT_THAT(errors, HasSubstr("s.yaml:3: camera: `renderd` is not allowed"));
  EXPECT_THAT(errors, HasSubstr("s.yaml:4: sensors: a list of 1 is not allowed; allowed: a map"));
}

TEST(Scenario, SaysHowItsPicturesLook) {
  const Scenario scenario = ParseScenario(
      "image:\n  look: real\n  water: {dissolved: 1.5}\n  seabed: {kind: rock}\n"
      "  sensor: {jpeg_quality: 60}\n"
      "opis:\n  - {name: A, color: red, shape: cone, height_m: 0.6, tilt_deg: 90, band: white}\n",
      "s.yaml");
  EXPECT_EQ(scenario.image.look, "real");
  EXPECT_DOUBLE_EQ(scenario.image.water.dissolved, 1.5);
  EXPECT_EQ(scenario.image.seabed.kind, "rock");
  EXPECT_DOUBLE_EQ(scenario.image.sensor.jpeg_quality, 60.0);
  EXPECT_DOUBLE_EQ(scenario.image.light.caustics, ImageParams{}.light.caustics);
  EXPECT_EQ(scenario.opis[0].shape.shape, "cone");
  EXPECT_EQ(scenario.opis[0].shape.band, "white");
}

TEST(Scenario, RefusesLooksThatItDoesNotKnow) {
  EXPECT_THAT(ScenarioErrorsOf("image:\n  look: reel\n"), HasSubstr("s.yaml:2: image.look: "));
  EXPECT_THAT(ScenarioErrorsOf("image: {lens: {blur_px: 9}}\n"),
              HasSubstr("s.yaml:1: image.lens.blur_px: `9` is not allowed; allowed: 0 to 5"));
  EXPECT_THAT(ScenarioErrorsOf("image:\n  light: {\n    caustic: 1}\n"),
              HasSubstr("s.yaml:3: image.light.caustic: unknown key; did you mean `caustics`?"));
  EXPECT_THAT(ScenarioErrorsOf("image: {seabed: {kind: mud}}\n"), HasSubstr("image.seabed.kind: "));
}

TEST(Scenario, RefusesShapesThatThePlainLookCannotShow) {
  EXPECT_THAT(
      ScenarioErrorsOf("opis:\n  - {name: A, color: red, shape: tyre}\n"),
      HasSubstr(
          "s.yaml:2: opis[0]: the shape or band of `A` shows only with `image: {look: real}`"));
}

TEST(Scenario, SaysWhatDiffersFromTheDataSheets) {
  const Scenario scenario = ParseScenario(
      "water: {current_east_mps: 0.1, tide_period_s: 900, tide_swing_deg: 30}\n"
      "errors:\n  camera: {pitch_deg: 2, off_m: [0.1, 0, -0.1]}\n  gps: {jumps_per_h: 30}\n"
      "opis:\n  - {name: A, color: red, sway_m: [0.2, 0, 0], winter: [1, 2, 3]}\n",
      "s.yaml");
  EXPECT_EQ(scenario.water.current.tide_period, Seconds(900.0));
  EXPECT_EQ(scenario.errors.camera.mounting.off_B, Eigen::Vector3d(0.1, 0.0, -0.1));
  EXPECT_DOUBLE_EQ(scenario.errors.camera.mounting.pitch.in_text_unit(), 2.0);
  EXPECT_DOUBLE_EQ(scenario.errors.gps.multipath.jumps_per_h, 30.0);
  EXPECT_EQ(scenario.opis[0].motion.sway_W, Eigen::Vector3d(0.2, 0.0, 0.0));
}

TEST(Scenario, RefusesErrorsOutOfRangeAndThoseItDoesNotKnow) {
  const std::string errors = ScenarioErrorsOf(
      "errors:\n  dvl: {beam_loss_share: 1.5}\n  camera: {off_m: [0.1, 9, 0]}\n"
      "  fogg: {}\n  gps: {jump: 3}\nwater: {tide_swing_deg: 270}\n");
  EXPECT_THAT(
      errors,
      HasSubstr("s.yaml:2: errors.dvl.beam_loss_share: `1.5` is not allowed; allowed: 0 to 1"));
  EXPECT_THAT(errors, HasSubstr("s.yaml:3: errors.camera.off_m: `[0.1, 9, 0]` is not allowed"));
  EXPECT_THAT(errors, HasSubstr("s.yaml:4: errors.fogg: unknown key; did you mean `fog`?"));
  EXPECT_THAT(errors, HasSubstr("s.yaml:5: errors.gps.jump: unknown key; did you mean `jump_m`?"));
  EXPECT_THAT(errors, HasSubstr("s.yaml:6: water.tide_swing_deg: `270` is not allowed; allowed: 0 "
                                "to 180 deg"));
}

TEST(Scenario, AcceptsAnySessionNameForAPlace) {
  const Scenario scenario = ParseScenario(
      "opis:\n  - {name: A, color: red, winter: [1, 2, 3], change2: null}\n", "s.yaml");
  EXPECT_EQ(scenario.opis[0].Place("winter"), Eigen::Vector3d(1, 2, 3));
  EXPECT_TRUE(scenario.opis[0].places.contains("change2"));
}

TEST(Scenario, RefusesAMisspeltSession) {
  EXPECT_THAT(ScenarioErrorsOf("opis:\n  - {name: A, color: red, chnage: null}\n"),
              HasSubstr("s.yaml:2: opis[0].chnage: unknown key; did you mean `change`?"));
}

TEST(Scenario, RefusesAPlaceThatIsNoTriple) {
  EXPECT_THAT(ScenarioErrorsOf("opis:\n  - {name: A, color: red, discovery: [1, 2]}\n"),
              HasSubstr("opis[0].discovery: a list of 2 is not allowed"));
}

TEST(Scenario, RefusesTwoObjectsOfOneName) {
  EXPECT_THAT(ScenarioErrorsOf("opis:\n  - {name: A, color: red}\n  - {name: A, color: red}\n"),
              HasSubstr("s.yaml:3: opis[1].name: `A` is the name of two objects"));
}

TEST(Scenario, RefusesAnObjectInsideTheSeabedOrInTheAir) {
  EXPECT_THAT(ScenarioErrorsOf("opis:\n  - {name: A, color: red, discovery: [0, 0, 9]}\n"),
              HasSubstr("`A` is not in the water"));
  EXPECT_THAT(ScenarioErrorsOf("opis:\n  - {name: A, color: red, discovery: [0, 0, 0.2]}\n"),
              HasSubstr("`A` is not in the water"));
}

TEST(Scenario, RefusesAKeyGivenTwice) {
  EXPECT_THAT(ScenarioErrorsOf("camera: boxes\ncamera: boxes\n"),
              HasSubstr("s.yaml:2: camera: is given"));
}

TEST(Scenario, NamesTheLineWhereTheYamlBreaks) {
  EXPECT_THAT(ScenarioErrorsOf("camera: boxes\nopis: [\n"), HasSubstr("not YAML"));
  EXPECT_THAT(ScenarioErrorsOf("camera: boxes\n---\ncamera: rendered\n"),
              HasSubstr("a second document"));
}

TEST(Scenario, SaysWhichFileCannotBeRead) {
  EXPECT_THROW(static_cast<void>(LoadScenario("/nonexistent/scenario.yaml")), ConfigError);
}

TEST(Seabed, SlopesDownTowardsItsDirection) {
  const Scenario::Seabed scenario{
      .depth_m = 10.0, .slope_deg = 45.0, .slope_toward_deg = 90.0, .roughness_m = 0.0, .seed = 1};
  EXPECT_NEAR(SeabedDepth(scenario, {100.0, 3.0}), 13.0, 1e-9);
}

TEST(Seabed, HasReliefOfTheGivenStandardDeviationAndNoMean) {
  for (const int seed : {1, 2, 3}) {
    const Seabed seabed({.depth_m = 10.0, .roughness_m = 0.2, .seed = seed});
    double sum = 0.0;
    double squares = 0.0;
    int count = 0;
    for (double north = -60.0; north < 60.0; north += 0.37) {
      for (double east = -60.0; east < 60.0; east += 0.41) {
        const double relief = seabed.Depth({north, east}) - 10.0;
        sum += relief;
        squares += relief * relief;
        ++count;
      }
    }
    EXPECT_NEAR(sum / count, 0.0, 0.005);
    EXPECT_NEAR(std::sqrt(squares / count), 0.2, 0.01);
  }
}

TEST(Seabed, IsTheSameSurfaceBothWays) {
  const Scenario::Seabed scenario{.roughness_m = 0.1, .seed = 7};
  const Seabed seabed(scenario);
  EXPECT_EQ(seabed.Depth({3.1, -4.7}), SeabedDepth(scenario, {3.1, -4.7}));
}

TEST(Seabed, DiffersBySeed) {
  EXPECT_NE(SeabedDepth({.roughness_m = 0.1, .seed = 1}, {1.0, 1.0}),
            SeabedDepth({.roughness_m = 0.1, .seed = 2}, {1.0, 1.0}));
}

TEST(Seabed, IsSmooth) {
  const Seabed seabed({.roughness_m = 0.05, .seed = 1});
  for (double north = -5.0; north < 5.0; north += 0.01) {
    EXPECT_NEAR(seabed.Depth({north, 1.0}), seabed.Depth({north + 0.01, 1.0}), 0.01);
  }
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/sensors/dvl_model.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/unit/sensors/statistics.hpp"

namespace limpet {
namespace {

constexpr double kSeabed = 7.5;

SoundScene FlatScene(std::vector<SoundScene::Sphere> spheres = {}) {
  return {[](const Eigen::Vector2d&) { return kSeabed; }, std::move(spheres)};
}

DvlModel::Params Perfect() {
  DvlModel::Params params;
  params.sheet.noise_mps = 1e-12;
  params.sheet.vertical_noise_mps = params.sheet.scale_sigma = 0.0;
  params.sheet.misalignment_sigma = Radians(0.0);
  params.sheet.bias_mps = params.sheet.range_noise_m = params.sheet.range_noise_share = 0.0;
  return params;
}

SimTruth Cruising() {
  SimTruth truth;
  truth.down = 3.5;
  truth.u = 0.5;
  truth.r = 0.2;
  return truth;
}

TEST(DvlModel, MeasuresTheVelocityOfItsLeverArm) {
  DvlModel dvl(Perfect(), FlatScene(), Random(1));
  const DvlSample sample = *dvl.Sample(Cruising(), Seconds(0.0));
  EXPECT_NEAR(*sample.u, 0.5, 1e-9);
  EXPECT_NEAR(*sample.v, -0.2 * 0.2, 1e-9);
}

TEST(DvlModel, RangesReachAFlatSeabedAlongItsTiltedBeams) {
  DvlModel dvl(Perfect(), FlatScene(), Random(1));
  const DvlSample sample = *dvl.Sample(Cruising(), Seconds(0.0));
  const double height = kSeabed - 3.5 - 0.18;
  for (const auto& range : sample.beams()) {
    EXPECT_NEAR(*range, height / std::cos(RadiansFromDegrees(25.0)), 1e-6);
  }
  EXPECT_NEAR(*sample.altitude, height, 1e-6);
}

TEST(DvlModel, BeamMeetsAFloatingObjectAndAltitudeStaysThatOfTheSeabed) {
  const double reach = (6.0 - 3.68) * std::tan(RadiansFromDegrees(25.0)) * std::sqrt(0.5);
  const SoundScene::Sphere opi{{-0.2 + reach, reach, 6.0}, 0.5};  // in beam 1, 45 deg starboard
  DvlModel dvl(Perfect(), FlatScene({opi}), Random(1));
  const DvlSample sample = *dvl.Sample(Cruising(), Seconds(0.0));
  EXPECT_NEAR(*sample.b1, (6.0 - 3.68) / std::cos(RadiansFromDegrees(25.0)) - 0.5, 1e-6);
  EXPECT_NEAR(*sample.altitude, kSeabed - 3.68, 1e-6);
}

TEST(DvlModel, BeamMeetsAColumnThatStandsThere) {
  const double reach = 2.0 * std::tan(RadiansFromDegrees(25.0)) * std::sqrt(0.5);
  const UprightBody column =
      UprightBody::Column({-0.2 + reach + 0.3, reach}, {.radius = 0.3, .top = 0.0});
  DvlModel dvl(Perfect(), {[](const Eigen::Vector2d&) { return kSeabed; }, {}, {column}},
               Random(1));
  const DvlSample sample = *dvl.Sample(Cruising(), Seconds(0.0));
  EXPECT_NEAR(*sample.b1, 2.0 / std::cos(RadiansFromDegrees(25.0)), 1e-6);
  EXPECT_NEAR(*sample.altitude, kSeabed - 3.68, 1e-6);
}

TEST(DvlModel, HasTheNoiseItStates) {
  DvlModel dvl({}, FlatScene(), Random(2));
  Statistics u, w, range;
  for (int i = 0; i < 4000; ++i) {
    const DvlSample sample = *dvl.Sample(Cruising(), Seconds(0.2 * i));
    u.Add(*sample.u), w.Add(*sample.w), range.Add(*sample.b2);
  }
  EXPECT_NEAR(u.sigma(), 0.01, 0.001);
  EXPECT_NEAR(w.sigma(), 0.005, 0.0005);
  EXPECT_NEAR(range.sigma(), 0.0184, 0.002);
}

TEST(DvlModel, IsWorseThanItStatesIfTheScenarioSaysSo) {
  DvlModel::Params params;
  params.error.sheet.noise_factor = 3.0;
  DvlModel dvl(params, FlatScene(), Random(2));
  Statistics u, w, range;
  for (int i = 0; i < 4000; ++i) {
    const DvlSample sample = *dvl.Sample(Cruising(), Seconds(0.2 * i));
    u.Add(*sample.u), w.Add(*sample.w), range.Add(*sample.b2);
    ASSERT_EQ(sample.sd_horizontal, 0.01);
    ASSERT_EQ(sample.sd_vertical, 0.005);
  }
  EXPECT_NEAR(u.sigma(), 0.03, 0.003);
  EXPECT_NEAR(w.sigma(), 0.015, 0.0015);
  EXPECT_NEAR(range.sigma(), 3.0 * 0.0184, 0.006);
}

TEST(DvlModel, ScaleAndMisalignmentDifferBetweenSessions) {
  Statistics scale, angle;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    DvlModel::Params params;
    params.sheet.noise_mps = 1e-9;
    params.sheet.bias_mps = 0.0;
    SimTruth truth = Cruising();
    truth.r = 0.0;
    const DvlSample sample =
        *DvlModel(params, FlatScene(), Random(seed)).Sample(truth, Seconds(0.0));
    scale.Add(std::hypot(*sample.u, *sample.v) / 0.5 - 1.0);
    angle.Add(std::atan2(*sample.v, *sample.u));
  }
  EXPECT_NEAR(scale.sigma(), 0.002, 2e-4);
  EXPECT_NEAR(angle.sigma(), RadiansFromDegrees(0.15), RadiansFromDegrees(0.015));
}

bool HasLock(const SimTruth& truth) {
  return DvlModel({}, FlatScene(), Random(1)).Sample(truth, Seconds(0.0))->has_lock;
}

TEST(DvlModel, LosesTheBottomTooCloseTooFarAndUpsideDown) {
  SimTruth truth;
  truth.down = 7.1;
  EXPECT_FALSE(HasLock(truth));
  truth.down = -60.0;
  EXPECT_FALSE(HasLock(truth));
  truth.down = 3.5;
  EXPECT_TRUE(HasLock(truth));
  truth.roll = M_PI;
  EXPECT_FALSE(HasLock(truth));
}

TEST(DvlModel, DropsOutAsOftenAndAsLongAsConfigured) {
  DvlModel::Params params;
  params.dropout_per_min = 1.0;
  DvlModel dvl(params, FlatScene(), Random(5));
  int spells = 0, lost = 0;
  bool had_lock = true;
  constexpr int kSamples = 5 * 60 * 600;
  for (int i = 0; i < kSamples; ++i) {
    const bool has_lock = dvl.Sample(Cruising(), Seconds(0.2 * i))->has_lock;
    spells += had_lock && !has_lock ? 1 : 0;
    lost += has_lock ? 0 : 1;
    had_lock = has_lock;
  }
  EXPECT_NEAR(spells / 600.0, 60.0 / 65.5, 0.1);  // one spell per 60 s of lock and 5.5 s without
  EXPECT_NEAR(0.2 * lost / spells, 5.5, 0.4);
}

TEST(DvlModel, SaysNothingButThatItLostLockInADropout) {
  DvlModel::Params params;
  params.dropout_per_min = 1e6;
  DvlModel dvl(params, FlatScene(), Random(5));
  (void)dvl.Sample(Cruising(), Seconds(0.0));
  const DvlSample sample = *dvl.Sample(Cruising(), Seconds(0.2));
  EXPECT_FALSE(sample.has_lock);
  EXPECT_FALSE(sample.u || sample.altitude || sample.b1);
}

TEST(DvlModel, CallsItsOutliersValid) {
  DvlModel::Params params = Perfect();
  params.outlier_share = 0.05;
  DvlModel dvl(params, FlatScene(), Random(6));
  int outliers = 0;
  for (int i = 0; i < 4000; ++i) {
    const DvlSample sample = *dvl.Sample(Cruising(), Seconds(0.2 * i));
    ASSERT_TRUE(sample.has_lock);
    outliers += std::abs(*sample.u - 0.5) > 0.01 ? 1 : 0;
  }
  EXPECT_NEAR(outliers / 4000.0, 0.05, 0.01);
}

TEST(DvlModel, FaultsLeaveTheNoiseOfGoodSamplesAsItWas) {
  DvlModel::Params faulty;
  faulty.outlier_share = 0.2;
  DvlModel clean({}, FlatScene(), Random(9));
  DvlModel dirty(faulty, FlatScene(), Random(9));
  int equal = 0;
  for (int i = 0; i < 100; ++i) {
    const Seconds now(0.2 * i);
    equal += *clean.Sample(Cruising(), now)->u == *dirty.Sample(Cruising(), now)->u ? 1 : 0;
  }
  EXPECT_GT(equal, 60);
}

TEST(SoundScene, FindsASlopingSeabedToATenthOfAMillimetre) {
  const auto seabed = [](const Eigen::Vector2d& p_W) {
    return 6.0 + 0.2 * p_W.x() - 0.1 * p_W.y();
  };
  const SoundScene scene(seabed, {});
  const Eigen::Vector3d origin(1.0, 2.0, 3.0);
  const Eigen::Vector3d direction = Eigen::Vector3d(0.3, 0.3, 0.9).normalized();
  const Eigen::Vector3d hit = origin + *scene.Range(origin, direction, 50.0) * direction;
  EXPECT_NEAR(hit.z(), seabed(hit.head<2>()), 2e-4);
}

TEST(DvlModel, MeasuresInItsOwnFrame) {
  DvlModel::Params params = Perfect();
  params.sheet.yaw = Radians::FromTextUnit(90.0);
  DvlModel dvl(params, FlatScene(), Random(1));
  SimTruth truth = Cruising();
  truth.r = 0.0;
  const DvlSample sample = *dvl.Sample(truth, Seconds(0.0));
  EXPECT_NEAR(*sample.u, 0.0, 1e-9);
  EXPECT_NEAR(*sample.v, -0.5, 1e-9) << "ahead of the vehicle is to port of a DVL turned right";
}

TEST(DvlModel, HasNoLockBelowItsLeastAltitude) {
  DvlModel::Params params = Perfect();
  params.sheet.least_altitude = Meters(5.0);
  DvlModel dvl(params, FlatScene(), Random(1));
  EXPECT_FALSE(dvl.Sample(Cruising(), Seconds(0.0))->has_lock);
}

}  // namespace
}  // namespace limpet

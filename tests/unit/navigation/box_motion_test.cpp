// SPDX-License-Identifier: MIT
#include "estimation/navigation/box_motion.hpp"

#include <cmath>
#include <numbers>
#include <optional>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

constexpr double kAltitude = 4.0;

/// The world of a flight over one object after another.
struct Flight {
  CameraModel camera{};  ///< as it truly is
  double height = 0.6;   ///< of the objects above the seabed [m]
  double noise_px = 3.0;
  double turn_rate = 0.0;    ///< [rad/s]
  double false_boxes = 0.0;  ///< of the class in each image
  bool has_objects = true;
};

std::optional<MotionComparison::Ratio> FoundBy(const Flight& flight) {
  BoxMotion motion{CameraModel()};
  Random random(9);
  const double down = 6.0;
  Pose X{{0.0, 0.0, down - kAltitude}, 0.0, 0.0, 0.4};
  for (int i = 0; i < 1200; ++i) {
    X.yaw += 0.25 * flight.turn_rate;
    X.p_WB.x() += 0.125 * std::cos(X.yaw), X.p_WB.y() += 0.125 * std::sin(X.yaw);
    Detections frame{.frame = i, .exposure = Seconds(50.0 + 0.25 * i), .boxes = {}};
    const auto show = [&](double u, double v) {
      frame.boxes.push_back(
          {.u = u, .v = v, .w = 40.0, .h = 40.0, .confidence = 0.9, .color = "orange"});
    };
    // Objects 8 m apart; the nearest one shows if it is in the image.
    const Eigen::Vector3d p_W(8.0 * std::round(X.p_WB.x() / 8.0),
                              8.0 * std::round(X.p_WB.y() / 8.0), down - flight.height);
    const auto px = flight.camera.Project(flight.camera.InCamera(X, p_W));
    const bool is_inside = px && px->x() > 0.0 && px->y() > 0.0 &&
                           px->x() < flight.camera.width_px && px->y() < flight.camera.height_px;
    if (flight.has_objects && is_inside)
      show(px->x() + random.Normal(flight.noise_px), px->y() + random.Normal(flight.noise_px));
    if (random.Chance(flight.false_boxes))
      show(random.Uniform(30.0, 610.0), random.Uniform(30.0, 450.0));
    motion.Add(frame, X, Meters(kAltitude), 0.5);
  }
  return motion.Disagreement();
}

CameraModel TurnedAboutItsAxis(double angle) {
  CameraModel camera;
  camera.R_BC = camera.R_BC * Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return camera;
}

TEST(BoxMotion, OfACameraThatHangsAsBelievedAgreesHoweverHighObjectsStand) {
  for (const double height : {0.2, 1.0, 2.2}) {
    for (const double turn_rate : {0.0, 0.1})
      EXPECT_FALSE(FoundBy({.height = height, .turn_rate = turn_rate})) << height << turn_rate;
  }
}

TEST(BoxMotion, ATiltOfSomeDegreesIsForTheEstimatorNotForAWarning) {
  CameraModel camera;
  camera.R_BC = Eigen::AngleAxisd(0.08, Eigen::Vector3d(1.0, 1.0, 0.0).normalized()) * camera.R_BC;
  EXPECT_FALSE(FoundBy({.camera = camera}));
  EXPECT_FALSE(FoundBy({.camera = TurnedAboutItsAxis(0.15)}));
}

TEST(BoxMotion, ACameraUpsideDownOrTurnedByARightAngleIsFound) {
  using std::numbers::pi;
  for (const double angle : {pi, 0.5 * pi, -0.5 * pi}) {
    const auto found = FoundBy({.camera = TurnedAboutItsAxis(angle)});
    ASSERT_TRUE(found) << angle;
    const double turned = std::atan2(found->median_H.y(), found->median_H.x());
    EXPECT_NEAR(std::remainder(turned + angle, 2.0 * pi), 0.0, 0.4) << angle;
  }
}

TEST(BoxMotion, FalseBoxesTellNothing) {
  for (const double share : {0.3, 1.0})
    EXPECT_FALSE(FoundBy({.false_boxes = share, .has_objects = false})) << share;
  EXPECT_FALSE(FoundBy({.false_boxes = 0.3}));
}

TEST(BoxMotion, WithoutObjectsNothingIsFound) {
  EXPECT_FALSE(FoundBy({.camera = TurnedAboutItsAxis(3.0), .has_objects = false}));
}

}  // namespace
}  // namespace limpet

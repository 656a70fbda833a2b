// SPDX-License-Identifier: MIT
#include "estimation/association/box_reading.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/sphere_box.hpp"

namespace limpet {
namespace {

constexpr double kSphereRadius = 0.5;

TEST(BoxReading, FindsTheCentreOfASphereOffTheAxisWhereItsBoxHasItsMiddleElsewhere) {
  const CameraModel camera;
  const Eigen::Vector3d p_C(1.1, -0.6, 3.0);
  const auto box = BoxOfSphere(p_C, kSphereRadius, camera);
  ASSERT_TRUE(box.has_value());
  const BoxReading reading = ReadBox(*box, camera, {});
  const double u = camera.cx + camera.fx * p_C.x() / p_C.z();
  EXPECT_NEAR(reading.centre_px.x(), u, 1e-6);
  EXPECT_GT(std::abs(box->u - u), 2.0);
}

TEST(BoxReading, KnowsTheDistanceOfASphereOfKnownRadius) {
  const CameraModel camera;
  const Eigen::Vector3d p_C(0.5, 0.4, 3.0);
  const BoxReading reading = ReadBox(*BoxOfSphere(p_C, kSphereRadius, camera), camera, {});
  const double expected = 0.5 * (std::hypot(0.5, 3.0) + std::hypot(0.4, 3.0));
  EXPECT_NEAR(*reading.Range(kSphereRadius), expected, 1e-6);
}

TEST(BoxReading, TrustsOnlyTheAxisThatTheBorderDoesNotCut) {
  const CameraModel camera;
  const Eigen::Vector3d p_C(2.4, 0.0, 3.0);
  const BoxReading reading = ReadBox(*BoxOfSphere(p_C, kSphereRadius, camera), camera, {});
  EXPECT_TRUE(reading.is_cut_u);
  EXPECT_TRUE(std::isinf(reading.sigma_px.x()));
  EXPECT_FALSE(reading.is_cut_v);
  EXPECT_FALSE(reading.Range(kSphereRadius).has_value());
  EXPECT_TRUE(reading.TellsPlace(kSphereRadius));
}

/// A large object seldom shows whole.
TEST(BoxReading, KnowsTheDistanceOfASphereThatShowsByMoreThanHalf) {
  const CameraModel camera;
  const Eigen::Vector3d p_C(0.3, -1.3, 3.0);
  const BoxReading reading = ReadBox(*BoxOfSphere(p_C, 0.8, camera), camera, {});
  ASSERT_TRUE(reading.is_cut_v && !reading.is_cut_u);
  ASSERT_TRUE(reading.Range(0.8));
  EXPECT_NEAR(*reading.Range(0.8), std::hypot(0.3, 3.0), 1e-6) << "in the plane of the free axis";
  // Of one whose centre is outside the image the box shows no diameter.
  const auto beyond = BoxOfSphere({0.3, -2.0, 3.0}, 0.8, camera);
  EXPECT_FALSE(ReadBox(*beyond, camera, {}).Range(0.8));
}

TEST(BoxReading, KeepsTheEdgeThatShowsOfACutBox) {
  const CameraModel camera;
  const auto box = BoxOfSphere({2.4, 0.0, 3.0}, kSphereRadius, camera);
  const BoxReading reading = ReadBox(*box, camera, {});
  const auto& [across, along] = reading.cut_axes;
  ASSERT_TRUE(across && !along);
  EXPECT_EQ(across->axis, 0);
  EXPECT_TRUE(across->box.is_high_cut && !across->box.is_low_cut);
  EXPECT_NEAR(across->box.low, box->u - 0.5 * box->w, 1e-9);
}

TEST(BoxReading, TrustsTheEdgeOfACapThatTheDetectorIsNotSureOfLessThanThatOfMoreThanHalf) {
  const CameraModel camera;
  const auto share = [&camera](double down, double confidence) {
    Box box = *BoxOfSphere({0.3, -down, 3.0}, 0.8, camera);
    box.confidence = confidence;
    return ReadBox(box, camera, {}).cut_axes[1].value().sigma_px / std::max(box.w, box.h);
  };
  const double more = 1.3, cap = 2.0;  // [m] down: the centre is in the image, or beyond
  EXPECT_GT(share(cap, 0.6), 2.0 * share(more, 0.6));
  EXPECT_LT(share(cap, 0.8), 1.2 * share(more, 0.8));
}

TEST(BoxReading, DoubtsAnUnsureBox) {
  const CameraModel camera;
  Box box{.u = 300, .v = 200, .w = 80, .h = 80, .confidence = 1.0, .color = ""};
  const double sure = ReadBox(box, camera, {}).sigma_px.x();
  box.confidence = 0.5;
  EXPECT_NEAR(ReadBox(box, camera, {}).sigma_px.x(), 2.0 * sure, 1e-9);
}

TEST(BoxOfSphere, IsNothingBehindTheCameraOrOutOfTheImage) {
  const CameraModel camera;
  EXPECT_FALSE(BoxOfSphere({0.0, 0.0, -2.0}, kSphereRadius, camera).has_value());
  EXPECT_FALSE(BoxOfSphere({9.0, 0.0, 3.0}, kSphereRadius, camera).has_value());
}

}  // namespace
}  // namespace limpet

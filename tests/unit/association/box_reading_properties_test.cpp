// SPDX-License-Identifier: MIT
// What a box says of a sphere, over random spheres, cameras and borders.
#include <cmath>
#include <cstdint>
#include <optional>

#include <gtest/gtest.h>

#include "estimation/association/box_reading.hpp"
#include "limpet/core/random.hpp"
#include "tests/support/sphere_box.hpp"

namespace limpet {
namespace {

class BoxReadingProperties : public ::testing::TestWithParam<int> {
 protected:
  static CameraModel DrawLens(Random& random) {
    return CameraModel::FromFieldOfView(640, 480,
                                        {.across = RadiansFromDegrees(random.Uniform(50.0, 100.0)),
                                         .along = RadiansFromDegrees(random.Uniform(40.0, 80.0))});
  }
  /// A sphere whose centre is this far out, as shares of the image's half angles.
  [[nodiscard]] Eigen::Vector3d DrawCentre(double out_u, double out_v) {
    const double depth = random_.Uniform(2.0, 6.0);
    return {depth * out_u * camera_.half_across(), depth * out_v * camera_.half_along(), depth};
  }
  [[nodiscard]] std::optional<Box> BoxAt(const Eigen::Vector3d& p_C,
                                         double confidence = 0.9) const {
    std::optional<Box> box = BoxOfSphere(p_C, radius_, camera_);
    if (box) box->confidence = confidence;
    return box;
  }
  Random random_{static_cast<std::uint64_t>(GetParam()), "box reading"};
  const CameraModel camera_ = DrawLens(random_);
  const double radius_ = random_.Uniform(0.2, 0.6);
  const BoxNoise noise_{};
};

TEST_P(BoxReadingProperties, AWholeBoxLeadsToTheCentreAndTheDistance) {
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector3d p_C = DrawCentre(random_.Uniform(-0.5, 0.5), random_.Uniform(-0.5, 0.5));
    const std::optional<Box> box = BoxAt(p_C);
    ASSERT_TRUE(box);
    const BoxReading reading = ReadBox(*box, camera_, noise_);
    if (!reading.is_whole()) continue;
    const Eigen::Vector2d centre = *camera_.Project(p_C);
    EXPECT_LT((reading.centre_px - centre).norm(), 1e-6);
    // The mean of the distances in the two planes that the box's sides lie in.
    const double range = 0.5 * (std::hypot(p_C.x(), p_C.z()) + std::hypot(p_C.y(), p_C.z()));
    EXPECT_NEAR(*reading.Range(radius_), range, 1e-6);
    EXPECT_NEAR(*reading.Range(2.0 * radius_), 2.0 * range, 1e-6);
  }
}

TEST_P(BoxReadingProperties, AnEdgeThatTheBorderCutsSaysNothingAlongItsAxis) {
  for (int i = 0; i < 50; ++i) {
    const double side = random_.Chance(0.5) ? 1.0 : -1.0;
    const std::optional<Box> box = BoxAt(DrawCentre(side * 0.99, random_.Uniform(-0.3, 0.3)));
    ASSERT_TRUE(box);
    const BoxReading reading = ReadBox(*box, camera_, noise_);
    EXPECT_TRUE(reading.is_cut_u);
    EXPECT_TRUE(std::isinf(reading.sigma_px.x()));
    EXPECT_TRUE(std::isfinite(reading.sigma_px.y()));
    EXPECT_FALSE(reading.Range(radius_));
    EXPECT_TRUE(reading.TellsPlace(radius_));
    const auto& [across, along] = reading.cut_axes;
    ASSERT_TRUE(across && !along);
    EXPECT_EQ(across->axis, 0);
    EXPECT_EQ(across->box.is_high_cut, side > 0.0);
    EXPECT_TRUE(across->box.is_half_cut());
    EXPECT_GT(across->sigma_px, reading.sigma_px.y());
  }
}

TEST_P(BoxReadingProperties, ABoxInACornerTellsItsTwoEdgesAndNoSize) {
  for (int i = 0; i < 30; ++i) {
    const std::optional<Box> box = BoxAt(DrawCentre(1.0, 1.0));
    if (!box) continue;
    const BoxReading reading = ReadBox(*box, camera_, noise_);
    EXPECT_TRUE(reading.TellsPlace(radius_));
    EXPECT_FALSE(reading.TellsPlace(0.0));
    EXPECT_FALSE(reading.tells_size());
    const auto& [across, along] = reading.cut_axes;
    ASSERT_TRUE(across && along);
    EXPECT_NEAR(across->box.low, box->u - 0.5 * box->w, 1e-9);
    EXPECT_NEAR(along->box.low, box->v - 0.5 * box->h, 1e-9);
  }
}

TEST_P(BoxReadingProperties, ABoxThatThreeBordersCutTellsNoPlace) {
  const Box box{.u = 0.5 * camera_.width_px,
                .v = 40.0,
                .w = 1.0 * camera_.width_px,
                .h = 80.0,
                .confidence = 0.9,
                .color = "yellow"};
  const BoxReading reading = ReadBox(box, camera_, noise_);
  EXPECT_FALSE(reading.TellsPlace(radius_));
  EXPECT_TRUE(reading.cut_axes[0] && reading.cut_axes[1]) << "of a known object it still tells";
}

TEST_P(BoxReadingProperties, DoubtAndSizeMakeACentreLessCertain) {
  for (int i = 0; i < 50; ++i) {
    const std::optional<Box> box =
        BoxAt(DrawCentre(random_.Uniform(-0.3, 0.3), random_.Uniform(-0.3, 0.3)));
    ASSERT_TRUE(box);
    Box sure = *box, doubtful = *box, large = *box;
    sure.confidence = 1.0;
    doubtful.confidence = random_.Uniform(0.0, 0.9);
    large.w *= 1.2;
    const BoxReading of_sure = ReadBox(sure, camera_, noise_);
    EXPECT_NEAR(of_sure.sigma_px.x(), noise_.floor_px + noise_.share_of_size * sure.w, 1e-9);
    EXPECT_NEAR(ReadBox(doubtful, camera_, noise_).sigma_px.x(),
                of_sure.sigma_px.x() * (1.0 + noise_.doubt * (1.0 - doubtful.confidence)), 1e-9);
    large.confidence = 1.0;
    EXPECT_GT(ReadBox(large, camera_, noise_).sigma_px.x(), of_sure.sigma_px.x());
  }
}

TEST_P(BoxReadingProperties, AMirroredBoxIsReadInTheMirror) {
  for (int i = 0; i < 50; ++i) {
    const Eigen::Vector3d p_C = DrawCentre(random_.Uniform(-1.0, 1.0), random_.Uniform(-1.0, 1.0));
    const std::optional<Box> box = BoxAt(p_C), mirrored = BoxAt({-p_C.x(), p_C.y(), p_C.z()});
    ASSERT_EQ(box.has_value(), mirrored.has_value());
    if (!box) continue;
    const BoxReading one = ReadBox(*box, camera_, noise_);
    const BoxReading other = ReadBox(*mirrored, camera_, noise_);
    EXPECT_NEAR(one.centre_px.x() + other.centre_px.x(), camera_.width_px, 1e-6);
    EXPECT_NEAR(one.centre_px.y(), other.centre_px.y(), 1e-6);
    EXPECT_EQ(one.is_cut_u, other.is_cut_u);
    EXPECT_EQ(one.cut_axes[0].has_value(), other.cut_axes[0].has_value());
    EXPECT_NEAR(one.half_angle.x(), other.half_angle.x(), 1e-9);
  }
}

TEST_P(BoxReadingProperties, WithoutARadiusThereIsNoDistance) {
  const std::optional<Box> box = BoxAt(DrawCentre(0.0, 0.0));
  ASSERT_TRUE(box);
  EXPECT_FALSE(ReadBox(*box, camera_, noise_).Range(0.0));
}

INSTANTIATE_TEST_SUITE_P(Drawn, BoxReadingProperties, ::testing::Range(1, 9));

}  // namespace
}  // namespace limpet

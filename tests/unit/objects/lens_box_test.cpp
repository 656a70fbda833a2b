// SPDX-License-Identifier: MIT
#include "limpet/objects/lens_box.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace limpet {
namespace {

const LensModel& Barrel() {
  static const LensModel lens(CameraModel(), {.k1 = -0.18, .k2 = 0.03, .p1 = 0.002, .p2 = -0.003});
  return lens;
}

/// Edges of a sphere's silhouette in a pinhole camera, or through the lens, by points of it.
Box BoxOfSphere(const Eigen::Vector3d& p_C, double radius, const CameraModel* pinhole) {
  const Eigen::Vector3d side = p_C.unitOrthogonal(), other = p_C.normalized().cross(side);
  const double half = std::asin(radius / p_C.norm());
  double left = 1e9, top = 1e9, right = -1e9, bottom = -1e9;
  for (int i = 0; i < 720; ++i) {
    const double angle = i * 0.5 * 0.017453292519943295;
    const Eigen::Vector3d ray = std::cos(half) * p_C.normalized() +
                                std::sin(half) * (std::cos(angle) * side + std::sin(angle) * other);
    const CameraModel& enclosing = Barrel().enclosing();
    Eigen::Vector2d p = *(pinhole != nullptr ? *pinhole : enclosing).Project(ray);
    if (pinhole == nullptr) p = Barrel().FromPinhole(enclosing, p);
    left = std::min(left, p.x()), right = std::max(right, p.x());
    top = std::min(top, p.y()), bottom = std::max(bottom, p.y());
  }
  return {.u = 0.5 * (left + right),
          .v = 0.5 * (top + bottom),
          .w = right - left,
          .h = bottom - top,
          .confidence = 0.9,
          .color = "yellow"};
}

TEST(LensBox, OfASphereIsRectifiedToWhatAPinholeSeesOfIt) {
  for (const Eigen::Vector3d& p_C :
       {Eigen::Vector3d(0.1, 0.2, 4.0), Eigen::Vector3d(1.8, -1.0, 4.0),
        Eigen::Vector3d(-2.2, 1.2, 4.0), Eigen::Vector3d(-1.5, -1.3, 4.0)}) {
    const auto box = Rectified(Barrel(), BoxOfSphere(p_C, 0.5, nullptr));
    const Box pinhole = BoxOfSphere(p_C, 0.5, &Barrel().rectified());
    ASSERT_TRUE(box.has_value());
    EXPECT_NEAR(box->u, pinhole.u, 0.3) << p_C.transpose();
    EXPECT_NEAR(box->v, pinhole.v, 0.3) << p_C.transpose();
    EXPECT_NEAR(box->w, pinhole.w, 0.8) << p_C.transpose();
    EXPECT_NEAR(box->h, pinhole.h, 0.8) << p_C.transpose();
    EXPECT_EQ(box->color, "yellow");
  }
}

TEST(LensBox, OfASphereIsDistortedToWhatTheLensShowsOfIt) {
  const Eigen::Vector3d p_C(1.8, -1.0, 4.0);
  const auto box = Distorted(Barrel(), BoxOfSphere(p_C, 0.5, &Barrel().enclosing()));
  const Box seen = BoxOfSphere(p_C, 0.5, nullptr);
  ASSERT_TRUE(box.has_value());
  EXPECT_NEAR(box->u, seen.u, 0.3);
  EXPECT_NEAR(box->v, seen.v, 0.3);
  EXPECT_NEAR(box->w, seen.w, 0.8);
}

TEST(LensBox, ThatTheImageCutsIsCutInTheRectifiedOne) {
  const CameraModel& image = Barrel().image();
  const Box box{.u = 30.0,
                .v = 240.0,
                .w = 58.0,
                .h = 60.0,
                .confidence = 0.9,
                .color = "red"};  // left edge: 1 px
  ASSERT_TRUE(ExtentAcross(box, image).is_low_cut);
  const auto rectified = Rectified(Barrel(), box);
  ASSERT_TRUE(rectified.has_value());
  EXPECT_TRUE(ExtentAcross(*rectified, Barrel().rectified()).is_low_cut);
  EXPECT_FALSE(ExtentAlong(*rectified, Barrel().rectified()).is_cut());
}

TEST(LensBox, OutsideTheRectifiedImageIsNone) {
  const Box corner{.u = 8.0, .v = 8.0, .w = 10.0, .h = 10.0, .confidence = 0.9, .color = "red"};
  EXPECT_FALSE(Rectified(Barrel(), corner).has_value());
  const Detections frame{
      .frame = 3,
      .exposure = Seconds(1.0),
      .boxes = {corner,
                {.u = 320.0, .v = 240.0, .w = 40.0, .h = 40.0, .confidence = 0.8, .color = "red"}}};
  const RectifiedFrame rectified = Rectified(Barrel(), frame);
  ASSERT_EQ(rectified.frame.boxes.size(), 1U);
  EXPECT_EQ(rectified.numbers.at(0), 1);
  EXPECT_EQ(rectified.frame.frame, 3);
}

TEST(LensBox, OfNoNumbersIsNone) {
  const Box box{
      .u = std::nan(""), .v = 240.0, .w = 40.0, .h = 40.0, .confidence = 0.9, .color = "red"};
  EXPECT_FALSE(Rectified(Barrel(), box).has_value());
  const Box endless{
      .u = 1e308, .v = 240.0, .w = 1e308, .h = 40.0, .confidence = 0.9, .color = "red"};
  EXPECT_FALSE(Rectified(Barrel(), endless).has_value());
}

TEST(LensBox, OfAPinholeIsAsItCame) {
  const LensModel pinhole(CameraModel(), {});
  const Box box{.u = 1.0, .v = 2.0, .w = 30.0, .h = 4.0, .confidence = 0.9, .color = "red"};
  EXPECT_EQ(Rectified(pinhole, box)->u, 1.0);
  EXPECT_EQ(Distorted(pinhole, box)->w, 30.0);
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
// Where the image of a sphere ends, against its outline drawn point by point.
#include "estimation/smoothing/sphere_edge.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "tests/unit/smoothing/numeric_jacobian.hpp"

namespace limpet {
namespace {

/// A sphere before a camera.
struct SphereInView {
  Eigen::Vector3d p_C;
  double radius;
};

/// What the image shows of an outline [px]; empty if nothing.
struct ShownBox {
  Eigen::Vector2d low = Eigen::Vector2d::Constant(1e9), high = -low;
  [[nodiscard]] bool is_empty() const { return low.x() > high.x(); }
};

/// Every pixel of the image's border as a ray (x, y, 1).
std::vector<Eigen::Vector3d> BorderRays(const CameraModel& camera) {
  std::vector<Eigen::Vector3d> rays;
  const auto add = [&](double u, double v) {
    rays.emplace_back((u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy, 1.0);
  };
  for (int u = 0; u <= camera.width_px; ++u)
    add(u, 0.0), add(u, camera.height_px);
  for (int v = 0; v <= camera.height_px; ++v)
    add(0.0, v), add(camera.width_px, v);
  return rays;
}

/// From points of the cone that touches the sphere, those inside the image, and what of the border
/// it covers: of a sphere that fills the image beyond a corner the outline alone ends too soon.
ShownBox ShownOutline(const CameraModel& camera, const SphereInView& sphere) {
  constexpr int kPoints = 20000;
  const double half = std::asin(sphere.radius / sphere.p_C.norm());
  const Eigen::Vector3d axis = sphere.p_C.normalized(), across = axis.unitOrthogonal();
  const Eigen::Vector3d other = axis.cross(across);
  ShownBox box;
  const auto show = [&](const Eigen::Vector3d& ray) {
    const Eigen::Vector2d px(camera.cx + camera.fx * ray.x() / ray.z(),
                             camera.cy + camera.fy * ray.y() / ray.z());
    box.low = box.low.cwiseMin(px), box.high = box.high.cwiseMax(px);
  };
  for (int i = 0; i < kPoints; ++i) {
    const double turn = 2.0 * std::numbers::pi * i / kPoints;
    const Eigen::Vector3d ray =
        std::cos(half) * axis + std::sin(half) * (std::cos(turn) * across + std::sin(turn) * other);
    const double u = camera.cx + camera.fx * ray.x() / ray.z();
    const double v = camera.cy + camera.fy * ray.y() / ray.z();
    if (u >= 0.0 && u <= camera.width_px && v >= 0.0 && v <= camera.height_px) show(ray);
  }
  if (box.is_empty()) return box;
  for (const Eigen::Vector3d& ray : BorderRays(camera))
    if (ray.normalized().dot(axis) > std::cos(half)) show(ray);
  return box;
}

class SphereEdges : public ::testing::TestWithParam<int> {
 protected:
  /// Somewhere about the border of the image, often in a corner.
  SphereInView DrawSphere() {
    const double depth = random_.Uniform(2.0, 5.0);
    return {.p_C = {depth * camera_.half_across() * random_.Uniform(-1.2, 1.2),
                    depth * camera_.half_along() * random_.Uniform(-1.2, 1.2), depth},
            .radius = random_.Uniform(0.3, 1.2)};
  }
  [[nodiscard]] double SizeOf(int axis) const {
    return axis == 0 ? camera_.width_px : camera_.height_px;
  }

  Random random_{static_cast<std::uint64_t>(GetParam()), "sphere edge"};
  const CameraModel camera_ =
      CameraModel::FromFieldOfView(640, 480,
                                   {.across = RadiansFromDegrees(random_.Uniform(50.0, 100.0)),
                                    .along = RadiansFromDegrees(random_.Uniform(40.0, 80.0))});
};

TEST_P(SphereEdges, AreWhereTheShownOutlineEndsAlsoInACorner) {
  constexpr double kMargin = 3.0;  // [px] an end nearer to the border is the border
  int ends = 0;
  for (int i = 0; i < 60; ++i) {
    const SphereInView sphere = DrawSphere();
    const ShownBox shown = ShownOutline(camera_, sphere);
    if (shown.is_empty()) continue;
    for (const int axis : {0, 1}) {
      for (const BoxSide side : {BoxSide::kLow, BoxSide::kHigh}) {
        const bool is_low = side == BoxSide::kLow;
        const double end = is_low ? shown.low(axis) : shown.high(axis);
        if (end < kMargin || end > SizeOf(axis) - kMargin) continue;
        const auto edge = EdgeOfSphere(camera_, sphere.p_C, sphere.radius, {axis, side});
        ASSERT_TRUE(edge) << sphere.p_C.transpose() << ", radius " << sphere.radius;
        // A mere tip has few of the points.
        EXPECT_NEAR(edge->px, end, 1.0) << sphere.p_C.transpose() << ", radius " << sphere.radius
                                        << ", axis " << axis << (is_low ? ", low" : ", high");
        ++ends;
      }
    }
  }
  EXPECT_GT(ends, 60);
}

TEST_P(SphereEdges, MoveWithCentreAndSizeAsTheirDerivativesSay) {
  int checked = 0;
  for (int i = 0; i < 200; ++i) {
    const SphereInView sphere = DrawSphere();
    const BoxEnd end{.axis = i % 2, .side = i % 4 < 2 ? BoxSide::kLow : BoxSide::kHigh};
    const auto at = [&](const Eigen::Vector3d& p_C, double log_size) {
      const auto edge = EdgeOfSphere(camera_, p_C, sphere.radius * std::exp(log_size), end);
      return Eigen::VectorXd::Constant(1, edge ? edge->px : 0.0);
    };
    const auto edge = EdgeOfSphere(camera_, sphere.p_C, sphere.radius, end);
    if (!edge || ShownOutline(camera_, sphere).is_empty()) continue;
    const Eigen::Vector3d p_C = sphere.p_C;
    const Eigen::MatrixXd by_place =
        NumericJacobian([&](const Eigen::Vector3d& p) { return at(p, 0.0); }, p_C);
    const Eigen::MatrixXd by_size =
        NumericJacobian([&](const Eigen::Matrix<double, 1, 1>& size) { return at(p_C, size(0)); },
                        Eigen::Matrix<double, 1, 1>(0.0));
    const double scale = 1.0 + by_place.norm();
    EXPECT_LT((edge->by_p_C - by_place).norm(), 1e-3 * scale) << p_C.transpose();
    EXPECT_NEAR(edge->by_log_radius, by_size(0), 1e-3 * (1.0 + std::abs(by_size(0))));
    ++checked;
  }
  EXPECT_GT(checked, 50);
}

TEST_P(SphereEdges, OfASphereAllInsideTheImageAreTheEndsOfItsExtent) {
  int checked = 0;
  for (int i = 0; i < 200; ++i) {
    const SphereInView sphere = DrawSphere();
    for (const int axis : {0, 1}) {
      const auto end_px = [&](BoxSide side) {
        return EdgeOfSphere(camera_, sphere.p_C, sphere.radius, {axis, side}).value().px;
      };
      const SphereExtent u = ExtentOfSphere(camera_, sphere.p_C, sphere.radius, 0);
      const SphereExtent v = ExtentOfSphere(camera_, sphere.p_C, sphere.radius, 1);
      const bool is_inside =
          u.low > 0.0 && v.low > 0.0 && u.high < camera_.width_px && v.high < camera_.height_px;
      if (!is_inside) continue;
      const SphereExtent& extent = axis == 0 ? u : v;
      EXPECT_NEAR(extent.low, end_px(BoxSide::kLow), 1e-9);
      EXPECT_NEAR(extent.high, end_px(BoxSide::kHigh), 1e-9);
      EXPECT_TRUE(extent.low < extent.centre && extent.centre < extent.high);
      ++checked;
    }
  }
  EXPECT_GT(checked, 10);
}

INSTANTIATE_TEST_SUITE_P(Drawn, SphereEdges, ::testing::Range(1, 9));

TEST(SphereEdge, IsNoneInsideTheSphereAndNearTheCamerasPlane) {
  const CameraModel camera;
  EXPECT_FALSE(EdgeOfSphere(camera, {0.1, 0.0, 0.5}, 0.6, {.axis = 0, .side = BoxSide::kHigh}));
  EXPECT_FALSE(EdgeOfSphere(camera, {9.0, 0.0, 0.5}, 0.6, {.axis = 0, .side = BoxSide::kHigh}));
}

TEST(SphereExtent, OfASphereAboutTheCameraGoesFarBeyondAnyImage) {
  const CameraModel camera;
  const SphereExtent extent = ExtentOfSphere(camera, {0.1, 0.0, 0.5}, 0.9, 0);
  EXPECT_LT(extent.low, -camera.width_px);
  EXPECT_GT(extent.high, 2.0 * camera.width_px);
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
// Random cameras' views of spheres, with what is uncertain of them.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <Eigen/Core>

#include "estimation/association/box_gate.hpp"
#include "estimation/association/tracked_object.hpp"
#include "estimation/smoothing/camera_point.hpp"
#include "limpet/core/random.hpp"
#include "tests/support/sphere_box.hpp"

namespace limpet {

/// A vehicle anywhere, nearly level.
inline NavVector DrawPose(Random& random) {
  NavVector x;
  x << random.Uniform(-50.0, 50.0), random.Uniform(-50.0, 50.0), random.Uniform(1.0, 20.0),
      random.Uniform(-3.0, 3.0), random.Uniform(-0.15, 0.15), random.Uniform(-0.15, 0.15);
  return x;
}

/// A point well inside the image of a camera that looks down [m].
inline Eigen::Vector3d DrawPointInView(Random& random) {
  const double depth = random.Uniform(2.2, 5.0);
  return {depth * random.Uniform(-0.45, 0.45), depth * random.Uniform(-0.3, 0.3), depth};
}

/// Where a point of the camera's frame is in the world.
inline Eigen::Vector3d InWorld(const CameraModel& camera, const NavVector& x,
                               const Eigen::Vector3d& p_C) {
  const Pose X_WB = PoseOf(x);
  return X_WB.p_WB + RotationOf(X_WB) * (camera.R_BC * p_C + camera.p_BC);
}

/// Positive definite, with about this standard deviation.
template <int n>
Eigen::Matrix<double, n, n> DrawCovariance(Random& random, double sigma) {
  Eigen::Matrix<double, n, n> root;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j)
      root(i, j) = random.Normal(sigma / std::sqrt(1.0 * n));
  }
  return root * root.transpose() + 1e-8 * Eigen::Matrix<double, n, n>::Identity();
}

/// Turns the world about the vertical, then moves it.
struct WorldChange {
  double angle = 0.0;
  Eigen::Vector3d shift_W = Eigen::Vector3d::Zero();

  [[nodiscard]] Eigen::Matrix3d R() const {
    Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
    R.topLeftCorner<2, 2>() << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
    return R;
  }
  [[nodiscard]] Eigen::Vector3d Apply(const Eigen::Vector3d& p_W) const {
    return R() * p_W + shift_W;
  }
  [[nodiscard]] NavVector ApplyToPose(NavVector x) const {
    x.head<3>() = Apply(x.head<3>());
    x(kNavYaw) += angle;
    return x;
  }
  [[nodiscard]] PoseObjectCovariance ApplyToCovariance(const PoseObjectCovariance& P) const {
    PoseObjectCovariance T = PoseObjectCovariance::Identity();
    T.topLeftCorner<3, 3>() = R();
    T.bottomRightCorner<3, 3>() = R();
    return T * P * T.transpose();
  }
};

inline WorldChange DrawWorldChange(Random& random) {
  return {.angle = random.Uniform(-3.1, 3.1),
          .shift_W = {random.Normal(30.0), random.Normal(30.0), random.Normal(5.0)}};
}

/// What the detector sees of a sphere of half a metre; nothing out of sight.
inline std::optional<Box> BoxFrom(const CameraModel& camera, const NavVector& x,
                                  const Eigen::Vector3d& p_W, const std::string& color = "yellow") {
  std::optional<Box> box = BoxOfSphere(CameraPointOf(camera, x, p_W).p_C, 0.5, camera);
  if (box) box->confidence = 0.85, box->color = color;
  return box;
}

/// One box as a track keeps it.
inline Observation ObservationOf(const Box& box, const CameraModel& camera, int node,
                                 double t = 0.0) {
  Observation one;
  one.frame = one.node = node;
  one.t = t;
  one.reading = ReadBox(box, camera, BoxNoise{});
  one.color = box.color;
  one.confidence = box.confidence;
  return one;
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "estimation/matching/own_covariance.hpp"

#include <algorithm>
#include <limits>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "estimation/matching/frame_offset.hpp"

namespace limpet {
namespace {

constexpr double kUnknownShift = 1e3;     // [m]
constexpr double kUnknownTurn = 3.0;      // [rad]
constexpr double kLeastVariance = 1e-10;  // [m^2] keeps what is exact positive definite

Eigen::Vector3d CommonVariance(const std::vector<ObjectEstimate>& objects) {
  Eigen::Vector3d common = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
  for (const ObjectEstimate& object : objects) {
    common = common.cwiseMin(object.cov_W.diagonal());
  }
  return common;
}

}  // namespace

std::vector<ObjectEstimate> WithOwnCovariance(std::vector<ObjectEstimate> objects) {
  const Eigen::Vector3d common = CommonVariance(objects);
  for (ObjectEstimate& object : objects) {
    const Eigen::Vector3d own = (object.cov_W.diagonal() - common).cwiseMax(0.0);
    object.cov_W = own.asDiagonal();
  }
  return objects;
}

Eigen::MatrixXd JointOfSingles(const std::vector<ObjectEstimate>& objects) {
  const auto n = static_cast<Eigen::Index>(3 * objects.size());
  Eigen::MatrixXd joint(n, n);
  const Eigen::Matrix3d common = CommonVariance(objects).asDiagonal();
  const std::vector<ObjectEstimate> own = WithOwnCovariance(objects);
  for (Eigen::Index i = 0; i < n; i += 3) {
    for (Eigen::Index j = 0; j < n; j += 3) {
      joint.block<3, 3>(i, j) = common;
    }
    joint.block<3, 3>(i, i) += own[static_cast<std::size_t>(i / 3)].cov_W;
  }
  return joint;
}

SplitCovariance SplitFrom(const std::vector<Eigen::Vector3d>& places_W,
                          const Eigen::MatrixXd& joint, const Eigen::Vector2d& pivot_W) {
  const Eigen::Index n = joint.rows();
  const FrameOffset rest{.pivot_W = pivot_W};
  Eigen::MatrixXd J(n, 4);
  for (std::size_t i = 0; i < places_W.size(); ++i) {
    J.middleRows<3>(static_cast<Eigen::Index>(3 * i)) = rest.Jacobian(places_W[i]);
  }
  const Eigen::Vector4d unknown(kUnknownShift, kUnknownShift, kUnknownShift, kUnknownTurn);
  const Eigen::MatrixXd regular = joint + kLeastVariance * Eigen::MatrixXd::Identity(n, n);
  Eigen::Matrix4d information = J.transpose() * regular.llt().solve(J);
  information += unknown.cwiseAbs2().cwiseInverse().asDiagonal();
  const Eigen::Matrix4d frame = information.inverse();
  return {.pivot_W = pivot_W, .frame = frame, .own = regular - J * frame * J.transpose()};
}

}  // namespace limpet

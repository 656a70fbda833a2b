// SPDX-License-Identifier: MIT
// Is a tentative object one that is known already? Decided on its place, from several boxes at
// once: where the pose is unsure, one box alone could be anything.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "estimation/association/object_tracker.hpp"

namespace limpet {
namespace {

constexpr double kPlaceError = 0.1;  // [m] of a tentative object's place, beyond its covariance
constexpr double kReach = 3.0;       // [m]
constexpr double kUnlikely = 16.3;   // squared Mahalanobis distance, three degrees of freedom

}  // namespace

TrackedObject* ObjectTracker::KnownAs(const TrackedObject& tentative, const NavVector& x) {
  const Eigen::MatrixXd pose = smoother_.Covariance({});
  const double reach = kReach + 4.0 * std::sqrt(pose.diagonal().head<2>().maxCoeff());
  // The place moves with the pose and turns with its heading.
  const Eigen::Vector3d arm = tentative.p - x.head<3>();
  Eigen::Matrix<double, 3, 6> J = Eigen::Matrix<double, 3, 6>::Zero();
  J.leftCols<3>().setIdentity();
  J.col(kNavYaw) << -arm.y(), arm.x(), 0.0;
  TrackedObject* best = nullptr;
  double least = -2.0 * std::log(params_.objects_per_m3), second = least;
  for (TrackedObject& object : objects_) {
    const Eigen::Vector3d d = object.p - tentative.p;
    if (!object.is_landmark() || d.norm() > reach) {
      continue;
    }
    const Eigen::MatrixXd joint = smoother_.Covariance({object.slot});
    const Eigen::Matrix3d across = joint.block<3, 6>(6, 0) * J.transpose();
    Eigen::Matrix3d S = joint.block<3, 3>(6, 6) + J * joint.topLeftCorner<6, 6>() * J.transpose() -
                        across - across.transpose() + tentative.covariance;
    S.diagonal().array() += kPlaceError * kPlaceError;
    const double distance2 = d.dot(S.llt().solve(d));
    const double share = object.Color() == tentative.Color()
                             ? 1.0 - params_.gate.confused_class_share
                             : std::pow(params_.gate.confused_class_share, 2);
    const double cost = distance2 + std::log(S.determinant()) +
                        3.0 * std::log(2.0 * std::numbers::pi) - 2.0 * std::log(share);
    if (distance2 > kUnlikely) {
      continue;
    }
    if (cost < least) {
      second = best == nullptr ? second : least;
      least = cost;
      best = &object;
    } else {
      second = std::min(second, cost);
    }
  }
  return best != nullptr && second > least + params_.known_margin ? best : nullptr;
}

void ObjectTracker::Recognise(TrackedObject& landmark, TrackedObject& tentative) {
  for (std::size_t i = 0; i < tentative.looks.size(); ++i) {
    AddTerms(landmark, tentative.looks[i], i == 0);
    landmark.AddLook(std::move(tentative.looks[i]));
  }
  tentative.looks.clear();
  landmark.is_fresh = true;
  landmark.expected += tentative.expected;
  landmark.hits += tentative.hits;
  landmark.last_path = tentative.last_path;
  landmark.far = std::max(landmark.far, tentative.far);
}

}  // namespace limpet

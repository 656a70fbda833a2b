// SPDX-License-Identifier: MIT
#include "estimation/association/frame_associator.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "estimation/matching/assignment.hpp"
#include "estimation/smoothing/camera_point.hpp"

namespace limpet {
namespace {

constexpr double kAmbiguous = 2.0;  // -2 ln of the likelihood ratio that tells two objects apart
constexpr double kSeenAgain = 4.0;  // likewise, that tells a known object at the first box
constexpr double kGuessedRadius = 0.4;   // [m] to expect boxes with when the radius is not known
constexpr double kPoseDriftFloor = 0.1;  // [m] of a tentative object against the pose
constexpr double kTiltVariance = 1e-4;   // [rad^2] of the pose that a tentative object is seen from
constexpr double kPlacedPixels = 25.0;   // 1-sigma of an expectation that is good for any box
constexpr double kReach = 3.0;           // [m] beyond the greatest distance it was seen from

/// Other tracks, free, that a box fits nearly as well as the one that it is assigned to.
int CountRivals(const Eigen::MatrixXd& costs, Eigen::Index row, int track,
                const std::vector<std::optional<int>>& assigned) {
  int rivals = 0;
  for (Eigen::Index j = 0; j < costs.cols(); ++j) {
    const bool is_taken = std::ranges::count(assigned, std::optional(static_cast<int>(j))) > 0;
    const bool is_rival =
        track >= 0 && j != track && !is_taken && costs(row, j) < costs(row, track) + kAmbiguous;
    rivals += is_rival ? 1 : 0;
  }
  return rivals;
}

}  // namespace

std::vector<Association> FrameAssociator::Assign(const Viewpoint& from,
                                                 const std::vector<Candidate>& candidates) const {
  const Eigen::MatrixXd costs = Costs(from, candidates);
  const std::vector<std::optional<int>> assigned = AssignOneToOne(costs, 0.0);
  std::vector<Association> associations(candidates.size());
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const std::optional<int> track = assigned[i];
    if (!track) continue;
    const int rivals = CountRivals(costs, static_cast<Eigen::Index>(i), *track, assigned);
    associations[i] = {
        .kind = rivals > 0 ? Association::Kind::kAmbiguous : Association::Kind::kTrack,
        .track = static_cast<std::size_t>(*track)};
  }
  return associations;
}

double FrameAssociator::Reach() const {
  const Eigen::MatrixXd pose = smoother_.Covariance({});
  return kReach + 4.0 * std::sqrt(pose.diagonal().head<2>().maxCoeff());
}

FrameAssociator::Reachable FrameAssociator::CollectReachable(const NavVector& x) const {
  const double reach = Reach();
  Reachable reachable;
  std::vector<int> slots;
  for (const TrackedObject& object : tracks_.objects) {
    const double distance = (object.p_W - x.head<3>()).norm();
    const bool is_within = distance < object.sightings.max_distance + reach &&
                           tracks_.TakesObservations(object, params_.confirm_within_s);
    reachable.is_reachable.push_back(!object.is_mapped() || is_within);
    if (is_within) slots.push_back(object.slot());
  }
  if (mount_.slots()) slots.insert(slots.end(), mount_.slots()->begin(), mount_.slots()->end());
  reachable.joint = smoother_.Covariance(slots);
  return reachable;
}

Eigen::MatrixXd FrameAssociator::Costs(const Viewpoint& from,
                                       const std::vector<Candidate>& candidates) const {
  const auto rows = static_cast<Eigen::Index>(candidates.size());
  const auto columns = static_cast<Eigen::Index>(tracks_.objects.size());
  Eigen::MatrixXd costs = Eigen::MatrixXd::Constant(rows, columns, kImpossibleCost);
  if (rows == 0 || columns == 0) {
    return costs;
  }
  const Reachable reachable = CollectReachable(from.x);
  const CameraModel camera = mount_.At(from.motion);
  const BoxGate gate(camera, params_.gate);
  const double radius = params_.model.radius_m > 0.0 ? params_.model.radius_m : kGuessedRadius;
  // Per candidate: best of the mapped tracks whose place is known too badly to take a box at once.
  Eigen::VectorXd unplaced = Eigen::VectorXd::Zero(rows);
  int row_in_joint = 6;
  for (Eigen::Index j = 0; j < columns; ++j) {
    const auto index = static_cast<std::size_t>(j);
    const TrackedObject& object = tracks_.objects[index];
    if (!reachable.is_reachable[index]) continue;
    const ExpectedObject expected{
        .p_W = object.p_W,
        .radius = radius * std::exp(object.log_size),
        .color = tracks_.BoxesOf(object).color,
        .covariance = CovarianceWith(object, from.path, reachable.joint, row_in_joint),
        .mount_C =
            MountCovariance(from, object.p_W, reachable.joint,
                            object.is_mapped() ? std::optional(row_in_joint) : std::nullopt)};
    row_in_joint += object.is_mapped() ? 3 : 0;
    for (Eigen::Index i = 0; i < rows; ++i) {
      const ReadDetection& seen = candidates[static_cast<std::size_t>(i)].seen;
      const auto match = gate.Match(seen, from.x, expected);
      if (!match || match->cost >= match->new_cost) continue;
      const double cost = match->cost - match->new_cost;
      const double placed =
          std::max(kPlacedPixels, params_.expected_within_share * std::max(seen.box.w, seen.box.h));
      const bool is_again = object.is_mapped() && IsSeenAgain(object);
      if (object.is_mapped() &&
          (match->spread_px > placed || (is_again && tracks_.is_provisional))) {
        unplaced(i) = std::min(unplaced(i), cost);
      } else if (!is_again || cost < -kSeenAgain) {
        costs(i, j) = cost;
      }
    }
  }
  // Those may still be what a box shows: nothing that was seen long ago takes it before them.
  for (Eigen::Index j = 0; j < columns; ++j) {
    const TrackedObject& object = tracks_.objects[static_cast<std::size_t>(j)];
    if (!object.is_mapped() || !IsSeenAgain(object)) continue;
    for (Eigen::Index i = 0; i < rows; ++i) {
      if (costs(i, j) > unplaced(i) - kAmbiguous) costs(i, j) = kImpossibleCost;
    }
  }
  return costs;
}

Eigen::Matrix3d FrameAssociator::MountCovariance(const Viewpoint& from, const Eigen::Vector3d& p_W,
                                                 const Eigen::MatrixXd& joint,
                                                 std::optional<int> row) const {
  // A tentative object was placed by the same camera a moment ago: it is off by the same.
  if (!mount_.slots() || !row) return Eigen::Matrix3d::Zero();
  const CameraPoint point = CameraPointOf(mount_.At(from.motion), from.x, p_W);
  const CameraErrorJacobians by_errors =
      ErrorJacobiansOf(mount_.camera(), mount_.errors(), from.motion, point.p_C);
  Eigen::Matrix<double, 3, 9> J;
  J << point.J_pose, point.J_landmark;
  Eigen::Matrix<double, 3, 6> J_errors;
  J_errors << by_errors.J_tilt, by_errors.J_shift;
  const Eigen::Index first = joint.rows() - 6;  // they come last
  Eigen::Matrix<double, 9, 6> cross;
  cross << joint.block<6, 6>(0, first), joint.block<3, 6>(*row, first);
  const Eigen::Matrix3d shared = J * cross * J_errors.transpose();
  return J_errors * joint.bottomRightCorner<6, 6>() * J_errors.transpose() + shared +
         shared.transpose();
}

PoseObjectCovariance FrameAssociator::CovarianceWith(const TrackedObject& object, double path,
                                                     const Eigen::MatrixXd& joint, int row) const {
  PoseObjectCovariance covariance = PoseObjectCovariance::Zero();
  if (object.is_mapped()) {
    covariance.topLeftCorner<6, 6>() = joint.topLeftCorner<6, 6>();
    covariance.bottomRightCorner<3, 3>() = joint.block<3, 3>(row, row) + object.MotionCovariance();
    covariance.topRightCorner<6, 3>() = joint.block<6, 3>(0, row);
    covariance.bottomLeftCorner<3, 6>() = joint.block<3, 6>(row, 0);
    return covariance;
  }
  const double drift = kPoseDriftFloor + params_.drift_share * (path - object.sightings.last_path);
  covariance.bottomRightCorner<3, 3>() =
      object.tentative().covariance_W + drift * drift * Eigen::Matrix3d::Identity();
  covariance(kNavPitch, kNavPitch) = covariance(kNavRoll, kNavRoll) = kTiltVariance;
  return covariance;
}

}  // namespace limpet

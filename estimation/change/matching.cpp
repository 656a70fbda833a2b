// SPDX-License-Identifier: MIT
#include "estimation/change/matching.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "estimation/change/assignment.hpp"

namespace limpet {
namespace {

constexpr int kRefinements = 5;

class SessionMatcher {
 public:
  SessionMatcher(const std::vector<PlacedObject>& former, const std::vector<PlacedObject>& now,
                 const MatchingParams& params)
      : former_(WithOwnCovariance(former)),
        now_(WithOwnCovariance(now)),
        params_(params),
        gate_(std::pow(params.gate_sigmas, 2)) {
    for (const PlacedObject& object : former_) {
      pivot_ += object.ned.head<2>() / static_cast<double>(former_.size());
    }
  }

  [[nodiscard]] SessionMatch Solve() const {
    SessionMatch best = Refine(FrameOffset{.pivot = pivot_});
    double best_cost = Cost(best);
    for (const PlacedObject& a : former_) {
      for (const PlacedObject& b : now_) {
        FrameOffset start{.pivot = pivot_};
        start.shift = b.ned.head<2>() - a.ned.head<2>();
        if (start.shift.norm() > params_.gate_sigmas * params_.offset_sigma.value()) {
          continue;
        }
        const SessionMatch candidate = Refine(start);
        const double cost = Cost(candidate);
        if (cost < best_cost - 1e-9) {
          best = candidate;
          best_cost = cost;
        }
      }
    }
    return best;
  }

 private:
  [[nodiscard]] Eigen::Matrix3d PairCovariance(const PlacedObject& a, const PlacedObject& b) const {
    const double floor = 2.0 * std::pow(params_.position_floor.value(), 2);
    return a.cov + b.cov + floor * Eigen::Matrix3d::Identity();
  }

  [[nodiscard]] double Distance(const PlacedObject& a, const PlacedObject& b,
                                const FrameOffset& offset) const {
    const Eigen::Vector3d error = b.ned - offset.Apply(a.ned);
    const double color = a.color == b.color ? 0.0 : params_.color_penalty;
    return error.dot(PairCovariance(a, b).inverse() * error) + color;
  }

  [[nodiscard]] std::vector<int> Assign(const FrameOffset& offset) const {
    std::vector<std::vector<double>> cost(former_.size(), std::vector<double>(now_.size()));
    for (std::size_t i = 0; i < former_.size(); ++i) {
      for (std::size_t j = 0; j < now_.size(); ++j) {
        cost[i][j] = Distance(former_[i], now_[j], offset);
      }
    }
    return AssignOneToOne(cost, gate_);
  }

  [[nodiscard]] SessionMatch Refine(FrameOffset offset) const {
    SessionMatch match{.now_of_former = Assign(offset), .offset = offset, .shift_cov = {}};
    for (int i = 0; i < kRefinements; ++i) {
      FitOffset(match);
      std::vector<int> again = Assign(match.offset);
      if (again == match.now_of_former) {
        break;
      }
      match.now_of_former = std::move(again);
    }
    FitOffset(match);
    return match;
  }

  /// Least squares for (north, east, turn) with the priors; linear in the turn, which is small.
  void FitOffset(SessionMatch& match) const {
    const double shift_weight = 1.0 / std::pow(params_.offset_sigma.value(), 2);
    const double turn_weight = 1.0 / std::pow(params_.turn_sigma.value(), 2);
    Eigen::Matrix3d information =
        Eigen::Vector3d(shift_weight, shift_weight, turn_weight).asDiagonal();
    Eigen::Vector3d vector = Eigen::Vector3d::Zero();
    const auto matches = std::ranges::count_if(match.now_of_former, [](int j) { return j >= 0; });
    for (std::size_t i = 0; i < former_.size(); ++i) {
      const int j = match.now_of_former[i];
      if (j < 0) continue;
      const PlacedObject& a = former_[i];
      const PlacedObject& b = now_[static_cast<std::size_t>(j)];
      const Eigen::Vector2d arm = a.ned.head<2>() - pivot_;
      Eigen::Matrix<double, 2, 3> J;
      J << 1.0, 0.0, -arm.y(), 0.0, 1.0, arm.x();
      if (matches < 2) {
        J.col(2).setZero();  // one match cannot tell a turn from a shift
      }
      const Eigen::Matrix2d weight = PairCovariance(a, b).topLeftCorner<2, 2>().inverse();
      information += J.transpose() * weight * J;
      vector += J.transpose() * weight * (b.ned - a.ned).head<2>();
    }
    const Eigen::Matrix3d covariance = information.inverse();
    const Eigen::Vector3d solution = covariance * vector;
    match.offset = {.shift = solution.head<2>(), .turn = solution(2), .pivot = pivot_};
    match.shift_cov = covariance.topLeftCorner<2, 2>();
  }

  /// What a match explains less what the offset costs; lower is better.
  [[nodiscard]] double Cost(const SessionMatch& match) const {
    const FrameOffset& offset = match.offset;
    double cost = offset.shift.squaredNorm() / std::pow(params_.offset_sigma.value(), 2) +
                  std::pow(offset.turn / params_.turn_sigma.value(), 2);
    for (std::size_t i = 0; i < former_.size(); ++i) {
      const int j = match.now_of_former[i];
      cost += j < 0 ? gate_ : Distance(former_[i], now_[static_cast<std::size_t>(j)], offset);
    }
    return cost;
  }

  std::vector<PlacedObject> former_;
  std::vector<PlacedObject> now_;
  const MatchingParams& params_;
  double gate_;
  Eigen::Vector2d pivot_ = Eigen::Vector2d::Zero();
};

}  // namespace

std::vector<PlacedObject> WithOwnCovariance(std::vector<PlacedObject> objects) {
  Eigen::Vector3d common = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
  for (const PlacedObject& object : objects) {
    common = common.cwiseMin(object.cov.diagonal());
  }
  for (PlacedObject& object : objects) {
    const Eigen::Vector3d own = (object.cov.diagonal() - common).cwiseMax(0.0);
    object.cov = own.asDiagonal();
  }
  return objects;
}

Eigen::Vector3d FrameOffset::Apply(const Eigen::Vector3d& former) const {
  const Eigen::Vector2d moved =
      pivot + Eigen::Rotation2Dd(turn) * (former.head<2>() - pivot) + shift;
  return {moved.x(), moved.y(), former.z()};
}

Eigen::Vector3d FrameOffset::Undo(const Eigen::Vector3d& now) const {
  const Eigen::Vector2d moved = pivot + Eigen::Rotation2Dd(-turn) * (now.head<2>() - pivot - shift);
  return {moved.x(), moved.y(), now.z()};
}

SessionMatch MatchSessions(const std::vector<PlacedObject>& former,
                           const std::vector<PlacedObject>& now, const MatchingParams& params) {
  return SessionMatcher(former, now, params).Solve();
}

}  // namespace limpet

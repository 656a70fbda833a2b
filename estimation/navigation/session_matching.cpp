// SPDX-License-Identifier: MIT
#include "estimation/navigation/session_matching.hpp"

#include <Eigen/Cholesky>

#include "estimation/association/assignment.hpp"

namespace limpet {
namespace {

struct Matching {
  std::vector<int> former_of;  ///< index, or -1
  double cost = 0.0;           ///< the less, the more and the better the matches
};

/// Covariance of the difference between a former and a present object once the offset is known.
Eigen::Matrix3d DifferenceCovariance(const FormerObject& a, const PresentObject& b,
                                     const SessionMatchingParams& params) {
  // The heading between the frames turns objects about the start, which is near.
  const double swing = params.heading_sigma.value() * a.p.head<2>().norm();
  const double place = params.place_sigma.value();
  Eigen::Matrix3d S = place * place * Eigen::Matrix3d::Identity();
  S.topLeftCorner<2, 2>() += swing * swing * Eigen::Matrix2d::Identity();
  // A session's covariance is mostly its own offset, which is common to its objects; what is left
  // for one object is taken as a quarter.
  return S + 0.25 * (a.covariance + b.covariance);
}

Eigen::Matrix3d OffsetInformation(const SessionMatchingParams& params) {
  const double xy = params.offset_sigma.value(), z = params.offset_sigma_down.value();
  return Eigen::Vector3d(1.0 / (xy * xy), 1.0 / (xy * xy), 1.0 / (z * z)).asDiagonal();
}

Matching MatchUnder(const Eigen::Vector3d& offset, const std::vector<FormerObject>& former,
                    const std::vector<PresentObject>& present,
                    const SessionMatchingParams& params) {
  const auto rows = static_cast<Eigen::Index>(present.size());
  const auto columns = static_cast<Eigen::Index>(former.size());
  Eigen::MatrixXd costs(rows, columns);
  for (Eigen::Index i = 0; i < rows; ++i) {
    for (Eigen::Index j = 0; j < columns; ++j) {
      const PresentObject& b = present[static_cast<std::size_t>(i)];
      const FormerObject& a = former[static_cast<std::size_t>(j)];
      const Eigen::Vector3d d = b.p - a.p - offset;
      constexpr double kOtherColor = 6.0;
      costs(i, j) = d.dot(DifferenceCovariance(a, b, params).llt().solve(d)) +
                    (a.color == b.color ? 0.0 : kOtherColor);
    }
  }
  Matching matching{.former_of = AssignOneToOne(costs, params.chi2_gate),
                    .cost = offset.dot(OffsetInformation(params) * offset)};
  for (Eigen::Index i = 0; i < rows; ++i) {
    const int j = matching.former_of[static_cast<std::size_t>(i)];
    matching.cost += j < 0 ? params.chi2_gate : costs(i, j);
  }
  return matching;
}

/// Least-squares offset of a matching, with its prior.
Eigen::Vector3d OffsetOf(const Matching& matching, const std::vector<FormerObject>& former,
                         const std::vector<PresentObject>& present,
                         const SessionMatchingParams& params) {
  Eigen::Matrix3d H = OffsetInformation(params);
  Eigen::Vector3d g = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < present.size(); ++i) {
    if (matching.former_of[i] < 0) {
      continue;
    }
    const FormerObject& a = former[static_cast<std::size_t>(matching.former_of[i])];
    const Eigen::LLT<Eigen::Matrix3d> S(DifferenceCovariance(a, present[i], params));
    H += S.solve(Eigen::Matrix3d::Identity());
    g += S.solve(present[i].p - a.p);
  }
  return H.llt().solve(g);
}

}  // namespace

std::vector<int> MatchSessions(const std::vector<FormerObject>& former,
                               const std::vector<PresentObject>& present,
                               const SessionMatchingParams& params) {
  // Every single pair proposes the offset that it would mean.
  Matching best = MatchUnder(Eigen::Vector3d::Zero(), former, present, params);
  for (std::size_t i = 0; i < present.size(); ++i) {
    for (std::size_t j = 0; j < former.size(); ++j) {
      Matching single{.former_of = std::vector<int>(present.size(), -1)};
      single.former_of[i] = static_cast<int>(j);
      Eigen::Vector3d offset = OffsetOf(single, former, present, params);
      Matching matching = MatchUnder(offset, former, present, params);
      offset = OffsetOf(matching, former, present, params);
      matching = MatchUnder(offset, former, present, params);
      if (matching.cost < best.cost) {
        best = std::move(matching);
      }
    }
  }
  for (int& index : best.former_of) {
    index = index < 0 ? -1 : former[static_cast<std::size_t>(index)].id;
  }
  return best.former_of;
}

}  // namespace limpet

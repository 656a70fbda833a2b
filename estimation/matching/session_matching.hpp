// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "estimation/matching/frame_offset.hpp"
#include "limpet/core/params.hpp"
#include "limpet/core/units.hpp"
#include "limpet/objects/object_estimate.hpp"

namespace limpet {

struct MatchingParams {
  /// Prior of each component of the shift: each session has fixes of its own, with a slow error.
  Meters offset_sigma{0.8};
  Meters datum_sigma{0.0};  ///< prior of a shift that no session's fixes show
  Radians datum_turn_sigma{0.0};
  Meters down_sigma{0.3};  ///< prior of what all depths have in common: tide, sensor
  Radians turn_sigma = Radians::FromTextUnit(1.0);
  Meters position_floor{
      0.15};                 ///< added to each object's own covariance: what a filter does not know
  Meters moved_within{2.5};  ///< farther off it is another object
  double gate_sigmas = 3.0;
  /// Squared sigmas that another colour costs: -2 ln of how much likelier two colours are of one
  /// object than of two, where 0.03 of the sessions name an object's colour wrong.
  double color_penalty = 4.3;

  /// What their colours cost when the two are taken for one object [squared sigmas].
  [[nodiscard]] double ColorCost(const ObjectEstimate& a, const ObjectEstimate& b) const {
    return a.color == b.color ? 0.0 : color_penalty;
  }
  /// Of how far apart two places are if they are one, before what the frames' offset leaves open:
  /// both objects' own and what neither filter knows [m^2].
  [[nodiscard]] Eigen::Matrix3d PairCovariance(const ObjectEstimate& a,
                                               const ObjectEstimate& b) const {
    const double floor = 2.0 * position_floor.value() * position_floor.value();
    return a.cov_W + b.cov_W + floor * Eigen::Matrix3d::Identity();
  }

  template <class V>
  void Describe(V& visit) {
    using namespace literals;
    DescribeForGivenMatches(visit);
    visit("match_gate_sigmas", gate_sigmas, "Farther than this is another object",
          InRange(1.0, 10.0));
    visit("match_color_penalty", color_penalty, "Squared sigmas that another colour costs",
          InRange(0.0, 100.0));
  }
  /// What is needed where matches are given: how the frames may lie, and how far objects move.
  template <class V>
  void DescribeForGivenMatches(V& visit) {
    using namespace literals;
    visit("session_offset_sigma_m", offset_sigma,
          "Deviation of the shift between two sessions' frames, per axis", InRange(0.01_m, 50.0_m));
    visit("session_datum_sigma_m", datum_sigma,
          "Deviation of that shift beyond what GPS explains, e.g. another datum",
          InRange(0.0_m, 1000.0_m));
    visit("session_datum_turn_sigma_deg", datum_turn_sigma,
          "Deviation of the turn between the frames beyond what the compass explains",
          InRange(0.0_deg, 180.0_deg));
    visit("session_down_sigma_m", down_sigma,
          "Deviation of the depths between two sessions: tide, pressure", InRange(0.001_m, 50.0_m));
    visit("session_turn_sigma_deg", turn_sigma,
          "Deviation of the turn between two sessions' frames", InRange(0.01_deg, 45.0_deg));
    visit("match_position_floor_m", position_floor, "Deviation added to every object's position",
          InRange(0.0_m, 5.0_m));
    visit("moved_within_m", moved_within,
          "A removed and a new object of one colour closer than this have moved",
          InRange(0.0_m, 50.0_m));
  }
};

/// Information of (north, east, down, turn) before any match, from the parameters alone.
[[nodiscard]] Eigen::Matrix4d OffsetPrior(const MatchingParams& params);

/// For each former object the index of this session's object, if one is matched with it.
using FormerMatches = std::vector<std::optional<int>>;

struct SessionMatch {
  FormerMatches now_of_former{};
  FrameOffset offset{};
  /// Covariance of the offset's (north, east, down, turn), given the matches.
  Eigen::Matrix4d offset_cov = Eigen::Matrix4d::Zero();
  /// Chance of each former and present object that they are one: over the best assignment and its
  /// rivals, the best ones of as many matches that do without one of its pairs.
  Eigen::MatrixXd chance{};
};

/// Matches two sessions' objects one-to-one by Mahalanobis distance with both covariances, and
/// estimates the frames' offset from all matches: the shift always, the turn from two matches on.
/// Every pair, alone and with a neighbour, proposes a start, so that one wrong neighbour cannot
/// lead the rest astray, and a frame that lies metres off or is turned by many degrees is found if
/// the priors allow it. Each object's covariance is its own, without what is common to its session:
/// own_covariance.hpp. `prior`: information of the offset (north, east, down, turn).
[[nodiscard]] SessionMatch MatchSessions(const std::vector<ObjectEstimate>& former,
                                         const std::vector<ObjectEstimate>& now,
                                         const MatchingParams& params,
                                         const Eigen::Matrix4d& prior);
[[nodiscard]] inline SessionMatch MatchSessions(const std::vector<ObjectEstimate>& former,
                                                const std::vector<ObjectEstimate>& now,
                                                const MatchingParams& params) {
  return MatchSessions(former, now, params, OffsetPrior(params));
}

/// The frames' offset from matches that somebody else has decided; `now_of_former` as in
/// SessionMatch, `prior` as in MatchSessions. `chance` stays empty.
[[nodiscard]] SessionMatch FitSessions(const std::vector<ObjectEstimate>& former,
                                       const std::vector<ObjectEstimate>& now,
                                       FormerMatches now_of_former, const MatchingParams& params,
                                       const Eigen::Matrix4d& prior);
[[nodiscard]] inline SessionMatch FitSessions(const std::vector<ObjectEstimate>& former,
                                              const std::vector<ObjectEstimate>& now,
                                              FormerMatches now_of_former,
                                              const MatchingParams& params) {
  return FitSessions(former, now, std::move(now_of_former), params, OffsetPrior(params));
}

}  // namespace limpet

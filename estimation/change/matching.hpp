// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "limpet/core/params.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

/// An object of one session in that session's frame, NED.
struct PlacedObject {
  Eigen::Vector3d ned = Eigen::Vector3d::Zero();
  Eigen::Matrix3d cov = Eigen::Matrix3d::Identity();
  std::string color;
};

/// The part of each object's covariance that is its own. Most of a session's error is common to all
/// its objects (GPS at the start) and is the frame's offset, not the object's; what is common is
/// judged by the best known object.
[[nodiscard]] std::vector<PlacedObject> WithOwnCovariance(std::vector<PlacedObject> objects);

/// Takes a point of the former session's frame to this session's: a turn about `pivot`, then a
/// shift. What GPS and the first heading leave between two sessions.
struct FrameOffset {
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();  ///< north, east [m]
  double turn = 0.0;                                ///< [rad]
  Eigen::Vector2d pivot = Eigen::Vector2d::Zero();  ///< mean of the former objects
  [[nodiscard]] Eigen::Vector3d Apply(const Eigen::Vector3d& former) const;
  [[nodiscard]] Eigen::Vector3d Undo(const Eigen::Vector3d& now) const;
};

struct MatchingParams {
  Meters offset_sigma{0.6};  ///< prior of each component of the shift
  Radians turn_sigma = Radians::FromTextUnit(1.0);
  Meters position_floor{
      0.15};  ///< added to each object's own covariance: what a filter does not know
  double gate_sigmas = 3.0;
  double color_penalty = 30.0;  ///< squared sigmas that another colour costs; beyond the gate

  template <class V>
  void Describe(V& visit) {
    using namespace literals;
    visit("session_offset_sigma_m", offset_sigma,
          "Deviation of the shift between two sessions' frames", InRange(0.01_m, 50.0_m));
    visit("session_turn_sigma_deg", turn_sigma,
          "Deviation of the turn between two sessions' frames", InRange(0.01_deg, 45.0_deg));
    visit("match_position_floor_m", position_floor, "Deviation added to every object's position",
          InRange(0.0_m, 5.0_m));
    visit("match_gate_sigmas", gate_sigmas, "Farther than this is another object",
          InRange(1.0, 10.0));
    visit("match_color_penalty", color_penalty, "Squared sigmas that another colour costs",
          InRange(0.0, 100.0));
  }
};

struct SessionMatch {
  std::vector<int> now_of_former;  ///< per former object, index of this session's object or -1
  FrameOffset offset;
  Eigen::Matrix2d shift_cov = Eigen::Matrix2d::Zero();  ///< of the shift, given the matches
};

/// Matches two sessions' objects one-to-one by Mahalanobis distance with both covariances, and
/// estimates the frames' offset from all matches: the shift always, the turn from two matches on.
/// Every single pair is tried as a start, so that one wrong neighbour cannot lead the rest astray.
[[nodiscard]] SessionMatch MatchSessions(const std::vector<PlacedObject>& former,
                                         const std::vector<PlacedObject>& now,
                                         const MatchingParams& params);

}  // namespace limpet

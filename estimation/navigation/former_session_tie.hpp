// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "estimation/matching/session_matching.hpp"
#include "estimation/smoothing/joint_prior.hpp"
#include "limpet/objects/former_session.hpp"

namespace limpet {

/// This session's landmarks, as the smoother has them.
struct PresentLandmarks {
  std::vector<int> slots;
  std::vector<ObjectEstimate> objects;
  Eigen::MatrixXd covariance;  ///< joint, in W, three rows per landmark [m^2]
  std::size_t others = 0;      ///< so many of the last are covered by the prior that is applied,
                               ///< and are not to be matched
};

/// Recognises the former session's objects among the present landmarks, and says what it then
/// tells about their places. Where the former session's frame lies in this one (a shift, a turn, a
/// depth) is estimated from the matches alone, weighed against what both sessions know of their
/// frames; objects that went, came or moved have no part in it. Where that finds too little, the
/// frame is looked for in the whole neighbourhood, at any shift and turn: then the former session
/// tells how its objects lie among each other, and nothing of where.
class FormerSessionTie {
 public:
  explicit FormerSessionTie(const MatchingParams& params) : params_(params) {}

  /// REQUIRES: the joint covariance has three rows per object, or none.
  void SetFormer(FormerSession former);
  [[nodiscard]] bool has_former() const { return !given_.objects.empty(); }

  /// Matches anew. `applied` is the prior that the landmarks already contain: it is taken out
  /// first, so that a match never proves itself. False if nothing can be said now.
  bool Match(const PresentLandmarks& present, const std::optional<JointPrior>& applied);

  /// Identities of the present landmarks of the last Match, in their order.
  [[nodiscard]] const std::vector<FormerIdentity>& identities() const { return identities_; }
  /// Offset of the former session's frame in this one, from the last Match.
  [[nodiscard]] FrameOffset offset() const { return Together(placed_, offset_); }
  /// The former session's frame lies where neither its fixes nor its compass would have it.
  [[nodiscard]] bool is_elsewhere() const { return is_elsewhere_; }
  /// Over the landmarks whose match is decided; nothing with less than two of them: one alone could
  /// be a mistake, and nothing would show it.
  [[nodiscard]] const std::optional<JointPrior>& prior() const { return prior_; }

 private:
  struct Pair {
    std::size_t former, now;
  };
  /// Sets `identities_`; the pairs that are decided. `placed`: indices of the landmarks that took
  /// part in the match; `same_place`: ChancesOfSamePlace.
  std::vector<Pair> Decide(const PresentLandmarks& present, const SessionMatch& match,
                           const std::vector<std::size_t>& placed,
                           const std::vector<double>& same_place);
  /// Takes the former session's places to where `placed` has its frame.
  void Place(const FrameOffset& placed);
  /// The match under the frame as it is placed, or under one that is found elsewhere.
  [[nodiscard]] SessionMatch MatchOrSearch(const std::vector<ObjectEstimate>& candidates,
                                           const Eigen::Matrix4d& now_frame);
  /// The match under the frame as it is placed, by fixes that are as good as they say or, if that
  /// explains much more, worse; sets `frame_spread_`.
  [[nodiscard]] SessionMatch MatchAsPlaced(const std::vector<ObjectEstimate>& candidates,
                                           const Eigen::Matrix4d& now_frame);
  [[nodiscard]] double EvidenceOf(const SessionMatch& match,
                                  const std::vector<ObjectEstimate>& candidates,
                                  const Eigen::Matrix4d& now_frame) const;
  /// Of a place that the former session saw about half of the objects are its own: a few that lie
  /// alike among many that do not are chance.
  [[nodiscard]] bool IsOfThisPlace(const SessionMatch& match,
                                   const std::vector<ObjectEstimate>& candidates,
                                   const Eigen::Matrix4d& now_frame) const;
  /// A search that found nothing is worth another with a tenth more of landmarks, or after a while.
  [[nodiscard]] bool IsTimeToSearch(std::size_t candidates);
  /// Covariance of (north, east, down, turn): what neither session's fixes know of.
  [[nodiscard]] Eigen::Matrix4d DatumCovariance() const;
  /// Information of the offset (north, east, down, turn) before any match.
  [[nodiscard]] Eigen::Matrix4d OffsetInformation(const Eigen::Matrix4d& now_frame) const;
  [[nodiscard]] JointPrior PriorFrom(const std::vector<Pair>& pairs,
                                     const PresentLandmarks& present,
                                     const Eigen::Matrix4d& now_frame,
                                     const Eigen::MatrixXd& now_own);

  MatchingParams params_;
  FormerSession given_;  ///< in its own frame, with a joint covariance
  FrameOffset placed_;   ///< of its frame
  bool is_elsewhere_ = false;
  double frame_spread_ = 1.0;      ///< how much wider fixes are believed to lie than they say
  std::size_t searched_with_ = 0;  ///< candidates of the last search
  std::size_t matches_since_search_ = 0;
  std::vector<ObjectEstimate> former_;  ///< as placed, each one's covariance its own
  Eigen::Matrix4d former_frame_ = Eigen::Matrix4d::Zero();
  Eigen::MatrixXd former_own_;
  std::vector<FormerIdentity> identities_;
  FrameOffset offset_;  ///< of the frame as placed
  std::optional<JointPrior> prior_;
};

}  // namespace limpet

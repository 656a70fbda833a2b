// SPDX-License-Identifier: MIT
#include "estimation/association/confirmation.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "estimation/association/pair_evidence.hpp"
#include "estimation/association/track_placement.hpp"
#include "limpet/core/probability.hpp"

namespace limpet {
namespace {

constexpr double kPlaceError = 0.1;  // [m] of a tentative object's place, beyond its covariance
constexpr double kRecognitionReach = 3.0;  // [m]
constexpr double kGate = 16.3;             // squared Mahalanobis distance, three degrees of freedom
constexpr int kBoxesOfKnown = 2;
/// Boxes that a box in a corner of the image is worth: its two edges tell a place, and place what
/// sways or is no ball beside itself.
constexpr double kCornerWorth = 0.5;
constexpr double kCorrelation = 0.2;  // of what boxes of one pass say
// An object is seen in a share x of the frames that should show it with a density like x^this, what
// is taken for one like (1 - x)^this.
constexpr double kSeenMoreOften = 1.5;
constexpr double kRejected = 10.0;  // -2 ln of a likelihood ratio beyond which it is another object

}  // namespace

Confirmation::Quorum Confirmation::QuorumOfNew() const {
  return {.observations = params_.looks_to_confirm,
          .log_odds = params_.confirm_log_odds,
          .counts_cut_boxes = false};
}

Confirmation::Quorum Confirmation::QuorumOfKnown() const {
  return {.observations = kBoxesOfKnown,
          .log_odds = kBoxesOfKnown * params_.confirm_log_odds / params_.looks_to_confirm,
          .counts_cut_boxes = kBoxesOfKnown < params_.looks_to_confirm};
}

double Confirmation::WorthOf(const BoxReading& reading, const Quorum& quorum) const {
  if (quorum.counts_cut_boxes || !(reading.is_cut_u && reading.is_cut_v)) return 1.0;
  return reading.TellsPlace(params_.model.radius_m) ? kCornerWorth : 0.0;
}

bool Confirmation::HasQuorum(const TrackedObject& object, const Quorum& quorum) const {
  if (object.is_mapped() || object.observations.empty()) {
    return false;
  }
  double recent = 0.0;
  for (const Observation& one : object.observations) {
    if (tracks_.now - one.t <= params_.confirm_within_s) recent += WorthOf(one.reading, quorum);
  }
  return recent >= quorum.observations && LogOddsOf(object) >= quorum.log_odds &&
         object.sightings.hits >= params_.confirm_hit_share * object.sightings.expected &&
         object.tentative().worst_residual <= params_.confirm_residual;
}

double Confirmation::LogOddsOf(const TrackedObject& object) const {
  // What makes a detector take a thing for an object once makes it do so again.
  const auto observations = static_cast<double>(object.observations.size());
  const double more = std::max(observations - params_.looks_to_confirm, 0.0);
  const double alone = 1.0 + kCorrelation * (params_.looks_to_confirm - 1);
  const double missed = std::max(object.sightings.expected - object.sightings.hits, 0);
  const double seldom = kSeenMoreOften * std::log((1.0 + object.sightings.hits) / (1.0 + missed));
  return object.observations.LogOdds() * alone / (alone + kCorrelation * more) +
         std::min(seldom, 0.0);
}

void Confirmation::ConfirmWhatIsDue(const NavVector& x) {
  for (TrackedObject& object : tracks_.objects) {
    const bool is_ripe = HasQuorum(object, QuorumOfNew());
    if (!is_ripe && !HasQuorum(object, QuorumOfKnown())) continue;
    if (!MayHaveDrifted(object, x) && !tracks_.is_provisional) {
      Decide(object, x);
    } else if (is_ripe && IsPlaced(object, params_)) {
      terms_.Map(object, InDoubt{});
    }
  }
  tracks_.EraseEmpty();
}

std::vector<TrackedObject*> Confirmation::LandmarksNear(const Eigen::Vector3d& p_W) {
  const Eigen::MatrixXd pose = smoother_.Covariance({});
  return tracks_.UntiedNear(
      p_W, kRecognitionReach + 4.0 * std::sqrt(pose.diagonal().head<2>().maxCoeff()));
}

Confirmation::PairLikelihood Confirmation::LikelihoodOf(const TrackedObject& tentative,
                                                        const TrackedObject& landmark,
                                                        const NavVector& x) const {
  // The tentative place moves with the pose and turns with its heading.
  const Eigen::Vector3d arm = tentative.p_W - x.head<3>(), d = landmark.p_W - tentative.p_W;
  Eigen::Matrix<double, 3, 6> J = Eigen::Matrix<double, 3, 6>::Zero();
  J.leftCols<3>().setIdentity();
  J.col(kNavYaw) << -arm.y(), arm.x(), 0.0;
  const Eigen::MatrixXd joint = smoother_.Covariance({landmark.slot()});
  const Eigen::Matrix3d across = joint.block<3, 6>(6, 0) * J.transpose();
  Eigen::Matrix3d S = joint.block<3, 3>(6, 6) + J * joint.topLeftCorner<6, 6>() * J.transpose() -
                      across - across.transpose();
  PairLikelihood pair{.drift_sd = std::sqrt(S.topLeftCorner<2, 2>().diagonal().maxCoeff())};
  S += tentative.tentative().covariance_W + landmark.MotionCovariance();
  S.diagonal().array() += kPlaceError * kPlaceError;
  pair.distance2 = d.dot(S.llt().solve(d));
  pair.cost = NormalCost({.distance2 = pair.distance2,
                          .log_determinant = std::log(S.determinant()),
                          .dimensions = 3}) +
              ClassCost(tentative, landmark, params_.gate.confused_class_share) +
              TogetherCost(tentative, landmark);
  return pair;
}

bool Confirmation::MayHaveDrifted(TrackedObject& object, const NavVector& x) {
  bool may_have = false;
  object.drift_sd = 0.0;
  for (const TrackedObject* landmark : LandmarksNear(object.p_W)) {
    const PairLikelihood pair = LikelihoodOf(object, *landmark, x);
    object.drift_sd = std::max(object.drift_sd, pair.drift_sd);
    may_have = may_have || (pair.drift_sd > params_.small_drift_m && pair.distance2 < kGate &&
                            !AreSeenTogether(object, *landmark));
  }
  return may_have;
}

void Confirmation::Decide(TrackedObject& object, const NavVector& x) {
  const double as_new = NewObjectCost(tracks_, params_);
  TrackedObject* known = nullptr;
  double best = kRejected, second = kRejected;
  for (TrackedObject* landmark : LandmarksNear(object.p_W)) {
    const PairLikelihood pair = LikelihoodOf(object, *landmark, x);
    const double cost = pair.cost - as_new;
    if (pair.distance2 > kGate || cost > second || AreSeenTogether(object, *landmark)) continue;
    second = std::min(std::max(cost, best), second);
    if (cost < best) best = cost, known = landmark;
  }
  if (known != nullptr && best < -params_.known_margin && second > best + params_.known_margin) {
    terms_.MergeTentative(object, *known);
  } else if (HasQuorum(object, QuorumOfNew()) && IsPlaced(object, params_)) {
    terms_.Map(object, known != nullptr ? TrackState(InDoubt{}) : TrackState(Confirmed{}));
  }
}

}  // namespace limpet

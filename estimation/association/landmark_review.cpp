// SPDX-License-Identifier: MIT
#include "estimation/association/landmark_review.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "estimation/association/object_motion.hpp"
#include "estimation/association/pair_evidence.hpp"
#include "estimation/association/track_placement.hpp"
#include "estimation/smoothing/factors/reprojection_factor.hpp"
#include "limpet/core/probability.hpp"

namespace limpet {
namespace {

constexpr double kMoved = 0.1;  // [m] after which all observations of a landmark are reviewed again
constexpr double kRecent = 30.0;       // [s] of observations that always are
constexpr double kSplitDriftSd = 0.5;  // [m] of what was taken for another landmark by mistake
constexpr double kModelError = 0.05;   // [m] between two landmarks of one object
constexpr double kWidestMotion = 0.9;  // [m] level, between the places of one that moves
constexpr int kAbsences = 5;           // that make it more than a detector's misses
constexpr double kMoreMotion = 1.3;    // share beyond which a motion is noted anew
constexpr double kOldPlace = 0.5;      // [m] that copies of places may be off one another

}  // namespace

std::vector<Observation> LandmarkReview::TakeOutliers(TrackedObject& object) {
  const Eigen::Vector3d p_W = smoother_.BorderAt(object.slot());
  // Old observations are reviewed again once the object has moved.
  const bool has_moved = !object.review.p_W || (p_W - *object.review.p_W).norm() > kMoved;
  const auto reviewed_up_to =
      has_moved ? std::nullopt : std::optional(object.last_seen() - kRecent);
  if (has_moved) object.review.p_W = p_W;
  return object.observations.TakeIf([&](const Observation& one) {
    if (one.terms.empty() || (reviewed_up_to && one.t < *reviewed_up_to)) {
      return false;
    }
    const CameraModel camera = mount_.At(one.motion);
    const BoxReading reading =
        OfMeanPlace(one.reading, object.motion_sd, camera, params_.model.radius_m);
    const ReprojectionFactor factor(camera, reading.centre_px, reading.sigma_px);
    return factor.Evaluate(smoother_.PoseAt(one.node), p_W).norm() > params_.outlier_sigma;
  });
}

bool LandmarkReview::NoteMotion(TrackedObject& object) {
  const double variance = MotionVariance(object, params_.confirm_within_s, smoother_, mount_);
  return NoteMotion(object, std::sqrt(variance));
}

bool LandmarkReview::NoteMotion(TrackedObject& object, double motion_sd) {
  if (motion_sd <= kMoreMotion * object.motion_sd) return false;
  terms_.NoteMotion(object, motion_sd);
  return true;
}

bool LandmarkReview::RemoveOutliers() {
  bool has_changed = false;
  std::vector<TrackedObject> split;
  for (TrackedObject& object : tracks_.objects) {
    if (!object.is_mapped() || !std::exchange(object.review.is_due, false)) continue;
    has_changed = NoteMotion(object) || has_changed;
    std::vector<Observation> outliers = TakeOutliers(object);
    if (outliers.empty()) continue;
    rejected_ += static_cast<int>(outliers.size());
    SplitOff(std::move(outliers), object, split);
    has_changed = true;
  }
  for (TrackedObject& object : split) {
    tracks_.objects.push_back(std::move(object));
    terms_.Map(tracks_.objects.back(), InDoubt{});
    ++tracks_.identity_news;
  }
  return has_changed;
}

void LandmarkReview::SplitOff(std::vector<Observation> outliers, const TrackedObject& from,
                              std::vector<TrackedObject>& split) {
  for (Observation& one : outliers)
    terms_.RemoveTerms(one);
  for (auto begin = outliers.begin(); begin != outliers.end();) {
    auto end = std::next(begin);
    while (end != outliers.end() && end->t - std::prev(end)->t <= params_.confirm_within_s)
      ++end;
    TrackedObject object;
    for (; begin != end; ++begin)
      object.observations.Add(std::move(*begin));
    if (static_cast<int>(object.observations.size()) < params_.looks_to_confirm) continue;
    Place(object, smoother_, mount_, params_.model);
    const bool agrees = object.tentative().worst_residual <= params_.confirm_residual;
    if (!agrees || !IsPlaced(object, params_)) continue;
    object.sightings = from.sightings;
    object.sightings.CountAgain(object.observations.size());
    object.drift_sd = kSplitDriftSd;
    split.push_back(std::move(object));
  }
}

bool LandmarkReview::AreLikelyOne(const TrackedObject& a, const TrackedObject& b,
                                  const Eigen::Matrix3d& difference_W) const {
  const Eigen::Vector3d d = smoother_.BorderAt(a.slot()) - smoother_.BorderAt(b.slot());
  const double distance2 = d.dot(difference_W.llt().solve(d));
  const double one = NormalCost({.distance2 = distance2,
                                 .log_determinant = std::log(difference_W.determinant()),
                                 .dimensions = 3}) +
                     TogetherCost(a, b) + ClassCost(a, b, params_.gate.confused_class_share);
  return one <
         NewObjectCost(tracks_, params_) + OverlapCost(d, difference_W, params_.model.radius_m);
}

bool LandmarkReview::AreOneThatMoves(const TrackedObject& a, const TrackedObject& b) const {
  return a.color() == b.color() && (a.p_W - b.p_W).head<2>().norm() < kWidestMotion &&
         CountAbsences(a, b, smoother_, mount_) + CountAbsences(b, a, smoother_, mount_) >=
             kAbsences;
}

bool LandmarkReview::DoubtDuplicates() {
  bool has_changed = false;
  for (TrackedObject& a : tracks_.objects) {
    for (TrackedObject& b : tracks_.objects) {
      if (!a.is_landmark() || !b.is_landmark() || a.id() >= b.id()) continue;
      if ((a.p_W - b.p_W).norm() > params_.merge_distance_m + kOldPlace) continue;
      const Eigen::Vector3d d = smoother_.BorderAt(a.slot()) - smoother_.BorderAt(b.slot());
      if (d.norm() > params_.merge_distance_m || AreSeenTogether(a, b)) continue;
      const Eigen::MatrixXd joint = smoother_.Covariance({a.slot(), b.slot()});
      Eigen::Matrix3d S = joint.block<3, 3>(6, 6) + joint.block<3, 3>(9, 9) -
                          joint.block<3, 3>(6, 9) - joint.block<3, 3>(9, 6);
      S.diagonal().array() += kModelError * kModelError;
      S += a.MotionCovariance() + b.MotionCovariance();
      if (!AreLikelyOne(a, b, S)) {
        if (!AreOneThatMoves(a, b)) continue;
        const double motion_sd = std::max(0.5 * d.head<2>().norm(), 0.25 * std::abs(d.z()));
        has_changed = NoteMotion(a, motion_sd) || has_changed;
        has_changed = NoteMotion(b, motion_sd) || has_changed;
        S += a.MotionCovariance() + b.MotionCovariance();
      }
      b.drift_sd = std::sqrt(S.diagonal().head<2>().maxCoeff());
      b.state = InDoubt{};
      ++tracks_.identity_news;
    }
  }
  return has_changed;
}

bool LandmarkReview::DropFalseLandmarks() {
  bool has_changed = false;
  for (TrackedObject& object : tracks_.objects) {
    const bool is_false =
        object.is_untied() && object.sightings.expected >= params_.drop_after_expected &&
        object.sightings.hits < params_.drop_hit_share * object.sightings.expected;
    const bool is_empty = object.is_mapped() && object.observations.empty();
    if (!is_false && !is_empty) continue;
    terms_.Remove(object);
    has_changed = true;
  }
  tracks_.EraseEmpty();
  return has_changed;
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
// The tracker's second thoughts: looks that do not fit, landmarks that are one, landmarks that are
// none.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "estimation/association/object_tracker.hpp"
#include "estimation/association/pair_evidence.hpp"
#include "estimation/smoothing/factors/reprojection_factor.hpp"

namespace limpet {
namespace {

constexpr double kMoved = 0.1;        // [m] after which all looks of a landmark are reviewed again
constexpr double kRecent = 30.0;      // [s] of looks that always are
constexpr double kSplitSpread = 0.5;  // [m] of what was taken for another landmark by mistake
constexpr double kModelError = 0.05;  // [m] between two landmarks of one object, beyond covariance

}  // namespace

bool ObjectTracker::Review() {
  bool has_changed = RemoveOutliers();
  SuspectDuplicates();
  has_changed = Reconsider(false) || has_changed;
  has_changed = ForgetEmptySlots() || has_changed;
  for (TrackedObject& object : objects_) {
    const bool is_false = object.is_known() && object.expected >= params_.drop_after_expected &&
                          object.hits < params_.drop_hit_share * object.expected;
    const bool is_empty = object.is_mapped() && object.looks.empty();
    if (is_false || is_empty) {
      ReleaseTiedTo(object);
      smoother_.RemoveLandmark(object.slot);
      object.looks.clear();
      object.slot = -1;
      has_changed = true;
    }
  }
  std::erase_if(objects_, [](const TrackedObject& object) { return object.looks.empty(); });
  return has_changed;
}

bool ObjectTracker::RemoveOutliers() {
  bool has_changed = false;
  std::vector<TrackedObject> split;
  for (TrackedObject& object : objects_) {
    if (!object.is_mapped() || !std::exchange(object.is_fresh, false)) {
      continue;
    }
    const Eigen::Vector3d p = smoother_.LandmarkAt(object.slot);
    // Old looks are reviewed again once the object has moved.
    const bool has_moved = !object.reviewed_p || (p - *object.reviewed_p).norm() > kMoved;
    const double since = has_moved ? -1e18 : object.last_seen() - kRecent;
    if (has_moved) object.reviewed_p = p;
    const auto does_not_fit = [&](const Look& look) {
      if (look.terms.empty() || look.t < since) {
        return false;
      }
      const ReprojectionFactor factor(camera_, look.reading.centre_px, look.reading.sigma_px);
      return factor.Evaluate(smoother_.PoseAt(look.node), p).norm() > params_.outlier_sigma;
    };
    const auto bad = std::stable_partition(object.looks.begin(), object.looks.end(),
                                           [&](const Look& look) { return !does_not_fit(look); });
    SplitOff({bad, object.looks.end()}, object, split);
    const auto removed = std::distance(bad, object.looks.end());
    object.looks.erase(bad, object.looks.end());
    if (removed > 0) object.RecountColor();
    rejected_looks_ += static_cast<int>(removed);
    has_changed = has_changed || removed > 0;
  }
  for (TrackedObject& object : split) {
    objects_.push_back(std::move(object));
    Adopt(objects_.back(), true);
    ++identity_news_;
  }
  return has_changed;
}

void ObjectTracker::SplitOff(std::vector<Look> looks, const TrackedObject& from,
                             std::vector<TrackedObject>& split) {
  for (Look& look : looks) {
    for (const TermId& term : look.terms)
      smoother_.RemoveTerm(term);
    look.terms.clear();
  }
  for (auto begin = looks.begin(); begin != looks.end();) {
    auto end = std::next(begin);
    while (end != looks.end() && end->t - std::prev(end)->t <= params_.confirm_within_s)
      ++end;
    TrackedObject object;
    for (; begin != end; ++begin)
      object.AddLook(std::move(*begin));
    if (static_cast<int>(object.looks.size()) < params_.looks_to_confirm) continue;
    Retriangulate(object);
    if (object.worst_residual > params_.confirm_residual || !IsPlaced(object)) continue;
    object.expected = object.hits = static_cast<int>(object.looks.size());
    object.far = from.far;
    object.last_path = from.last_path;
    object.spread = kSplitSpread;
    split.push_back(std::move(object));
  }
}

void ObjectTracker::SuspectDuplicates() {
  for (TrackedObject& a : objects_) {
    for (TrackedObject& b : objects_) {
      if (!a.is_landmark() || !b.is_landmark() || a.id >= b.id) {
        continue;
      }
      const Eigen::Vector3d d = smoother_.LandmarkAt(a.slot) - smoother_.LandmarkAt(b.slot);
      if (d.norm() > params_.merge_distance_m) continue;
      const double together = TogetherCost(a, b);
      if (together >= kCertainlyTwo) continue;
      const Eigen::MatrixXd joint = smoother_.Covariance({a.slot, b.slot});
      Eigen::Matrix3d S = joint.block<3, 3>(6, 6) + joint.block<3, 3>(9, 9) -
                          joint.block<3, 3>(6, 9) - joint.block<3, 3>(9, 6);
      S.diagonal().array() += kModelError * kModelError;
      const double one = d.dot(S.llt().solve(d)) + std::log(S.determinant()) +
                         3.0 * std::log(2.0 * std::numbers::pi) + together +
                         ClassCost(a, b, params_.gate.confused_class_share);
      if (one < NewCost() + OverlapCost(d, S, params_.model.radius_m)) {
        b.spread = std::sqrt(S.diagonal().head<2>().maxCoeff());
        b.is_in_doubt = b.is_open = true;
        ++identity_news_;
      }
    }
  }
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
// What is a tentative object that enough boxes agree on: a landmark that is known already, or a new
// one? Decided on its place, from several boxes at once: where the pose is unsure, one box alone
// could be anything.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "estimation/association/object_tracker.hpp"
#include "estimation/association/pair_evidence.hpp"
#include "estimation/smoothing/factors/birthplace_factor.hpp"

namespace limpet {
namespace {

constexpr double kPlaceError = 0.1;  // [m] of a tentative object's place, beyond its covariance
constexpr double kRecognitionReach = 3.0;  // [m]
constexpr double kUnlikely = 16.3;         // squared Mahalanobis distance, three degrees of freedom
constexpr int kBoxesOfKnown = 2;
constexpr double kLikeTheLast = 0.2;  // correlation of what boxes of one sighting say
// An object is seen in a share x of the frames that should show it with a density like x^this, what
// is taken for one like (1 - x)^this.
constexpr double kSeenMoreOften = 1.5;
constexpr double kHardly = 10.0;  // -2 ln of a likelihood ratio: another object, as good as surely

}  // namespace

bool ObjectTracker::AgreeOn(const TrackedObject& object, int boxes, double log_odds,
                            double now) const {
  if (object.is_mapped() || object.looks.empty()) {
    return false;
  }
  const auto recent = std::ranges::count_if(object.looks, [&](const Look& look) {
    // What both borders cut tells no place, but that something is there.
    const bool counts = look.reading.is_usable() || boxes < params_.looks_to_confirm;
    return counts && now - look.t <= params_.confirm_within_s;
  });
  return recent >= boxes && Belief(object) >= log_odds &&
         object.hits >= params_.confirm_hit_share * object.expected &&
         object.worst_residual <= params_.confirm_residual;
}

double ObjectTracker::Belief(const TrackedObject& object) const {
  // What makes a detector take a thing for an object once makes it do so again.
  const auto looks = static_cast<double>(object.looks.size());
  const double more = std::max(looks - params_.looks_to_confirm, 0.0);
  const double alone = 1.0 + kLikeTheLast * (params_.looks_to_confirm - 1);
  const double missed = std::max(object.expected - object.hits, 0);
  const double seldom = kSeenMoreOften * std::log((1.0 + object.hits) / (1.0 + missed));
  return object.LogOdds() * alone / (alone + kLikeTheLast * more) + std::min(seldom, 0.0);
}

void ObjectTracker::ConfirmWhatIsDue(const TrackerFrame& frame) {
  const double now = frame.detections->t;
  for (TrackedObject& object : objects_) {
    // Fewer boxes tell an object that is known and expected there.
    const bool is_ripe = IsRipe(object, now);
    if (!is_ripe &&
        !AgreeOn(object, kBoxesOfKnown,
                 kBoxesOfKnown * params_.confirm_log_odds / params_.looks_to_confirm, now)) {
      continue;
    }
    if (!ShouldWait(object, frame) && !is_provisional_) {
      Settle(object, frame);
    } else if (is_ripe && IsPlaced(object)) {
      Adopt(object, true);
    }
  }
  std::erase_if(objects_, [](const TrackedObject& object) { return object.looks.empty(); });
}

std::vector<TrackedObject*> ObjectTracker::LandmarksNear(const Eigen::Vector3d& p) {
  const Eigen::MatrixXd pose = smoother_.Covariance({});
  const double reach = kRecognitionReach + 4.0 * std::sqrt(pose.diagonal().head<2>().maxCoeff());
  std::vector<TrackedObject*> near;
  for (TrackedObject& object : objects_) {
    if (object.is_known() && (object.p - p).norm() < reach) near.push_back(&object);
  }
  return near;
}

ObjectTracker::Likeness ObjectTracker::LikenessOf(const TrackedObject& tentative,
                                                  const TrackedObject& landmark,
                                                  const NavVector& x) const {
  // The tentative place moves with the pose and turns with its heading.
  const Eigen::Vector3d arm = tentative.p - x.head<3>(), d = landmark.p - tentative.p;
  Eigen::Matrix<double, 3, 6> J = Eigen::Matrix<double, 3, 6>::Zero();
  J.leftCols<3>().setIdentity();
  J.col(kNavYaw) << -arm.y(), arm.x(), 0.0;
  const Eigen::MatrixXd joint = smoother_.Covariance({landmark.slot});
  const Eigen::Matrix3d across = joint.block<3, 6>(6, 0) * J.transpose();
  Eigen::Matrix3d S = joint.block<3, 3>(6, 6) + J * joint.topLeftCorner<6, 6>() * J.transpose() -
                      across - across.transpose();
  Likeness likeness{.spread = std::sqrt(S.topLeftCorner<2, 2>().diagonal().maxCoeff())};
  S += tentative.covariance;
  S.diagonal().array() += kPlaceError * kPlaceError;
  likeness.distance2 = d.dot(S.llt().solve(d));
  likeness.cost = likeness.distance2 + std::log(S.determinant()) +
                  3.0 * std::log(2.0 * std::numbers::pi) +
                  ClassCost(tentative, landmark, params_.gate.confused_class_share) +
                  TogetherCost(tentative, landmark);
  return likeness;
}

bool ObjectTracker::ShouldWait(TrackedObject& object, const TrackerFrame& frame) {
  bool should_wait = false;
  object.spread = 0.0;
  for (const TrackedObject* landmark : LandmarksNear(object.p)) {
    const Likeness likeness = LikenessOf(object, *landmark, frame.x);
    object.spread = std::max(object.spread, likeness.spread);
    should_wait =
        should_wait || (likeness.spread > params_.sure_spread_m && likeness.distance2 < kUnlikely &&
                        !AreSeenTogether(object, *landmark));
  }
  return should_wait;
}

void ObjectTracker::Settle(TrackedObject& object, const TrackerFrame& frame) {
  const double as_new = NewCost();
  TrackedObject* known = nullptr;
  double best = kHardly, second = kHardly;
  for (TrackedObject* landmark : LandmarksNear(object.p)) {
    const Likeness likeness = LikenessOf(object, *landmark, frame.x);
    const double cost = likeness.cost - as_new;
    if (likeness.distance2 > kUnlikely || cost > second || AreSeenTogether(object, *landmark)) {
      continue;
    }
    second = std::min(std::max(cost, best), second);
    if (cost < best) best = cost, known = landmark;
  }
  if (known != nullptr && best < -params_.known_margin && second > best + params_.known_margin) {
    Recognise(*known, object);
  } else if (IsRipe(object, frame.detections->t) && IsPlaced(object)) {
    Adopt(object, known != nullptr);
  }
}

void ObjectTracker::Adopt(TrackedObject& object, bool is_in_doubt) {
  object.is_in_doubt = object.is_open = is_in_doubt;
  object.id = next_id_++;
  object.slot = smoother_.AddLandmark(object.p);
  const int node = object.looks.front().node;
  const BirthplaceFactor hold(object.p - smoother_.PoseAt(node).head<3>(),
                              Meters(params_.place_prior_m));
  smoother_.AddTerm(node, Term::OnSight(hold, object.slot));
  for (std::size_t i = 0; i < object.looks.size(); ++i) {
    AddTerms(object, object.looks[i], i == 0);
  }
}

void ObjectTracker::Recognise(TrackedObject& landmark, TrackedObject& tentative) {
  for (std::size_t i = 0; i < tentative.looks.size(); ++i) {
    AddTerms(landmark, tentative.looks[i], i == 0);
    landmark.AddLook(std::move(tentative.looks[i]));
  }
  tentative.looks.clear();
  landmark.is_fresh = true;
  ++identity_news_;
  landmark.expected += tentative.expected;
  landmark.hits += tentative.hits;
  landmark.last_path = tentative.last_path;
  landmark.far = std::max(landmark.far, tentative.far);
}

}  // namespace limpet

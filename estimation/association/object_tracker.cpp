// SPDX-License-Identifier: MIT
#include "estimation/association/object_tracker.hpp"

#include <algorithm>
#include <cmath>

#include "estimation/matching/assignment.hpp"
#include "estimation/smoothing/camera_point.hpp"
#include "estimation/smoothing/factors/landmark_prior_factor.hpp"

namespace limpet {
namespace {

constexpr double kAmbiguous = 2.0;  // -2 ln of the likelihood ratio that tells two objects apart
constexpr double kGuessedRadius = 0.4;   // [m] to expect boxes with when the radius is not known
constexpr double kPoseDriftFloor = 0.1;  // [m] of a tentative object against the pose
constexpr double kSeenAgain = 4.0;       // the same, that tells a known object at the first box
constexpr double kInTheGround = 1.0;     // [m] of a centre below the seabed where it was seen
constexpr double kSurePixels = 25.0;     // an expectation within which is sure, whatever the box
constexpr double kReach = 3.0;           // [m] beyond the greatest distance it was seen from
constexpr double kSlack = 0.5;           // [m] the same, within which it should be seen
constexpr double kMarginShare = 0.12;    // of the image, inside which an object should be seen

}  // namespace

ObjectTracker::ObjectTracker(Smoother& smoother, const CameraModel& camera,
                             const ObjectTrackerParams& params)
    : smoother_(smoother), camera_(camera), params_(params) {}

bool ObjectTracker::IsUsable(const BoxDetection& box) const {
  return box.confidence >= params_.min_confidence && box.w > 1.0 && box.h > 1.0;
}

std::vector<int> ObjectTracker::Process(const TrackerFrame& frame) {
  const std::vector<BoxDetection>& boxes = frame.detections->boxes;
  std::vector<int> shown(boxes.size(), -1);
  std::vector<int> seen;
  std::vector<Candidate> candidates;
  for (int i = 0; frame.node >= 0 && i < static_cast<int>(boxes.size()); ++i) {
    const BoxDetection& box = boxes[static_cast<std::size_t>(i)];
    if (IsUsable(box)) {
      candidates.push_back({i, ReadBox(box, camera_, params_.model.noise)});
    }
  }
  now_ = frame.detections->t;
  DropStale(now_);
  const std::size_t known = objects_.size();
  const Eigen::MatrixXd costs = Costs(frame, candidates);
  const std::vector<int> assigned = AssignOneToOne(costs, 0.0);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const int object = assigned[i];
    int rivals = 0;
    for (Eigen::Index j = 0; j < costs.cols(); ++j) {
      const bool is_taken = std::ranges::count(assigned, static_cast<int>(j)) > 0;
      rivals += object >= 0 && j != object && !is_taken &&
                costs(row, j) < costs(row, object) + kAmbiguous;
    }
    if (rivals > 0) {
      continue;  // it may show either: left out rather than guessed
    }
    const auto index = static_cast<std::size_t>(candidates[i].detection);
    Look look{.frame = frame.detections->frame,
              .detection = candidates[i].detection,
              .node = frame.node,
              .t = frame.detections->t,
              .reading = candidates[i].reading,
              .color = boxes[index].color,
              .confidence = boxes[index].confidence,
              .altitude = frame.altitude,
              .terms = {}};
    if (object >= 0) {
      seen.push_back(object);
      TrackedObject& shows = objects_[static_cast<std::size_t>(object)];
      AddLook(shows, std::move(look), frame);
      shown[index] = NameOf(shows);
    } else if (look.reading.is_usable()) {
      Start(std::move(look), frame);
    }
  }
  for (std::size_t j = known; j < objects_.size(); ++j) {
    seen.push_back(static_cast<int>(j));
  }
  CountVisibility(frame, seen);
  ConfirmWhatIsDue(frame);
  return shown;
}

Eigen::MatrixXd ObjectTracker::Costs(const TrackerFrame& frame,
                                     const std::vector<Candidate>& candidates) const {
  const auto rows = static_cast<Eigen::Index>(candidates.size());
  const auto columns = static_cast<Eigen::Index>(objects_.size());
  Eigen::MatrixXd costs = Eigen::MatrixXd::Constant(rows, columns, kImpossibleCost);
  if (rows == 0 || columns == 0) {
    return costs;
  }
  // Landmarks that no error of the pose could bring into view are left out.
  const Eigen::MatrixXd pose = smoother_.Covariance({});
  const double reach = kReach + 4.0 * std::sqrt(pose.diagonal().head<2>().maxCoeff());
  std::vector<int> slots;
  std::vector<bool> is_near;
  for (const TrackedObject& object : objects_) {
    const double distance = (object.p - frame.x.head<3>()).norm();
    const bool is_within = distance < object.far + reach && TakesLooks(object);
    is_near.push_back(!object.is_mapped() || is_within);
    if (is_within) slots.push_back(object.slot);
  }
  const Eigen::MatrixXd joint = smoother_.Covariance(slots);
  const double radius = params_.model.radius_m > 0.0 ? params_.model.radius_m : kGuessedRadius;
  Eigen::VectorXd unsure = Eigen::VectorXd::Zero(rows);  // best of landmarks not placed well enough
  int row_in_joint = 6;
  for (Eigen::Index j = 0; j < columns; ++j) {
    const TrackedObject& object = objects_[static_cast<std::size_t>(j)];
    if (!is_near[static_cast<std::size_t>(j)]) continue;
    const SightCovariance covariance = CovarianceWith(object, frame.path, joint, row_in_joint);
    row_in_joint += object.is_mapped() ? 3 : 0;
    for (Eigen::Index i = 0; i < rows; ++i) {
      const Candidate& candidate = candidates[static_cast<std::size_t>(i)];
      const BoxDetection& box =
          frame.detections->boxes[static_cast<std::size_t>(candidate.detection)];
      const auto match = MatchBox(box, candidate.reading, frame.x, object.p, covariance, radius,
                                  object.Color() == box.color, camera_, params_.gate);
      if (!match || match->cost >= match->new_cost) continue;
      // Costs are against being something new, so that zero divides.
      const double cost = match->cost - match->new_cost;
      const double sure = std::max(kSurePixels, params_.sure_share * std::max(box.w, box.h));
      const bool is_again = object.is_mapped() && IsSeenAgain(object);
      if (object.is_mapped() && (match->spread_px > sure || (is_again && is_provisional_))) {
        unsure(i) = std::min(unsure(i), cost);
      } else if (!is_again || cost < -kSeenAgain) {
        costs(i, j) = cost;
      }
    }
  }
  // A landmark whose place is known too badly to take the box at once may still be what it shows.
  for (Eigen::Index j = 0; j < columns; ++j) {
    const TrackedObject& object = objects_[static_cast<std::size_t>(j)];
    if (!object.is_mapped() || !IsSeenAgain(object)) continue;
    for (Eigen::Index i = 0; i < rows; ++i) {
      if (costs(i, j) > unsure(i) - kAmbiguous) costs(i, j) = kImpossibleCost;
    }
  }
  return costs;
}

bool ObjectTracker::TakesLooks(const TrackedObject& object) const {
  // What is tied still takes the looks of its own sighting, so that they come away with it.
  const auto is_going_on = [this](const TrackedObject& tied) {
    return tied.same_as >= 0 && tied.is_mapped() &&
           now_ - tied.last_seen() <= params_.confirm_within_s;
  };
  if (object.same_as >= 0) return is_going_on(object);
  return object.is_mapped() && std::ranges::none_of(objects_, [&](const TrackedObject& other) {
           return other.same_as == object.id && is_going_on(other);
         });
}

SightCovariance ObjectTracker::CovarianceWith(const TrackedObject& object, double path,
                                              const Eigen::MatrixXd& joint, int row) const {
  SightCovariance covariance = SightCovariance::Zero();
  if (object.is_mapped()) {
    covariance.topLeftCorner<6, 6>() = joint.topLeftCorner<6, 6>();
    covariance.bottomRightCorner<3, 3>() = joint.block<3, 3>(row, row);
    covariance.topRightCorner<6, 3>() = joint.block<6, 3>(0, row);
    covariance.bottomLeftCorner<3, 6>() = joint.block<3, 6>(row, 0);
    return covariance;
  }
  const double drift = kPoseDriftFloor + params_.drift_share * (path - object.last_path);
  covariance.bottomRightCorner<3, 3>() =
      object.covariance + drift * drift * Eigen::Matrix3d::Identity();
  covariance(kNavPitch, kNavPitch) = covariance(kNavRoll, kNavRoll) = 1e-4;
  return covariance;
}

void ObjectTracker::CountVisibility(const TrackerFrame& frame, const std::vector<int>& seen) {
  for (std::size_t j = 0; j < objects_.size(); ++j) {
    TrackedObject& object = objects_[j];
    if (object.is_mapped() && !TakesLooks(object)) continue;
    if (std::ranges::count(seen, static_cast<int>(j)) > 0) {
      ++object.expected;
      ++object.hits;
      continue;
    }
    const double reach = object.far + kSlack + camera_.p_BC.norm();
    if ((object.p - frame.x.head<3>()).squaredNorm() > reach * reach) {
      continue;  // most of them, most of the time
    }
    const Eigen::Vector3d p = CameraPointOf(camera_, frame.x, object.p).p_C;
    if (p.z() < 0.5 || p.norm() > object.far + kSlack) {
      continue;
    }
    // What is in doubt may be this one.
    const auto may_be_it = [&](int k) {
      const TrackedObject& other = objects_[static_cast<std::size_t>(k)];
      return other.is_open && (other.p - object.p).norm() < params_.merge_distance_m;
    };
    if (object.is_mapped() && std::ranges::any_of(seen, may_be_it)) {
      continue;
    }
    const double u = (camera_.cx + camera_.fx * p.x() / p.z()) / camera_.width_px;
    const double v = (camera_.cy + camera_.fy * p.y() / p.z()) / camera_.height_px;
    object.expected += std::min({u, 1.0 - u, v, 1.0 - v}) > kMarginShare ? 1 : 0;
  }
}

void ObjectTracker::AddLook(TrackedObject& object, Look look, const TrackerFrame& frame) {
  const bool is_new_pass = look.t - object.last_seen() > params_.confirm_within_s;
  object.last_path = frame.path;
  object.far = std::max(object.far, CameraPointOf(camera_, frame.x, object.p).p_C.norm());
  object.is_fresh = true;
  object.AddLook(std::move(look));
  if (object.is_mapped()) {
    AddTerms(object, object.looks.back(), is_new_pass);
    identity_news_ += is_new_pass ? 1 : 0;
  } else {
    Retriangulate(object);
  }
}

void ObjectTracker::Start(Look look, const TrackerFrame& frame) {
  TrackedObject object;
  object.last_path = frame.path;
  object.AddLook(std::move(look));
  Retriangulate(object);
  object.far = CameraPointOf(camera_, frame.x, object.p).p_C.norm();
  objects_.push_back(std::move(object));
}

void ObjectTracker::Retriangulate(TrackedObject& object) {
  Locate(object);
  // No object is in the ground: the oldest look then was of something else.
  if (object.looks.size() > 2 && object.looks.back().altitude &&
      object.p.z() > smoother_.PoseAt(object.looks.back().node)(kNavZ) +
                         *object.looks.back().altitude + kInTheGround) {
    object.looks.erase(object.looks.begin());
    object.expected = object.hits = static_cast<int>(object.looks.size());
    object.RecountColor();
    Locate(object);
  }
}

void ObjectTracker::Locate(TrackedObject& object) {
  const Triangulation found = Triangulate(
      object.looks, [this](int node) { return smoother_.PoseAt(node); }, camera_, params_.model);
  object.p = found.p;
  object.covariance = found.covariance;
  object.worst_residual = found.worst_residual;
}

void ObjectTracker::AddTerms(TrackedObject& object, Look& look, bool with_seabed) {
  for (Term& term : TermsOfLook(look, object.slot, camera_, params_.model, with_seabed)) {
    look.terms.push_back(smoother_.AddTerm(look.node, std::move(term)));
  }
}

void ObjectTracker::DropStale(double now) {
  std::erase_if(objects_, [&](const TrackedObject& object) {
    return !object.is_mapped() && now - object.last_seen() > params_.confirm_within_s;
  });
}

void ObjectTracker::Refresh() {
  for (TrackedObject& object : objects_) {
    if (object.is_mapped()) {
      object.p = smoother_.LandmarkAt(object.slot);
    }
  }
}

}  // namespace limpet

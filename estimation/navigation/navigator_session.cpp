// SPDX-License-Identifier: MIT
// What a former session tells this one: which objects it knew, and where on earth they are.
#include "estimation/navigation/navigator.hpp"

namespace limpet {
namespace {

constexpr double kMovedLandmark = 0.03;  // [m] since the last match: worth another

}  // namespace

void Navigator::SetFormerSession(FormerSession former) {
  former_.SetFormer(std::move(former));
  matched_.clear();
}

void Navigator::MatchFormerObjects() {
  if (!former_.has_former()) {
    return;
  }
  PresentLandmarks present;
  std::vector<TrackedObject*> objects;
  for (TrackedObject& object : tracker_.objects()) {
    if (object.is_landmark()) {
      objects.push_back(&object);
      present.slots.push_back(object.slot);
      present.objects.push_back({.ned = object.p, .cov = {}, .color = object.Color()});
    }
  }
  if (present.slots.empty() || !HasChanged(present)) {
    return;
  }
  present.covariance = JointCovarianceOf(present.slots);
  if (!former_.Match(present, smoother_.graph().joint_prior())) {
    return;
  }
  for (std::size_t i = 0; i < objects.size(); ++i) {
    objects[i]->prior_id = former_.former_ids()[i];
  }
  smoother_.SetJointPrior(former_.prior());
  smoother_.Update();
  tracker_.Refresh();
  matched_.clear();
  for (const TrackedObject* object : objects) {
    matched_.push_back({object->slot, object->p});
  }
}

bool Navigator::HasChanged(const PresentLandmarks& present) const {
  if (present.slots.size() != matched_.size()) {
    return true;
  }
  for (std::size_t i = 0; i < matched_.size(); ++i) {
    if (matched_[i].slot != present.slots[i] ||
        (matched_[i].p - present.objects[i].ned).norm() > kMovedLandmark) {
      return true;
    }
  }
  return false;
}

}  // namespace limpet

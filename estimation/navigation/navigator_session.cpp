// SPDX-License-Identifier: MIT
// What a former session tells this one: which objects it knew, and where on earth they are.
#include <algorithm>

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
  const auto add = [&](TrackedObject& object) {
    objects.push_back(&object);
    present.slots.push_back(object.slot);
    present.objects.push_back({.ned = object.p, .cov = {}, .color = object.Color()});
  };
  for (TrackedObject& object : tracker_.objects()) {
    if (object.is_landmark()) add(object);
  }
  // One that has come in doubt since the last match.
  const std::optional<JointPrior>& applied = smoother_.graph().joint_prior();
  for (TrackedObject& object : tracker_.objects()) {
    const bool is_in_prior =
        applied && object.is_mapped() && std::ranges::count(applied->slots(), object.slot) > 0;
    if (is_in_prior && !object.is_landmark()) add(object), ++present.others;
  }
  if (present.slots.empty() || !HasChanged(present)) {
    return;
  }
  present.covariance = JointCovarianceOf(present.slots);
  if (!former_.Match(present, applied)) {
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

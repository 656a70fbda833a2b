// SPDX-License-Identifier: MIT
#include "estimation/navigation/former_matching.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace limpet {
namespace {

constexpr double kMovedLandmark = 0.03;  // [m] since the last match: worth another

}  // namespace

void FormerMatching::SetFormer(FormerSession former) {
  tie_.SetFormer(std::move(former));
  matched_.clear();
}

FormerMatching::Present FormerMatching::CollectPresent() {
  Present present;
  PresentLandmarks& landmarks = present.landmarks;
  const auto add = [&](TrackedObject& object) {
    present.objects.push_back(&object);
    landmarks.slots.push_back(object.slot());
    landmarks.objects.push_back({.p_W = object.p_W, .color = tracker_.BoxesOf(object).color});
  };
  for (TrackedObject& object : tracker_.objects()) {
    if (object.is_landmark()) add(object);
  }
  const std::optional<JointPrior>& applied = smoother_.graph().joint_prior();
  for (TrackedObject& object : tracker_.objects()) {
    const bool is_in_prior =
        applied && object.is_mapped() && std::ranges::count(applied->slots(), object.slot()) > 0;
    if (is_in_prior && !object.is_landmark()) add(object), ++landmarks.others;
  }
  return present;
}

void FormerMatching::Update() {
  if (!has_former()) {
    return;
  }
  Present present = CollectPresent();
  PresentLandmarks& landmarks = present.landmarks;
  if (landmarks.slots.empty() || !HasChanged(present)) {
    return;
  }
  const auto n = static_cast<Eigen::Index>(3 * landmarks.slots.size());
  landmarks.covariance = smoother_.Covariance(landmarks.slots).bottomRightCorner(n, n);
  if (!tie_.Match(landmarks, smoother_.graph().joint_prior())) {
    return;
  }
  for (std::size_t i = 0; i < present.objects.size(); ++i) {
    present.objects[i]->former = tie_.identities()[i];
  }
  smoother_.SetJointPrior(tie_.prior());
  smoother_.Update();
  tracker_.RefreshAll();
  matched_.clear();
  for (std::size_t i = 0; i < present.objects.size(); ++i) {
    const TrackedObject* object = present.objects[i];
    matched_.push_back({object->slot(), object->p_W, landmarks.objects[i].color,
                        object->former.candidates.empty() ? 0 : object->observations.size()});
  }
}

bool FormerMatching::HasChanged(const Present& present) const {
  if (present.objects.size() != matched_.size()) {
    return true;
  }
  for (std::size_t i = 0; i < matched_.size(); ++i) {
    const MatchedLandmark& before = matched_[i];
    const TrackedObject& now = *present.objects[i];
    const bool may_be_decided =
        before.undecided_at > 0 && now.observations.size() != before.undecided_at;
    const bool is_another =
        before.slot != now.slot() || before.color != present.landmarks.objects[i].color;
    if (is_another || (before.p_W - now.p_W).norm() > kMovedLandmark || may_be_decided) {
      return true;
    }
  }
  return false;
}

}  // namespace limpet

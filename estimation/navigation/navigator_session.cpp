// SPDX-License-Identifier: MIT
// What a former session tells this one: which objects it knew, and where on earth they are.
#include <algorithm>

#include "estimation/navigation/navigator.hpp"
#include "estimation/smoothing/factors/landmark_prior_factor.hpp"

namespace limpet {
namespace {

constexpr double kTieLoss =
    2.0;  // whitened; an object that was moved after all must not drag the rest

}  // namespace

void Navigator::MatchFormerObjects() {
  if (former_.empty()) {
    return;
  }
  std::vector<PresentObject> present;
  std::vector<TrackedObject*> objects;
  for (TrackedObject& object : tracker_.objects()) {
    if (object.is_landmark()) {
      objects.push_back(&object);
      present.push_back(
          {object.p, smoother_.Covariance({object.slot}).block<3, 3>(6, 6), object.Color()});
    }
  }
  const std::vector<int> ids = MatchSessions(former_, present, params_.session);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    objects[i]->prior_id = ids[i];
  }
}

void Navigator::TieToFormerSession() {
  if (is_tied_) {
    return;
  }
  MatchFormerObjects();
  std::vector<std::pair<int, const FormerObject*>> pairs;
  for (const TrackedObject& object : tracker_.objects()) {
    const auto former = std::ranges::find(former_, object.prior_id, &FormerObject::id);
    if (object.is_landmark() && object.prior_id >= 0 && former != former_.end()) {
      pairs.emplace_back(object.slot, &*former);
    }
  }
  // One pair alone could be a mistake, and nothing would show it.
  if (pairs.size() < 2) {
    return;
  }
  // What the former session did not know is mostly common to its objects: its own offset and
  // heading. Each pair gets its share of that one piece of knowledge, so that all of them together
  // say it once.
  for (const auto& [slot, former] : pairs) {
    const Eigen::Matrix3d covariance = static_cast<double>(pairs.size()) * former->covariance;
    smoother_.AddLandmarkTerm(slot, Term::OnLandmark(LandmarkPriorFactor(former->p, covariance),
                                                     slot, Loss::Huber(kTieLoss)));
  }
  is_tied_ = true;
}

}  // namespace limpet

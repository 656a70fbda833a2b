// SPDX-License-Identifier: MIT
#include "apps/pMap/map_conversions.hpp"

namespace limpet {
namespace {

PlacedObject PlacedOf(const std::array<double, 3>& ned, const std::array<double, 6>& cov,
                      const std::string& color) {
  PlacedObject object{.ned = {ned[0], ned[1], ned[2]}, .cov = {}, .color = color};
  object.cov << cov[0], cov[1], cov[2],  //
      cov[1], cov[3], cov[4],            //
      cov[2], cov[4], cov[5];
  return object;
}

}  // namespace

SightedDetection DetectionOf(const SightedBox& sighted) {
  const Box& box = sighted.box;
  return {.u = box.u,
          .v = box.v,
          .w = box.w,
          .h = box.h,
          .confidence = box.confidence,
          .color = box.color,
          .landmark = sighted.landmark};
}

SightRecord RecordOf(const Sight& sight) {
  SightRecord record{.time = sight.exposure.value(),
                     .X_WB = sight.pose(),
                     .boxes = {},
                     .altitude = sight.altitude};
  for (const SightedBox& sighted : sight.boxes) {
    record.boxes.push_back(DetectionOf(sighted));
  }
  return record;
}

std::vector<KnownLandmark> ConfirmedOf(const Landmarks& landmarks) {
  std::vector<KnownLandmark> known;
  for (const Landmark& landmark : landmarks.landmarks) {
    if (landmark.is_confirmed) {
      known.push_back({.id = landmark.id,
                       .object = PlacedOf(landmark.ned, landmark.cov, landmark.color),
                       .looks = landmark.looks});
    }
  }
  return known;
}

std::vector<FormerObject> FormerOf(const SessionPrior& prior) {
  std::vector<FormerObject> former;
  for (const PriorOpi& opi : prior.opis) {
    former.push_back({.id = opi.id,
                      .object = PlacedOf(opi.ned, opi.cov, opi.color),
                      .lambda = opi.log_likelihood_ratio,
                      .looks = opi.looks});
  }
  return former;
}

OpiBelief BeliefOf(const ObjectStatus& status) {
  const Eigen::Vector3d& ned = status.object.ned;
  const Eigen::Matrix3d& cov = status.object.cov;
  const StatusPosterior& posterior = status.posterior;
  return {
      .id = status.id,
      .landmark = status.landmark,
      .prior_id = status.former,
      .ned = {ned.x(), ned.y(), ned.z()},
      .cov = {cov(0, 0), cov(0, 1), cov(0, 2), cov(1, 1), cov(1, 2), cov(2, 2)},
      .centroid = {ned.x(), ned.y(), ned.z()},
      .centroid_sd = {},
      .color = status.object.color,
      .probability = posterior.present(),
      .posterior = {posterior.confirmed, posterior.removed, posterior.appeared, posterior.nothing},
      .decided = std::string(NameOf(status.decided)),
      .looks = status.looks,
      .entropy = posterior.Entropy(),
      .log_likelihood_ratio = status.lambda};
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "estimation/change/former_ties.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "estimation/matching/own_covariance.hpp"

namespace limpet {

FormerTies::FormerTies(std::vector<FormerObject> former, const MatchingParams& params)
    : former_(std::move(former)), params_(params) {}

void FormerTies::Take(const std::vector<Landmark>& objects) {
  match_.now_of_former.assign(former_.size(), std::nullopt);
  match_.chance.setZero(static_cast<Eigen::Index>(former_.size()),
                        static_cast<Eigen::Index>(objects.size()));
  for (std::size_t j = 0; j < objects.size(); ++j) {
    TakeCandidates(objects[j], j);
  }
  FitFrame(objects);
}

void FormerTies::TakeCandidates(const Landmark& landmark, std::size_t object) {
  const auto take = [&](int former_id, double chance, bool is_best) {
    const auto found = std::ranges::find(former_, former_id, &FormerObject::id);
    if (found == former_.end()) return;  // of another former session
    const auto i = found - former_.begin();
    std::optional<int>& now = match_.now_of_former[static_cast<std::size_t>(i)];
    if (is_best && !now) now = static_cast<int>(object);
    match_.chance(i, static_cast<Eigen::Index>(object)) = std::clamp(chance, 0.0, 1.0);
  };
  for (const FormerCandidate& candidate : landmark.former.candidates) {
    take(candidate.id, candidate.probability, candidate.id == landmark.former.id);
  }
  if (landmark.former.is_decided()) take(*landmark.former.id, landmark.former.probability, true);
}

void FormerTies::FitFrame(const std::vector<Landmark>& objects) {
  std::vector<ObjectEstimate> now;
  for (const Landmark& object : objects) {
    now.push_back(object.object);
  }
  // The offset rests on what is decided alone.
  FormerMatches decided = match_.now_of_former;
  for (std::optional<int>& now_of : decided) {
    if (now_of && !objects[static_cast<std::size_t>(*now_of)].former.is_decided()) now_of.reset();
  }
  const SessionMatch fit =
      FitSessions(WithOwnCovariance(EstimatesOf(former_)), WithOwnCovariance(std::move(now)),
                  std::move(decided), params_);
  match_.offset = fit.offset;
  match_.offset_cov = fit.offset_cov;
}

std::optional<std::size_t> FormerTies::NowOf(std::size_t former) const {
  const std::optional<int> now = match_.now_of_former[former];
  return now ? std::optional(static_cast<std::size_t>(*now)) : std::nullopt;
}

bool FormerTies::StandsForFormer(std::size_t object) const {
  return std::ranges::find(match_.now_of_former, std::optional(static_cast<int>(object))) !=
         match_.now_of_former.end();
}

double FormerTies::Chance(std::size_t former, std::size_t object) const {
  return match_.chance(static_cast<Eigen::Index>(former), static_cast<Eigen::Index>(object));
}

double FormerTies::SumOfFormer(std::size_t former) const {
  return match_.chance.row(static_cast<Eigen::Index>(former)).sum();
}

double FormerTies::SumOfObject(std::size_t object) const {
  return match_.chance.col(static_cast<Eigen::Index>(object)).sum();
}

ObjectEstimate FormerTies::InOtherFrame(ObjectEstimate place, const Eigen::Vector3d& p_W) const {
  const double own = std::pow(params_.position_floor.value(), 2);
  place.p_W = p_W;
  place.cov_W = own * Eigen::Matrix3d::Identity();
  place.cov_W.topLeftCorner<2, 2>() += match_.offset_cov.topLeftCorner<2, 2>();
  return place;
}

ObjectEstimate FormerTies::PlaceNow(std::size_t former) const {
  const ObjectEstimate& place = former_[former].object;
  return InOtherFrame(place, match_.offset.Apply(place.p_W));
}

ObjectEstimate FormerTies::PlaceThen(const ObjectEstimate& now) const {
  return InOtherFrame(now, match_.offset.Undo(now.p_W));
}

}  // namespace limpet

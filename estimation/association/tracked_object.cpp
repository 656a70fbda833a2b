// SPDX-License-Identifier: MIT
#include "estimation/association/tracked_object.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace limpet {

void TrackedObject::Map(int id, int slot, const TrackState& as, std::optional<SizeSlot> size) {
  mapped_ = Mapped{.id = id, .slot = slot, .size = size};
  state = as;
}

bool TrackedObject::is_open() const {
  const auto* landmark = std::get_if<Confirmed>(&state);
  return is_mapped() && (landmark == nullptr || landmark->is_on_probation);
}

std::optional<int> TrackedObject::tied_to() const {
  const auto* tied = std::get_if<Tied>(&state);
  return tied == nullptr ? std::nullopt : std::optional(tied->to);
}

void TrackedObject::RecountColor() {
  votes_.clear();
  for (const Observation& observation : observations)
    votes_[observation.color] += observation.confidence;
  const auto most = std::ranges::max_element(
      votes_, {}, [](const std::pair<const std::string, double>& vote) { return vote.second; });
  color_ = most == votes_.end() ? "" : most->first;
}

void TrackedObject::Add(Observation observation) {
  const double votes = votes_[observation.color] += observation.confidence;
  const auto leading = votes_.find(color_);
  const bool leads = leading == votes_.end() || votes > leading->second ||
                     (votes == leading->second && observation.color < color_);
  if (leads) color_ = observation.color;
  observations.push_back(std::move(observation));
}

double TrackedObject::LogOdds() const {
  double sum = 0.0;
  for (const Observation& observation : observations) {
    const double c = std::clamp(observation.confidence, 0.05, 0.95);
    sum += std::log(c / (1.0 - c));
  }
  return sum;
}

}  // namespace limpet

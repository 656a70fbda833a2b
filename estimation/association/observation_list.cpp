// SPDX-License-Identifier: MIT
#include "estimation/association/observation_list.hpp"

#include "limpet/core/probability.hpp"

namespace limpet {

void ObservationList::Add(Observation observation) {
  const double votes = votes_[observation.color] += observation.confidence;
  const auto leading = votes_.find(color_);
  const bool leads = leading == votes_.end() || votes > leading->second ||
                     (votes == leading->second && observation.color < color_);
  if (leads) color_ = observation.color;
  all_.push_back(std::move(observation));
}

std::vector<Observation> ObservationList::TakeAll() {
  votes_.clear();
  color_.clear();
  return std::exchange(all_, {});
}

void ObservationList::RemoveFirst() {
  all_.erase(all_.begin());
  CountVotes();
}

void ObservationList::CountVotes() {
  votes_.clear();
  for (const Observation& observation : all_)
    votes_[observation.color] += observation.confidence;
  const auto most = std::ranges::max_element(
      votes_, {}, [](const std::pair<const std::string, double>& vote) { return vote.second; });
  color_ = most == votes_.end() ? "" : most->first;
}

double ObservationList::LogOdds() const {
  constexpr Interval kSayOfBox{.low = 0.05, .high = 0.95};
  double sum = 0.0;
  for (const Observation& observation : all_)
    sum += LogOddsOf(observation.confidence, kSayOfBox);
  return sum;
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
// The boxes that were taken to show one object, and the class that they vote for.
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "estimation/association/observation.hpp"

namespace limpet {

/// Observations in order of time. A box votes for its class with its confidence when it is added;
/// neither may be changed afterwards.
class ObservationList {
 public:
  void Add(Observation observation);
  /// Takes out those of which `is_out`(observation), in their order.
  template <class Predicate>
  std::vector<Observation> TakeIf(const Predicate& is_out);
  /// Takes out all; the list is empty then.
  std::vector<Observation> TakeAll();
  /// REQUIRES: !empty().
  void RemoveFirst();
  /// Sorts by frame; observations of one frame stay as they were added.
  void Sort() { std::ranges::stable_sort(all_, {}, &Observation::frame); }

  [[nodiscard]] const std::vector<Observation>& all() const { return all_; }
  [[nodiscard]] bool empty() const { return all_.empty(); }
  [[nodiscard]] std::size_t size() const { return all_.size(); }
  [[nodiscard]] const Observation& front() const { return all_.front(); }
  [[nodiscard]] const Observation& back() const { return all_.back(); }
  [[nodiscard]] Observation& back() { return all_.back(); }
  [[nodiscard]] Observation& operator[](std::size_t i) { return all_[i]; }
  [[nodiscard]] auto begin() const { return all_.begin(); }
  [[nodiscard]] auto end() const { return all_.end(); }
  [[nodiscard]] auto rbegin() const { return all_.rbegin(); }
  [[nodiscard]] auto rend() const { return all_.rend(); }

  /// The class with the most votes; the first in the alphabet if equal, empty of no box.
  [[nodiscard]] const std::string& color() const { return color_; }
  /// Sum of confidences per class.
  [[nodiscard]] const std::map<std::string, double>& votes() const { return votes_; }
  /// Sum of ln(c / (1 - c)) over the confidences.
  [[nodiscard]] double LogOdds() const;

 private:
  void CountVotes();

  std::vector<Observation> all_;
  std::map<std::string, double> votes_;
  std::string color_;
};

template <class Predicate>
std::vector<Observation> ObservationList::TakeIf(const Predicate& is_out) {
  const auto stays = [&is_out](const Observation& one) { return !is_out(one); };
  const auto out = std::stable_partition(all_.begin(), all_.end(), stays);
  std::vector<Observation> taken;
  if (out == all_.end()) return taken;
  taken.assign(std::make_move_iterator(out), std::make_move_iterator(all_.end()));
  all_.erase(out, all_.end());
  CountVotes();
  return taken;
}

}  // namespace limpet

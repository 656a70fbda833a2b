// SPDX-License-Identifier: MIT
#include "limpet/explain/helm_stop.hpp"

#include <algorithm>
#include <iterator>

#include "limpet/topics/mission.hpp"

namespace limpet {
namespace {

/// DRIVE drives; STANDBY is the word of a helm that waits behind another one.
bool IsStopped(std::string_view state) {
  return state == "PARK" || state == "MALCONFIG" || state == "DISABLED";
}

/// The helm holds one iteration without a decision off, as one behavior may hand over to another:
/// then it says that it stops, and yet goes on as it did.
bool MayBeHeldOff(std::string_view reason) {
  return reason == "NothingToDo" || reason == "NoGoalBehavior" ||
         reason.starts_with("MissingDecVars");
}

}  // namespace

void HelmStops::Take(std::string_view variable, std::string_view value, double time) {
  last_ = std::max(last_, time);  // a log's entries may be a little out of order
  if (variable == topics::kHelmState.name) {
    ++iterations_;
    state_ = IsStopped(value) ? value : "";
  } else if (variable == topics::kHelmAllStop.name) {
    reason_ = value == topics::kNoAllStop ? "" : value;
  } else {
    return;
  }
  Settle(last_);
}

void HelmStops::Settle(double time) {
  const std::string& why = reason_.empty() ? state_ : reason_;
  const bool is_stopped = !stops_.empty() && !stops_.back().end;
  if (is_stopped && stops_.back().why == why) return;
  if (is_stopped && iterations_ == 0 && !why.empty() && stops_.back().why == state_) {
    stops_.back().why = why;  // an iteration says its state first, and the reason next
    return;
  }
  if (is_stopped) End(time, why.empty());
  if (why.empty()) return;
  stops_.push_back({.begin = time, .end = {}, .why = why});
  iterations_ = 0;
}

void HelmStops::End(double time, bool goes_on) {
  if (goes_on && iterations_ == 1 && MayBeHeldOff(stops_.back().why)) {
    stops_.pop_back();
  } else {
    stops_.back().end = time;
  }
}

const HelmStop* HelmStops::At(double time) const {
  const auto later = std::ranges::upper_bound(stops_, time, {}, &HelmStop::begin);
  if (later == stops_.begin()) return nullptr;
  const HelmStop& last = *std::prev(later);
  return last.end && *last.end <= time ? nullptr : &last;
}

}  // namespace limpet

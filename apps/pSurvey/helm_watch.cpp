// SPDX-License-Identifier: MIT
#include "apps/pSurvey/helm_watch.hpp"

#include <algorithm>

#include "limpet/topics/mission.hpp"

namespace limpet {
namespace {

/// A helm that is silent or stands still for less has only just been told to drive.
constexpr Seconds kPatience(10.0);

}  // namespace

void HelmWatch::HearState(const std::string& state, Seconds now) {
  heard_ = now;
  state_ = state;
  const bool drives = state_ == "DRIVE" && (all_stop_.empty() || all_stop_ == topics::kNoAllStop);
  if (drives) {
    idle_since_.reset();
  } else if (!idle_since_) {
    idle_since_ = now;
  }
}

void HelmWatch::HearAllStop(const std::string& all_stop, Seconds now) {
  all_stop_ = all_stop;
  HearState(state_.empty() ? "DRIVE" : state_, now);
}

std::optional<std::string> HelmWatch::Complaint(Seconds since, Seconds now) const {
  if (now - std::max(heard_.value_or(since), since) > kPatience) {
    return "nothing is heard of the helm";
  }
  if (!idle_since_ || now - std::max(*idle_since_, since) <= kPatience) {
    return std::nullopt;
  }
  return state_ == "DRIVE" ? "the helm has stopped all: " + all_stop_
                           : "the helm does not drive: " + state_;
}

}  // namespace limpet

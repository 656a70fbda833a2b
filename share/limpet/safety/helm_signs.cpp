// SPDX-License-Identifier: MIT
#include "limpet/safety/helm_signs.hpp"

#include "limpet/topics/mission.hpp"

namespace limpet {

void HelmSigns::HearState(std::string_view state, Seconds now) {
  heard_ = now;
  drives_ = state == "DRIVE";
}

void HelmSigns::HearAllStop(std::string_view why, Seconds now) {
  if (why == topics::kNoAllStop) {
    idle_since_.reset();
    has_steered_ = has_steered_ || drives_;
  } else if (why == "ManualOverride" || why.starts_with("Safety")) {
    idle_since_.reset();  // somebody else decides
  } else if (!idle_since_) {
    idle_since_ = now;
  }
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "estimation/change/sight_gate.hpp"

#include "limpet/topics/mission.hpp"

namespace limpet {

std::string_view NameOf(SightDrop drop) {
  switch (drop) {
    case SightDrop::kOutOfOrder:
      return "out of order";
    case SightDrop::kOtherPhase:
      return "outside dive, survey and return";
    case SightDrop::kNoAltitude:
      return "without an altitude";
    case SightDrop::kTooHigh:
      break;
  }
  return "too high above the seabed";
}

std::optional<SightDrop> SightGate::Reason(Seconds time, const std::optional<double>& fresh,
                                           std::string_view phase) const {
  if (last_ && time <= *last_) return SightDrop::kOutOfOrder;
  if (!IsMappingPhase(phase)) return SightDrop::kOtherPhase;
  if (!fresh) return SightDrop::kNoAltitude;
  if (*fresh > params_.highest_view.value()) return SightDrop::kTooHigh;
  return std::nullopt;
}

void SightGate::Hear(Seconds time, double altitude) {
  altitude_ = altitude;
  altitude_time_ = time;
}

SightGate::Verdict SightGate::Judge(Seconds time, std::optional<double> altitude,
                                    std::string_view phase) {
  if (altitude) {
    Hear(time, *altitude);
  }
  const bool is_fresh = altitude_ && time - altitude_time_ <= params_.altitude_lasts;
  const std::optional<double> fresh = is_fresh ? altitude_ : std::nullopt;
  const std::optional<SightDrop> drop = Reason(time, fresh, phase);
  if (drop) {
    ++dropped_[static_cast<std::size_t>(*drop)];
  } else {
    ++used_;
  }
  if (drop != SightDrop::kOutOfOrder) {
    last_ = time;
  }
  return {fresh, drop};
}

}  // namespace limpet

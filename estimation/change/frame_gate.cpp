// SPDX-License-Identifier: MIT
#include "estimation/change/frame_gate.hpp"

#include "limpet/topics/mission.hpp"
#include "limpet/topics/survey_phase.hpp"

namespace limpet {

std::string_view NameOf(FrameDrop drop) {
  switch (drop) {
    case FrameDrop::kOutOfOrder:
      return "out of order";
    case FrameDrop::kOtherPhase:
      return "outside dive, survey and return";
    case FrameDrop::kNoAltitude:
      return "without an altitude";
    case FrameDrop::kTooHigh:
      break;
  }
  return "too high above the seabed";
}

std::optional<FrameDrop> FrameGate::Reason(Seconds time, const std::optional<double>& fresh,
                                           std::string_view phase) const {
  if (last_ && time <= *last_) return FrameDrop::kOutOfOrder;
  if (!IsMappingPhase(phase)) return FrameDrop::kOtherPhase;
  if (!fresh) return FrameDrop::kNoAltitude;
  if (*fresh > params_.highest_view.value()) return FrameDrop::kTooHigh;
  return std::nullopt;
}

void FrameGate::Hear(Seconds time, double altitude) {
  altitude_ = altitude;
  altitude_time_ = time;
}

FrameGate::Verdict FrameGate::Judge(Seconds time, std::optional<double> altitude,
                                    std::string_view phase) {
  if (altitude) {
    Hear(time, *altitude);
  }
  const bool is_fresh = altitude_ && time - altitude_time_ <= params_.altitude_lasts;
  const std::optional<double> fresh = is_fresh ? altitude_ : std::nullopt;
  const std::optional<FrameDrop> drop = Reason(time, fresh, phase);
  if (drop) {
    ++dropped_[static_cast<std::size_t>(*drop)];
  } else {
    ++used_;
  }
  if (drop != FrameDrop::kOutOfOrder) {
    last_ = time;
  }
  return {fresh, drop};
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "estimation/association/tracked_object.hpp"

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

}  // namespace limpet

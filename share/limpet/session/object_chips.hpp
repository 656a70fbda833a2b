// SPDX-License-Identifier: MIT
// The pictures of objects that a session keeps: chips.csv and chips/*.jpg.
#pragma once

#include <vector>

#include "limpet/core/expected.hpp"
#include "limpet/objects/best_chips.hpp"
#include "limpet/session/session_store.hpp"
#include "limpet/topics/mapping.hpp"

namespace limpet {

/// One of an object's pictures.
struct SavedChip {
  int object = 0;  ///< OpiBelief::id
  ObjectChip chip;
};

/// The pictures of these objects, best first. Those that are `saved` already stay where nobody has
/// seen the object since: a process that was started again has forgotten what it saw.
[[nodiscard]] std::vector<SavedChip> ChipsOf(const OpiBeliefs& objects, const BestChips& seen,
                                             const std::vector<SavedChip>& saved);

/// Adds nothing if there are none.
void AddChips(const std::vector<SavedChip>& chips, SessionFiles& files);
/// The error names file and line.
[[nodiscard]] Expected<std::vector<SavedChip>> ChipsFrom(const SessionFiles& files);

}  // namespace limpet

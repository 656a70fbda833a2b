// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "limpet/objects/best_chips.hpp"
#include "limpet/scoring/opi_score.hpp"
#include "limpet/scoring/session_record.hpp"

namespace limpet {

/// An object of the session, and what it looked like.
struct PicturedObject {
  int id = 0;
  std::string color;  ///< as the vehicle says
  Status decided = Status::kUncertain;
  std::string truth;  ///< what it is; "nothing" for an invented one, empty if nobody can say
  std::vector<ObjectChip> chips;  ///< best first
};

/// Those objects as last published that have pictures, in their order.
[[nodiscard]] std::vector<PicturedObject> PicturedObjects(const SessionRecord& record,
                                                          const OpiScores& scores);

}  // namespace limpet

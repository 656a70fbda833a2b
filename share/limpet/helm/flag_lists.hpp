// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "limpet/mission/flag.hpp"

namespace limpet {

/// What a behavior's block has posted, and when.
struct FlagLists {
  std::vector<Flag> spawn;     ///< once, as the behavior is made
  std::vector<Flag> spawnx;    ///< at the end of its first iteration
  std::vector<Flag> config;    ///< at its first iteration, and whenever an update was applied
  std::vector<Flag> run;       ///< as it begins to run
  std::vector<Flag> runx;      ///< in each iteration in which it runs
  std::vector<Flag> active;    ///< as it begins to have a say
  std::vector<Flag> inactive;  ///< as it has none any more, or is idle
  std::vector<Flag> idle;      ///< as it begins to be idle, also at first
  std::vector<Flag> end;       ///< when it has completed
};

}  // namespace limpet

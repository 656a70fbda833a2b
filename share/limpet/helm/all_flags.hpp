// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "limpet/helm/flag_lists.hpp"

namespace limpet {

/// Every list of `lists`, which must outlive the result.
[[nodiscard]] inline std::array<const std::vector<Flag>*, 9> AllFlags(const FlagLists& lists) {
  return {&lists.spawn,  &lists.spawnx,   &lists.config, &lists.run, &lists.runx,
          &lists.active, &lists.inactive, &lists.idle,   &lists.end};
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "tests/soak/soak_plan.hpp"
#include "tests/soak/soak_run.hpp"

namespace limpet {

/// A quantity with its bound.
struct SoakVerdict {
  std::string what;
  double value = 0.0, most = 0.0;
  [[nodiscard]] bool IsKept() const { return value <= most; }
};

/// What the runs show of each app, as a table.
[[nodiscard]] std::string AppTable(const SoakPlan& plan, const std::vector<SoakRun>& runs);
/// Every bound of the plan, and that no run has a complaint.
[[nodiscard]] std::vector<SoakVerdict> VerdictsOf(const SoakPlan& plan,
                                                  const std::vector<SoakRun>& runs);

}  // namespace limpet

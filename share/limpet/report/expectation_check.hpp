// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "limpet/mission/expectations.hpp"

namespace limpet {

/// A report beside what was expected of it.
struct ExpectationCheck {
  int compared = 0;                   ///< bounds of sessions that the report has
  std::vector<std::string> breaches;  ///< one line each: session, key, value, bound, file and line
  /// Bounds are of the mission as it is written: a run of another planner or gain is not held to
  /// them, and `compared` is 0.
  bool is_other_method = false;
  [[nodiscard]] bool is_kept() const { return breaches.empty(); }
};

/// Compares the text of a report.json. What a report leaves open (a level never reached, an end
/// without a true pose) keeps no bound. Throws std::runtime_error on what is no report.
[[nodiscard]] ExpectationCheck CheckReport(const Expectations& expected,
                                           const std::string& report_json);

}  // namespace limpet

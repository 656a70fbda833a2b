// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "limpet/scoring/scorer.hpp"

namespace limpet {

inline constexpr double kHomeRadius =
    3.0;  ///< the vehicle is home within this of the start point [m]
inline constexpr double kGoodError = 1.0;  ///< an object is where it was said to be within this [m]

/// A run in one sentence.
struct Verdict {
  bool is_good = false;    ///< home, nothing missed, invented or misplaced, every status right
  bool is_judged = false;  ///< false without truth: then nothing is good or bad
  std::string text;
};
[[nodiscard]] Verdict VerdictOf(const RunScore& run);

/// How many of the statuses of a session with a former one are right.
[[nodiscard]] int StatusesRight(const SessionScore& session);
[[nodiscard]] bool IsHome(const SessionScore& session);

}  // namespace limpet

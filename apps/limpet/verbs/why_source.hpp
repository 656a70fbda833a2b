// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "limpet/console/arguments.hpp"
#include "limpet/explain/decision_log.hpp"

namespace limpet {

/// Decisions, and whose they are.
struct WhySource {
  DecisionLog log;
  std::string session{};  ///< empty: there is only one
  std::string place{};    ///< for complaints
};

/// From a run folder, a log, or the community of a mission, as the command line of `limpet why`
/// says. Throws UsageError, also for what a live community cannot say; NoCommunity;
/// std::runtime_error.
[[nodiscard]] WhySource WhySourceOf(const Arguments& given);

}  // namespace limpet

// SPDX-License-Identifier: MIT
// One decision of the helm with all that led to it, the same for a terminal, for programs and for a
// page in a browser.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "limpet/decision/flip.hpp"
#include "limpet/explain/decision_log.hpp"

namespace limpet {

/// An option as the helm had it, and what became of it.
struct ExplainedOption {
  BiddenOption bidden;
  std::string lost_because;  ///< empty for the one that was chosen
};
struct Explanation {
  double time = 0.0;  ///< as LoggedDecision has it [s]
  int path_id = 0;
  std::string cause;  ///< why the helm decided then
  OptionOrder order = OptionOrder::kPerMetre;
  std::optional<std::size_t> chosen;  ///< nothing: every option was vetoed, or there was none
  std::vector<ExplainedOption> options;
  std::vector<std::string> bidders;  ///< every behavior with an opinion
  std::vector<Flip> flips;
  std::optional<LoggedMotion> motion;      ///< how it moved; nothing: nobody said
  std::vector<WaitingBehavior> waiting{};  ///< behaviors that do not run
};

/// `motion`: how the vehicle moved when that is asked for.
[[nodiscard]] Explanation Explain(const LoggedDecision& decision,
                                  std::optional<LoggedMotion> motion = {});

/// A decision in a line: what was chosen, of how many, because of what.
[[nodiscard]] std::string SummaryOf(const Explanation& explanation);

}  // namespace limpet

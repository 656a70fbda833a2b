// SPDX-License-Identifier: MIT
// One decision of the helm with all that led to it, the same for a terminal, for programs and for a
// page in a browser.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "limpet/decision/flip.hpp"
#include "limpet/explain/decision_log.hpp"

namespace limpet {

struct ExplainedOption {
  std::string source;
  double length = 0.0;          ///< [m]
  std::array<double, 2> end{};  ///< north, east [m]
  double total = 0.0;           ///< sum of values times weights
  double rate = 0.0;            ///< total per metre of `rate_length`
  double rate_length = 0.0;     ///< [m]
  std::optional<std::string> vetoed_by;
  std::string lost_because;  ///< empty for the one that was chosen
  std::vector<WeightedBid> bids;
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
  std::optional<LoggedMotion> motion;  ///< how it moved; nothing: nobody said
};

/// `motion`: how the vehicle moved when that is asked for.
[[nodiscard]] Explanation Explain(const LoggedDecision& decision,
                                  std::optional<LoggedMotion> motion = {});

/// A decision in a line: what was chosen, of how many, because of what.
[[nodiscard]] std::string SummaryOf(const Explanation& explanation);

}  // namespace limpet

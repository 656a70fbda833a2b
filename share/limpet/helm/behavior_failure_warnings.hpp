// SPDX-License-Identifier: MIT
// Warnings of behaviors that fail, or that take long.
#pragma once

#include <string>
#include <utility>

#include "limpet/helm/warning_book.hpp"
#include "limpet/topics/warning.hpp"

namespace limpet::warnings {

inline const WarningFamily kBehaviorFailed = DeclareWarningFamily(
    "BHV_FAILED_<BEHAVIOR>",
    {.severity = Severity::kAlarm,
     .raised_by = {"pHelm"},
     .meaning = "A behavior has thrown an exception, or bid a number that is none: its bid, on the "
                "motion or on where next, is not heard, the others are. BHV_ERROR says the same. "
                "So it is for one that cannot be started; it is tried again each time. What one "
                "throws elsewhere (idle, at its end, in a flag's macro) costs it that alone.",
     .action = "Bring the vehicle home if it cannot do without that behavior; then look at its "
               "parameters and code.",
     .clears = "With its next bid that can be heard, or when it runs no more."});

inline const WarningFamily kBehaviorLate = DeclareWarningFamily(
    "BHV_LATE_<BEHAVIOR>",
    {.severity = Severity::kAlarm,
     .raised_by = {"pHelm"},
     .meaning =
         "A behavior has kept the helm for more than half a second of real time, or for three "
         "seconds with all its bids on where next. Bids that come so late are not heard, on the "
         "motion or on where next; after two in a row the behavior is not asked for a hundred "
         "times as long as it took.",
     .action = "Bring the vehicle home if it cannot do without that behavior; then look at its "
               "code, or at what else the machine does.",
     .clears = "With its next bid in time, or when it runs no more."});

inline const WarningFamily kBidUnheard = DeclareWarningFamily(
    "BID_UNHEARD_<BEHAVIOR>",
    {.severity = Severity::kWarning,
     .raised_by = {"pHelm"},
     .meaning =
         "A behavior bids on a variable that the helm's domain does not have, and on nothing "
         "else: it has no say.",
     .action = "Give the helm's block a line of that variable, e.g. `domain = depth:0:100:101`, or "
               "take the behavior out.",
     .clears = "When it runs no more."});

}  // namespace limpet::warnings

namespace limpet {

/// The warning that `owner` is late, with what is to be said of it.
[[nodiscard]] inline OwnedWarning LatenessOf(const std::string& owner, std::string complaint) {
  return {.owner = owner, .warning = {warnings::kBehaviorLate.Of(owner), std::move(complaint)}};
}

}  // namespace limpet

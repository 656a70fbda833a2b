// SPDX-License-Identifier: MIT
// What pShare warns of.
#pragma once

#include "limpet/topics/warning.hpp"

namespace limpet::warnings {

inline const WarningId kNotLive = DeclareWarning(
    "NOT_LIVE", {.severity = Severity::kNote,
                 .raised_by = {"pShare"},
                 .meaning = "The run is embedded, on virtual time: nothing is shared.",
                 .action = "Use `limpet launch` where sharing matters.",
                 .clears = "It stands to the end of the run."});

inline const WarningId kPlainRoutes = DeclareWarning(
    "PLAIN_ROUTES",
    {.severity = Severity::kWarning,
     .raised_by = {"pShare"},
     .meaning = "Some routes are open: anybody on the network can read and forge them.",
     .action = "Give them a key (`limpet key`), unless the network is yours alone.",
     .clears = "It stands to the end of the run."});

inline const WarningFamily kCannotListen = DeclareWarningFamily(
    "CANNOT_LISTEN_<PORT>",
    {.severity = Severity::kWarning,
     .raised_by = {"pShare"},
     .meaning = "An input cannot listen at its port; it is tried again every second.",
     .action = "See who else has the port, or whether the interface exists.",
     .clears = "Once it listens."});

inline const WarningFamily kTooLarge = DeclareWarningFamily(
    "TOO_LARGE_<VARIABLE>",
    {.severity = Severity::kWarning,
     .raised_by = {"pShare"},
     .meaning = "A value is larger than a datagram may be and was not shared.",
     .action = "Share something smaller, or less often; bulk is fetched after the dive.",
     .clears = "With the next value of the variable that is sent."});

inline const WarningFamily kUnsent = DeclareWarningFamily(
    "UNSENT_<ROUTE>",
    {.severity = Severity::kWarning,
     .raised_by = {"pShare"},
     .meaning = "The system does not take datagrams for a route.",
     .action = "See whether the network is up and the name of the other side is known.",
     .clears = "With the next datagram that is taken."});

inline const WarningFamily kRefusedDatagrams = DeclareWarningFamily(
    "REFUSED_<REASON>",
    {.severity = Severity::kWarning,
     .raised_by = {"pShare"},
     .meaning = "Datagrams are refused: forged, replayed, stale, not sealed, for somebody else, no "
                "message, or too many; the text says from where and why.",
     .action = "If the sender is yours, compare keys, names, clocks and versions of both sides; "
               "else look who is on the network.",
     .clears = "After 30 s without one for this reason."});

}  // namespace limpet::warnings

// SPDX-License-Identifier: MIT
// What pShare says of itself; the names are MOOS's, whatever the app is called.
#pragma once

#include <string>

#include "limpet/topics/topic.hpp"

namespace limpet {

/// Counts since the start.
struct ShareCounts {
  double sent = 0.0;       ///< datagrams
  double unsent = 0.0;     ///< datagrams that the system did not take, or whose host is unknown
  double too_large = 0.0;  ///< writes that no datagram holds
  double taken = 0.0;      ///< datagrams that became mail
  double malformed = 0.0, not_sealed = 0.0, sealed = 0.0, old_version = 0.0, forged = 0.0;
  double elsewhere = 0.0, stale = 0.0, replayed = 0.0, own = 0.0;
  double unlisted = 0.0, looped = 0.0, overflow = 0.0;
  double commands = 0.0;  ///< of PSHARE_CMD, not obeyed
  template <class V>
  void Describe(V& visit) {
    visit("sent", sent), visit("unsent", unsent), visit("too_large", too_large);
    visit("taken", taken), visit("malformed", malformed), visit("not_sealed", not_sealed);
    visit("sealed", sealed), visit("old_version", old_version), visit("forged", forged);
    visit("elsewhere", elsewhere), visit("stale", stale), visit("replayed", replayed);
    visit("own", own), visit("unlisted", unlisted), visit("looped", looped);
    visit("overflow", overflow), visit("commands", commands);
  }
  bool operator==(const ShareCounts&) const = default;
};

namespace topics {
inline const auto kShareOutputs = Declare<std::string>(
    "PSHARE_OUTPUT_SUMMARY", "routes out: `X->Y:host:port & Z:224.1.1.11:24468:multicast_8, ...`",
    {.rate = "1 Hz", .writers = {"pShare"}});
inline const auto kShareInputs = Declare<std::string>(
    "PSHARE_INPUT_SUMMARY", "where pShare listens: `localhost:9030,224.1.1.11:24468:multicast_8`",
    {.rate = "1 Hz", .writers = {"pShare"}});
inline const auto kShareCounts = Declare<ShareCounts>(
    "PSHARE_COUNTS", "datagrams sent, taken, and refused by reason; commands refused",
    {.rate = "1 Hz on change", .writers = {"pShare"}});
}  // namespace topics

}  // namespace limpet

// SPDX-License-Identifier: MIT
// Which connection goes first when there is not enough for all.
#pragma once

#include <list>

#include "limpet/pubsub/tcp_connection.hpp"

namespace limpet {

/// The connections in the order of their arrival.
using Connections = std::list<TcpConnection>;

/// Of those that have not said who they are (or may not enter), the one that has been there
/// longest; end() if there is none.
[[nodiscard]] Connections::iterator OldestStranger(Connections& connections);
[[nodiscard]] std::size_t CountStrangers(const Connections& connections);

/// The connection whose unfinished packet has cost most so far, in bytes times seconds: the large
/// ones that have been there long. None younger than `least_age`; end() if there is none.
[[nodiscard]] Connections::iterator CostliestUnfinished(Connections& connections, Seconds now,
                                                        Seconds least_age);

/// The connection that has had mail to take and has taken none for longest; end() if there is none.
[[nodiscard]] Connections::iterator LongestStalled(Connections& connections);

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/pubsub/connection_order.hpp"

#include <algorithm>

namespace limpet {
namespace {

bool IsStranger(const TcpConnection& connection) { return !connection.client().has_value(); }

}  // namespace

Connections::iterator OldestStranger(Connections& connections) {
  return std::ranges::find_if(connections, IsStranger);
}

std::size_t CountStrangers(const Connections& connections) {
  return static_cast<std::size_t>(std::ranges::count_if(connections, IsStranger));
}

Connections::iterator CostliestUnfinished(Connections& connections, Seconds now,
                                          Seconds least_age) {
  auto costliest = connections.end();
  double most = 0.0;
  for (auto it = connections.begin(); it != connections.end(); ++it) {
    const auto since = it->unfinished_since();
    if (!since || now - *since < least_age) {
      continue;
    }
    const double cost = static_cast<double>(it->held()) * (now - *since).value();
    if (cost >= most) {
      most = cost;
      costliest = it;
    }
  }
  return costliest;
}

Connections::iterator LongestStalled(Connections& connections) {
  auto longest = connections.end();
  for (auto it = connections.begin(); it != connections.end(); ++it) {
    const bool is_longer =
        longest == connections.end() || it->last_progress() < longest->last_progress();
    if (it->wants_to_write() && is_longer) {
      longest = it;
    }
  }
  return longest;
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <string>

#include "limpet/pubsub/broker.hpp"

namespace limpet {

/// Delay from a client to the broker, from its timing messages; as DB_QOS tells it.
struct LinkQuality {
  double recent_ms = 0.0, max_ms = 0.0, min_ms = 1e9, mean_ms = 0.0;
  int count = 0;
  void Add(double delay_ms) {
    ++count;
    recent_ms = delay_ms;
    max_ms = std::max(max_ms, delay_ms);
    min_ms = std::min(min_ms, delay_ms);
    mean_ms += (delay_ms - mean_ms) / count;
  }
};

/// Part of a client's memory that its mail may take: the rest is what keeping it costs.
constexpr std::size_t MailRoom(std::size_t memory) { return memory / 16 * 13; }

struct Broker::Session {
  explicit Session(std::size_t queue) : outbox(MailRoom(queue)) {}
  Client client = 0;
  std::string name;
  bool is_async = true;
  bool is_ready = false;    ///< listed in ready_
  bool owes_reply = false;  ///< sync: one packet for each of the client's
  ByteBuffer timing_echo;   ///< async: leads the next packet; empty if none
  LinkQuality quality;
  Outbox outbox;
};

}  // namespace limpet

// SPDX-License-Identifier: MIT
// What waits for clients, kept within the budget that all of them share.
#include "limpet/pubsub/broker.hpp"
#include "limpet/pubsub/broker_session.hpp"

namespace limpet {

std::size_t Broker::CountMail() const {
  std::size_t bytes = *alive_ - stored_;
  for (const auto& session : sessions_) {
    bytes += session ? session->outbox.own() : 0;
  }
  return bytes;
}

void Broker::BoundMail() {
  queued_since_ = 0;
  std::size_t mail = CountMail();
  for (std::size_t left = sessions_.size(); left > 0 && mail > memory_.RoomForMail(); --left) {
    Session* longest = nullptr;
    for (const auto& session : sessions_) {
      if (session && (longest == nullptr || session->outbox.size() > longest->outbox.size())) {
        longest = session.get();
      }
    }
    if (longest == nullptr || longest->outbox.empty()) {
      break;
    }
    longest->outbox.DropOlderHalf();
    mail = CountMail();
  }
  memory_.SetQueued(mail);
}

}  // namespace limpet

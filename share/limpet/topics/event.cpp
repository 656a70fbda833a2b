// SPDX-License-Identifier: MIT
#include "limpet/topics/event.hpp"

#include "limpet/core/require.hpp"

namespace limpet {
namespace {

std::map<std::string, EventFacts>& EventStore() {
  static std::map<std::string, EventFacts> catalog;
  return catalog;
}

}  // namespace

EventId DeclareEvent(std::string id, const EventFacts& facts) {
  const bool is_new = EventStore().try_emplace(id, facts).second;
  LIMPET_REQUIRE(is_new, "an event is declared twice: " + id);
  return EventId(std::move(id));
}

const std::map<std::string, EventFacts>& EventCatalog() { return EventStore(); }

}  // namespace limpet

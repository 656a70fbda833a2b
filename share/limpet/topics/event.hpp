// SPDX-License-Identifier: MIT
// Events that an operator's report tells of, declared once like warnings. An event happens and is
// over; what lasts is a warning.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "limpet/topics/warning.hpp"

namespace limpet {

/// What an operator has to know about an event beside its text; a whole sentence.
struct EventFacts {
  Severity severity = Severity::kNote;
  std::vector<std::string> reported_by{};  ///< apps by process
  std::string meaning{};
};

/// The id of an event. Made by a declaration alone, so that none can be reported without.
class EventId {
 public:
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  friend EventId DeclareEvent(std::string id, const EventFacts& facts);
  explicit EventId(std::string name) : name_(std::move(name)) {}

  std::string name_;
};

/// For constants, which are made before main. REQUIRES: no event of this id is declared.
[[nodiscard]] EventId DeclareEvent(std::string id, const EventFacts& facts);

/// Every event that this program declares, by id.
[[nodiscard]] const std::map<std::string, EventFacts>& EventCatalog();

}  // namespace limpet

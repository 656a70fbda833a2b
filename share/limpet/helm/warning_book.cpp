// SPDX-License-Identifier: MIT
#include "limpet/helm/warning_book.hpp"

#include <utility>

namespace limpet {
namespace {

/// Several behaviors may raise one warning, each with a text of its own; the first one's is told.
struct Raised {
  std::string owners;
  BehaviorWarning warning;
};

std::map<std::string, Raised> ById(const std::vector<OwnedWarning>& now) {
  std::map<std::string, Raised> raised;
  for (const OwnedWarning& owned : now) {
    const auto [entry, is_new] =
        raised.try_emplace(owned.warning.id.name(), Raised{owned.owner, owned.warning});
    if (!is_new) {
      entry->second.owners += ", " + owned.owner;
    }
  }
  return raised;
}

}  // namespace

WarningBook::Change WarningBook::Update(const std::vector<OwnedWarning>& now) {
  Change change;
  std::map<std::string, WarningId> former = std::move(standing_);
  standing_.clear();
  for (const auto& [id, raised] : ById(now)) {
    former.erase(id);
    standing_.emplace(id, raised.warning.id);
    change.standing.push_back(
        {.id = raised.warning.id, .text = raised.owners + ": " + raised.warning.text});
  }
  for (const auto& [id, cleared] : former) {
    change.cleared.push_back(cleared);
  }
  return change;
}

}  // namespace limpet

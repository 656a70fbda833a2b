// SPDX-License-Identifier: MIT
#include "limpet/helm/warning_book.hpp"

namespace limpet {

WarningBook::Change WarningBook::Update(const std::vector<OwnedWarning>& now) {
  std::map<std::string, std::string> owners;
  std::map<std::string, std::string> texts;
  for (const OwnedWarning& raised : now) {
    std::string& names = owners[raised.warning.id];
    names += (names.empty() ? "" : ", ") + raised.owner;
    texts.try_emplace(raised.warning.id, raised.warning.text);
  }
  Change change;
  for (const auto& [id, names] : owners_) {
    const auto still = owners.find(id);
    if (still == owners.end() || still->second != names) {
      change.cleared.push_back(id);
    }
  }
  for (const auto& [id, names] : owners) {
    const auto before = owners_.find(id);
    if (before == owners_.end() || before->second != names) {
      change.raised.push_back({.id = id, .text = names + ": " + texts.at(id)});
    }
  }
  owners_ = std::move(owners);
  return change;
}

}  // namespace limpet

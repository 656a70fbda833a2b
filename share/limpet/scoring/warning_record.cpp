// SPDX-License-Identifier: MIT
#include "limpet/scoring/warning_record.hpp"

#include <map>
#include <utility>

#include "limpet/app/warning_text.hpp"

namespace limpet {

void CollectWarnings(const Message& message, Seconds time, std::vector<WarningRecord>& warnings) {
  const auto* text = std::get_if<std::string>(&message.value);
  if (text == nullptr) {
    return;
  }
  const std::string app =
      message.source.empty() ? std::string(AppOfWarnings(message.name)) : message.source;
  std::map<std::string, ToldWarning> standing = DecodeWarnings(*text);
  for (WarningRecord& known : warnings) {
    if (known.app == app && !known.to) {
      if (const auto still = standing.find(known.id); still != standing.end()) {
        known.text = std::move(still->second.text);
        standing.erase(still);
      } else {
        known.to = time;
      }
    }
  }
  for (auto& [id, told] : standing) {
    warnings.push_back({.app = app,
                        .id = id,
                        .severity = told.severity,
                        .text = std::move(told.text),
                        .from = time,
                        .to = {}});
  }
}

}  // namespace limpet

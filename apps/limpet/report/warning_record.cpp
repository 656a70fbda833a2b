// SPDX-License-Identifier: MIT
#include "apps/limpet/report/warning_record.hpp"

#include <algorithm>
#include <map>

#include "limpet/app/warning_text.hpp"

namespace limpet {
namespace {

constexpr const char* kWarningSuffix = "_WARNINGS";

}  // namespace

bool CarriesWarnings(const std::string& variable) { return variable.ends_with(kWarningSuffix); }

void CollectWarnings(const Message& message, Seconds time, std::vector<WarningRecord>& warnings) {
  const auto* text = std::get_if<std::string>(&message.value);
  if (text == nullptr) {
    return;
  }
  // The variable has the app's name in capitals.
  const std::string app = message.source.empty()
                              ? message.name.substr(0, message.name.rfind(kWarningSuffix))
                              : message.source;
  std::map<std::string, std::string> standing = DecodeWarnings(*text);
  for (WarningRecord& known : warnings) {
    if (known.app == app && !known.to) {
      if (const auto still = standing.find(known.id); still != standing.end()) {
        standing.erase(still);
      } else {
        known.to = time;
      }
    }
  }
  for (const auto& [id, meaning] : standing) {
    warnings.push_back({.app = app, .id = id, .text = meaning, .from = time, .to = {}});
  }
}

}  // namespace limpet

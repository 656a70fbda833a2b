// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "limpet/topics/event.hpp"
#include "limpet/topics/warning.hpp"

namespace limpet {

/// What apps, behaviors and the launcher warn of, and the events that they report.
struct WarningList {
  std::vector<WarningDeclaration> warnings;
  std::map<std::string, EventFacts> events;
};

/// Text for a terminal: warnings, then events.
[[nodiscard]] std::string PlainText(const WarningList& list);
[[nodiscard]] std::string Json(const WarningList& list);
/// The page docs/warnings.md.
[[nodiscard]] std::string Markdown(const WarningList& list);

}  // namespace limpet

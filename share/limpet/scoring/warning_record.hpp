// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "limpet/core/message.hpp"
#include "limpet/topics/warning.hpp"

namespace limpet {

/// A health warning of a session: who raised it, and from when to when it stood.
struct WarningRecord {
  std::string app, id;
  Severity severity = Severity::kWarning;
  std::string text;           ///< its latest while it stood
  Seconds from;               ///< MOOS time
  std::optional<Seconds> to;  ///< absent: it stood at the end
};

/// Takes what an app says of its warnings at `time` into the list: closes what no longer stands,
/// adds what is new, and lets the text of what still stands follow.
void CollectWarnings(const Message& message, Seconds time, std::vector<WarningRecord>& warnings);

}  // namespace limpet

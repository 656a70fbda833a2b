// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "limpet/core/message.hpp"

namespace limpet {

/// A health warning of a session: who raised it, and from when to when it stood.
struct WarningRecord {
  std::string app, id, text;
  Seconds from;               ///< MOOS time
  std::optional<Seconds> to;  ///< absent: it stood at the end
};

/// True for the variables that carry warnings, <APP>_WARNINGS.
[[nodiscard]] bool CarriesWarnings(const std::string& variable);

/// Takes what an app says of its warnings at `time` into the list: closes what no longer stands and
/// adds what is new.
void CollectWarnings(const Message& message, Seconds time, std::vector<WarningRecord>& warnings);

}  // namespace limpet

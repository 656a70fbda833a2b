// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "limpet/core/message.hpp"

namespace limpet {

/// A variable that the helm is to write: a flag, a mode, an initial value.
struct HelmPost {
  std::string variable;
  Value value;
  std::string aux;  ///< which behavior or rule
};

/// What one behavior is doing, for whoever watches the helm.
struct BehaviorStatus {
  std::string name, type;
  double weight = 0.0;
  bool is_running = false;
  bool is_complete = false;  ///< in this iteration: it is gone in the next one
  /// While idle the condition, or input, that it waits for; why it has completed.
  std::string held_back_by{};
  bool takes_updates = false;         ///< its block names a variable of them
  int good_updates = 0, updates = 0;  ///< `updates` mail: applied whole, and all
  bool operator==(const BehaviorStatus&) const = default;
};

}  // namespace limpet

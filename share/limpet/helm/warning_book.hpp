// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "limpet/helm/behavior.hpp"

namespace limpet {

/// A warning and the behavior that raises it.
struct OwnedWarning {
  std::string owner;
  BehaviorWarning warning;
};

/// Keeps whose warnings stand. A warning stands as long as a behavior that runs raises it; of two
/// that raise the same, both must fall silent.
class WarningBook {
 public:
  struct Change {
    std::vector<WarningId> cleared;
    /// All that stand, by id; the text begins with who raises it, e.g. `altitude, region: ...`.
    std::vector<BehaviorWarning> standing;
  };
  /// `now` is all that is raised at this time, in any order.
  [[nodiscard]] Change Update(const std::vector<OwnedWarning>& now);

 private:
  std::map<std::string, WarningId> standing_;
};

}  // namespace limpet

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
    std::vector<std::string> cleared;     ///< ids; first
    std::vector<BehaviorWarning> raised;  ///< the text begins with who raises it
  };
  /// `now` is all that is raised at this time, in any order.
  [[nodiscard]] Change Update(const std::vector<OwnedWarning>& now);

 private:
  std::map<std::string, std::string> owners_;  ///< by id, e.g. `altitude, region`
};

}  // namespace limpet

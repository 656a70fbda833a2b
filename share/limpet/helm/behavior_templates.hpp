// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/core/config.hpp"
#include "limpet/helm/common_settings.hpp"

namespace limpet {

/// A behavior that an update asks for: the template's block, named, with the update's parts.
struct SpawnRequest {
  ConfigBlock block;
  std::string base_name;  ///< the template's name, which the behavior's begins with
};

/// Blocks with `templating = spawn` or `clone`: mail of their `updates` variable that names a
/// behavior which does not live makes one, called the template's name and that name.
class BehaviorTemplates {
 public:
  using IsTaken = std::function<bool(const std::string& name)>;

  void Add(const ConfigBlock& block, const CommonSettings& settings);
  /// What mail of `variable` asks for. Each request counts as made.
  [[nodiscard]] std::vector<SpawnRequest> RequestsOf(std::string_view variable,
                                                     const std::string& text,
                                                     const IsTaken& is_taken);
  [[nodiscard]] std::vector<std::string> Variables() const;

 private:
  struct Template {
    ConfigBlock block;
    std::string name, variable;
    std::optional<int> left;  ///< spawnings; nothing: no limit
  };
  std::vector<Template> templates_;
};

}  // namespace limpet

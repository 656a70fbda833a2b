// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "limpet/core/params.hpp"

namespace limpet {

/// What a mission file may set of an app, a behavior, a detector or a measurement source.
struct ParameterOwner {
  enum class Kind { kApp, kBehavior, kDetector, kSource };
  std::string name;
  Kind kind = Kind::kApp;
  std::optional<double> tick_hz;  ///< an app's default AppTick; absent for all others
  std::vector<ParamSpec> parameters;
};

/// Every registered app, then every behavior, then every detector, then every measurement source,
/// by name.
[[nodiscard]] std::vector<ParameterOwner> AllParameterOwners();

/// The owner's parameters as text for a terminal.
[[nodiscard]] std::string PlainText(const ParameterOwner& owner);
[[nodiscard]] std::string Json(const std::vector<ParameterOwner>& owners);
/// The page docs/parameters.md.
[[nodiscard]] std::string Markdown(const std::vector<ParameterOwner>& owners);

}  // namespace limpet

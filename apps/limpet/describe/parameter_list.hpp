// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "limpet/core/params.hpp"

namespace limpet {

/// An app or a behavior with the parameters that its block of a mission file may set.
struct ParameterOwner {
  std::string name;
  std::optional<double> tick_hz;  ///< an app's default AppTick; absent for a behavior
  std::vector<ParamSpec> parameters;
  [[nodiscard]] bool is_app() const { return tick_hz.has_value(); }
};

/// Every registered app, then every registered behavior, by name.
[[nodiscard]] std::vector<ParameterOwner> AllParameterOwners();

/// For a terminal.
[[nodiscard]] std::string PlainText(const ParameterOwner& owner);
[[nodiscard]] std::string Json(const std::vector<ParameterOwner>& owners);
/// The page docs/parameters.md.
[[nodiscard]] std::string Markdown(const std::vector<ParameterOwner>& owners);

}  // namespace limpet

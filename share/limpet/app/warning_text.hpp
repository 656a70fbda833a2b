// SPDX-License-Identifier: MIT
// <APP>_WARNINGS: what an app warns of now.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "limpet/core/units.hpp"
#include "limpet/topics/warning.hpp"

namespace limpet {

/// A warning that stands.
struct StandingWarning {
  Severity severity = Severity::kWarning;
  std::string text;
  Seconds since;  ///< MOOS time
};

/// A warning as its variable tells it.
struct ToldWarning {
  Severity severity = Severity::kWarning;
  std::string text;
  bool operator==(const ToldWarning&) const = default;
};

/// PNAV_WARNINGS of pNav.
[[nodiscard]] std::string WarningsVariable(std::string_view app);
/// True for the variables that carry warnings.
[[nodiscard]] bool CarriesWarnings(std::string_view variable);
/// What the variable says of the app's name: PNAV.
[[nodiscard]] std::string_view AppOfWarnings(std::string_view variable);

/// `ID (severity): text; ID (severity): text` by id, or `none`. A semicolon in a text becomes a
/// comma, so that the list can be taken apart again.
[[nodiscard]] std::string EncodeWarnings(const std::map<std::string, StandingWarning>& warnings);
/// Warnings by id. What names no severity is a warning; what has no `: ` is taken for an id without
/// a text.
[[nodiscard]] std::map<std::string, ToldWarning> DecodeWarnings(std::string_view text);

}  // namespace limpet

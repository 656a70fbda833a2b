// SPDX-License-Identifier: MIT
// Flags: what a behavior posts at an event. `RETURN = true`, `SPEED = $[OSV] [if] MODE == ACTIVE`.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "limpet/core/expected.hpp"
#include "limpet/core/message.hpp"
#include "limpet/mission/condition.hpp"

namespace limpet {

/// The text of a run-time macro, or nothing if there is no such macro.
using MacroLookup = std::function<std::optional<std::string>(std::string_view)>;

/// MOOS's rule for text that becomes a value: numeric text is a double; quoted (quotes go) and all
/// other text a string.
[[nodiscard]] Value ValueOfText(std::string_view text);

/// One post with its optional condition.
struct Flag {
  std::string tag;            ///< contact-range event of `@cpa`, `<50`, `>80`; empty if none
  std::string group;          ///< of `#all` and `#group`: other vehicles it goes to; empty if none
  bool is_also_local = true;  ///< false for `#group` without `+`
  std::string variable;
  std::string text;  ///< value as written, macros unexpanded
  std::optional<Condition> condition;
  bool is_repeated = true;              ///< false: only if its value is another than the last time
  bool has_parenthesis_macros = false;  ///< `$(NAME)` counts like `$[NAME]` (waypoint flags)

  /// Parses `[@tag] [#group[+]] VAR = value [[if] condition]`; the error says what is wrong.
  [[nodiscard]] static Expected<Flag> Parse(std::string_view text);

  /// The value to post, macros expanded; unknown ones stay as written. A value that is one macro
  /// and nothing else is a double if it expands to a number; with macros inside text it is a
  /// string.
  [[nodiscard]] Value Resolve(const MacroLookup& macros) const;
};

/// Replaces each `$[NAME]` (and `$(NAME)` if asked) once.
[[nodiscard]] std::string ExpandRuntimeMacros(std::string_view text, const MacroLookup& macros,
                                              bool has_parenthesis_macros);

}  // namespace limpet

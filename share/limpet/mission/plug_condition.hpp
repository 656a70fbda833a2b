// SPDX-License-Identifier: MIT
#pragma once

#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "limpet/core/config.hpp"
#include "limpet/mission/plug_macros.hpp"

namespace limpet {

/// Which lines of one plug file count: its #ifdef, #ifndef, #elseifdef, #else and #endif.
class PlugConditions {
 public:
  PlugConditions(const PlugMacros& macros, bool is_strict)
      : macros_(macros), is_strict_(is_strict) {}

  /// True if the line was one of these directives. Throws ConfigError if it has no #ifdef.
  bool Takes(std::string_view directive, std::string_view rest, const SourceLine& where);
  [[nodiscard]] bool is_active() const { return branches_.empty() || branches_.back().is_active; }
  /// Throws ConfigError if an #ifdef is still open.
  void RequireClosed(const SourceLine& end) const;
  /// Conditions that hold for an odd reason, since the last call.
  [[nodiscard]] std::vector<ConfigProblem> TakeWarnings() { return std::exchange(warnings_, {}); }

 private:
  struct Branch {
    bool is_parent_active = true;
    bool was_taken = false;  ///< this or an earlier part of the chain held
    bool is_active = false;
    SourceLine where;
  };
  void Open(bool holds, const SourceLine& where);
  void Next(std::string_view directive, bool holds, const SourceLine& where);
  [[nodiscard]] bool Holds(std::string_view condition, const SourceLine& where);
  using Names = std::set<std::string_view>;
  [[nodiscard]] const PlugMacros::Macro* Look(std::string_view name, const Names& asked_for) const;
  [[nodiscard]] bool HasValue(std::string_view name, std::string_view wanted, Names& asked_for,
                              const SourceLine& where);
  [[nodiscard]] bool NoneDefined(std::string_view names) const;

  const PlugMacros& macros_;
  bool is_strict_;
  std::vector<Branch> branches_;
  std::vector<ConfigProblem> warnings_;
};

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/mission/plug_condition.hpp"

#include <algorithm>
#include <string>

#include <fmt/format.h>

namespace limpet {
namespace {

std::vector<std::string_view> SplitAt(std::string_view text, std::string_view separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t end = text.find(separator);
    parts.push_back(Trim(text.substr(0, end)));
    if (end == std::string_view::npos) {
      return parts;
    }
    text.remove_prefix(end + separator.size());
  }
}

/// `M` or `M value`.
struct Term {
  std::string_view name;
  std::string_view value;
};
Term TermOf(std::string_view text) {
  const std::size_t end = std::min(text.find_first_of(" \t"), text.size());
  return {.name = text.substr(0, end), .value = Trim(text.substr(end))};
}

}  // namespace

bool PlugConditions::Takes(std::string_view directive, std::string_view rest,
                           const SourceLine& where) {
  // Inside a skipped branch conditions are not judged: they may be about macros of the other case.
  if (directive == "#ifdef") {
    Open(is_active() && Holds(rest, where), where);
  } else if (directive == "#ifndef") {
    Open(is_active() && NoneDefined(rest), where);
  } else if (directive == "#elseifdef") {
    const bool is_open = !branches_.empty() && branches_.back().is_parent_active;
    Next(directive, is_open && !branches_.back().was_taken && Holds(rest, where), where);
  } else if (directive == "#else") {
    Next(directive, true, where);
  } else if (directive == "#endif") {
    Next(directive, false, where);
    branches_.pop_back();
  } else {
    return false;
  }
  return true;
}

void PlugConditions::RequireClosed(const SourceLine& end) const {
  if (!branches_.empty()) {
    throw ConfigError({branches_.back().where, "#ifdef",
                       "has no #endif up to line " + std::to_string(end.line - 1)});
  }
}

void PlugConditions::Open(bool holds, const SourceLine& where) {
  branches_.push_back({is_active(), holds, holds, where});
}

void PlugConditions::Next(std::string_view directive, bool holds, const SourceLine& where) {
  if (branches_.empty()) {
    throw ConfigError({where, std::string(directive), "has no #ifdef before it"});
  }
  Branch& branch = branches_.back();
  branch.is_active = branch.is_parent_active && !branch.was_taken && holds;
  branch.was_taken = branch.was_taken || branch.is_active;
}

/// As nsplug judges, oddities included, so that a template gives the same mission here and there. A
/// macro set to nothing (`NAME=`) counts as undefined, but for `&&`; one without a value (`#define
/// NAME`) counts as defined.
bool PlugConditions::Holds(std::string_view condition, const SourceLine& where) {
  const bool has_or = condition.find("||") != std::string_view::npos;
  const bool has_and = condition.find("&&") != std::string_view::npos;
  if (has_or && has_and) {
    if (is_strict_) {
      throw ConfigError({where, "#ifdef", "mixes || and &&"});
    }
    warnings_.push_back({where, "#ifdef", "mixes || and &&: taken as false"});
    return false;
  }
  Names asked_for;
  const auto term_holds = [&](std::string_view term) {
    const Term words = TermOf(term);
    const PlugMacros::Macro* macro = Look(words.name, asked_for);
    if (words.value.empty()) {
      return macro != nullptr && (has_and || !macro->is_set_empty);
    }
    return (has_and || macro != nullptr) && HasValue(words.name, words.value, asked_for, where);
  };
  return has_and ? std::ranges::all_of(SplitAt(condition, "&&"), term_holds)
                 : std::ranges::any_of(SplitAt(condition, "||"), term_holds);
}

/// The macro; one set to nothing if it is undefined but an earlier term asked for its value.
const PlugMacros::Macro* PlugConditions::Look(std::string_view name, const Names& asked_for) const {
  static const PlugMacros::Macro kEmpty{.value = "", .is_set_empty = true};
  const PlugMacros::Macro* macro = macros_.Find(name);
  return macro == nullptr && asked_for.contains(name) ? &kEmpty : macro;
}

/// The macro has that value, or the value of the macro `wanted`. Undefined ones count as empty: so
/// an empty macro equals any word that is no macro, which is hardly ever meant.
bool PlugConditions::HasValue(std::string_view name, std::string_view wanted, Names& asked_for,
                              const SourceLine& where) {
  const PlugMacros::Macro* macro = Look(name, asked_for);
  asked_for.insert(name);
  if (macro != nullptr && !macro->is_set_empty && macro->value == wanted) {
    return true;
  }
  const PlugMacros::Macro* other = Look(wanted, asked_for);
  asked_for.insert(wanted);
  const bool is_empty = macro == nullptr || macro->is_set_empty;
  const bool is_other_empty = other == nullptr || other->is_set_empty;
  if (is_empty && is_other_empty) {
    warnings_.push_back(
        {where, "#ifdef",
         fmt::format("`{}` is {} and `{}` no macro with a value: as in nsplug the two are equal",
                     name, macro == nullptr ? "undefined" : "empty", wanted)});
  }
  return is_empty == is_other_empty && (is_empty || macro->value == other->value);
}

bool PlugConditions::NoneDefined(std::string_view names) const {
  const bool names_any = !names.empty();
  while (!names.empty()) {
    const std::size_t end = std::min(names.find_first_of(" \t"), names.size());
    const PlugMacros::Macro* macro = macros_.Find(names.substr(0, end));
    if (macro != nullptr && !macro->is_set_empty) {
      return false;
    }
    names = Trim(names.substr(end));
  }
  return names_any;
}

}  // namespace limpet

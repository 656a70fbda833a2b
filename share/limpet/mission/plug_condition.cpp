// SPDX-License-Identifier: MIT
#include "limpet/mission/plug_condition.hpp"

#include <algorithm>
#include <string>

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

bool PlugConditions::Holds(std::string_view condition, const SourceLine& where) const {
  const bool has_or = condition.find("||") != std::string_view::npos;
  const bool has_and = condition.find("&&") != std::string_view::npos;
  if (has_or && has_and) {
    if (is_strict_) {
      throw ConfigError({where, "#ifdef", "mixes || and &&"});
    }
    return false;
  }
  const auto term_holds = [this](std::string_view term) { return TermHolds(term); };
  return has_and ? std::ranges::all_of(SplitAt(condition, "&&"), term_holds)
                 : std::ranges::any_of(SplitAt(condition, "||"), term_holds);
}

/// `M`, `M value`, or `A B` with two macros of equal value.
bool PlugConditions::TermHolds(std::string_view term) const {
  const std::size_t end = std::min(term.find_first_of(" \t"), term.size());
  const auto value = macros_.Find(term.substr(0, end));
  const std::string_view wanted = Trim(term.substr(end));
  if (!value || wanted.empty()) {
    return value.has_value();
  }
  return *value == wanted || macros_.Find(wanted) == value;
}

bool PlugConditions::NoneDefined(std::string_view names) const {
  while (!names.empty()) {
    const std::size_t end = std::min(names.find_first_of(" \t"), names.size());
    if (macros_.Has(names.substr(0, end))) {
      return false;
    }
    names = Trim(names.substr(end));
  }
  return true;
}

}  // namespace limpet

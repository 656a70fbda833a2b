// SPDX-License-Identifier: MIT
#include "limpet/mission/plug_macros.hpp"

#include <algorithm>
#include <utility>

#include "limpet/core/letter_case.hpp"

namespace limpet {
namespace {

constexpr int kMaxRounds = 100;

/// One `$(...)` or `%(...)` in a line.
struct Use {
  std::size_t begin = 0;
  std::size_t end = 0;  ///< one past the closing parenthesis
  std::string_view name;
  std::optional<std::string_view> fallback;
  bool falls_back_when_empty = false;
  bool is_upper = false;
};

bool IsMacroStart(std::string_view line, std::size_t at) {
  return at + 1 < line.size() && (line[at] == '$' || line[at] == '%') && line[at + 1] == '(';
}

/// Names are whatever stands before `)`, `=` or `:=`: templates use odd ones.
std::size_t EndOfName(std::string_view line, std::size_t begin) {
  const std::size_t end = line.find_first_of(")=($%", begin);
  const bool has_colon =
      end != std::string_view::npos && end > begin && line[end] == '=' && line[end - 1] == ':';
  return has_colon ? end - 1 : end;
}

/// For each `(` the place of its `)`, in one pass: searching from each would take the square of a
/// line that only opens.
std::vector<std::size_t> ClosingParentheses(std::string_view line) {
  std::vector<std::size_t> closing(line.size(), std::string_view::npos);
  std::vector<std::size_t> open;
  for (std::size_t i = line.find_first_of("()"); i != std::string_view::npos;
       i = line.find_first_of("()", i + 1)) {
    if (line[i] == '(') {
      open.push_back(i);
    } else if (!open.empty()) {
      closing[open.back()] = i;
      open.pop_back();
    }
  }
  return closing;
}

/// The macro use that begins at `begin`, if one does.
std::optional<Use> UseAt(std::string_view line, std::size_t begin,
                         const std::vector<std::size_t>& closing) {
  const std::size_t at = EndOfName(line, begin + 2);
  if (at == std::string_view::npos || at == begin + 2) {
    return std::nullopt;
  }
  Use use{.begin = begin,
          .end = at + 1,
          .name = line.substr(begin + 2, at - begin - 2),
          .fallback = {},
          .falls_back_when_empty = line.substr(at).starts_with(":="),
          .is_upper = line[begin] == '%'};
  if (line[at] == ')') {
    return use;
  }
  const std::size_t equals = at + (use.falls_back_when_empty ? 1 : 0);
  const std::size_t close = closing[begin + 1];
  if (line[equals] != '=' || close == std::string_view::npos) {
    return std::nullopt;
  }
  use.fallback = line.substr(equals + 1, close - equals - 1);
  use.end = close + 1;
  return use;
}

}  // namespace

bool PlugMacros::Define(std::string_view name, Macro macro) {
  const auto [position, is_new] = values_.try_emplace(std::string(name), macro);
  const bool is_changed = !is_new && position->second.value != macro.value;
  position->second = std::move(macro);
  return is_changed;
}

const PlugMacros::Macro* PlugMacros::Find(std::string_view name) const {
  const auto found = values_.find(name);
  return found == values_.end() ? nullptr : &found->second;
}

std::vector<std::string> PlugMacros::Names() const {
  std::vector<std::string> names;
  std::ranges::transform(values_, std::back_inserter(names), [](const auto& v) { return v.first; });
  return names;
}

PlugMacros::Expansion PlugMacros::Expand(std::string_view line) {
  Expansion expansion{.text = std::string(line), .left = {}, .unknown = {}};
  const std::size_t most = kMaxLineBytes + line.size();
  int round = 0;
  while (round < kMaxRounds && ExpandOnce(expansion, most)) {
    ++round;
  }
  const std::size_t use = std::min(expansion.text.find("$("), expansion.text.find("%("));
  expansion.is_endless = round == kMaxRounds && use != std::string::npos;
  if (expansion.is_endless && expansion.left.empty()) {
    expansion.left = expansion.text.substr(use, expansion.text.find(')', use) - use + 1);
  }
  return expansion;
}

/// Replaces every use of the line once; false when nothing more can be replaced.
bool PlugMacros::ExpandOnce(Expansion& expansion, std::size_t most) {
  const std::string_view line = expansion.text;
  expansion.left.clear();
  expansion.unknown.clear();
  const std::size_t first = std::min(line.find("$("), line.find("%("));
  if (first == std::string_view::npos) {
    return false;
  }
  const std::vector<std::size_t> closing = ClosingParentheses(line);
  std::string out(line.substr(0, first));
  bool is_changed = false;
  std::size_t at = first;
  while (at < line.size()) {
    if (!IsMacroStart(line, at)) {
      const std::size_t next = std::min(line.find_first_of("$%", at + 1), line.size());
      out += line.substr(at, next - at);
      at = next;
      continue;
    }
    const std::optional<Use> use = UseAt(line, at, closing);
    const Macro* macro = use ? Find(use->name) : nullptr;
    const bool is_usable =
        macro != nullptr && !(macro->value.empty() && use->falls_back_when_empty);
    if (is_usable || (use && use->fallback)) {
      const std::string_view text = is_usable ? macro->value : *use->fallback;
      out += use->is_upper ? UpperCase(text) : std::string(text);
      is_changed = true;
      at = use->end;
    } else {
      const std::size_t end = use ? use->end : at + 2;
      if (expansion.left.empty()) {
        expansion.left = std::string(line.substr(at, end - at));
        expansion.unknown = use ? std::string(use->name) : "";
      }
      out += line.substr(at, end - at);
      at = end;
    }
    if (out.size() > most || work_bytes_ + out.size() > kMaxWorkBytes) {
      expansion.is_too_long = true;
      return false;
    }
  }
  work_bytes_ += out.size();
  expansion.text = std::move(out);
  return is_changed;
}

}  // namespace limpet

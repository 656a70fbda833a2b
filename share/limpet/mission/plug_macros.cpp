// SPDX-License-Identifier: MIT
#include "limpet/mission/plug_macros.hpp"

#include <algorithm>
#include <cctype>

namespace limpet {
namespace {

constexpr int kMaxRounds = 100;
constexpr std::size_t kMaxLineBytes = std::size_t{1} << 20U;

/// One `$(...)` or `%(...)` in a line.
struct Use {
  std::size_t begin = 0;
  std::size_t end = 0;  ///< one past the closing parenthesis
  std::string_view name;
  std::optional<std::string_view> fallback;
  bool falls_back_when_empty = false;
  bool is_upper = false;
};

bool IsNameLetter(char letter) {
  return std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '_' || letter == '-' ||
         letter == '.';
}

std::size_t ClosingParenthesis(std::string_view line, std::size_t open) {
  int depth = 0;
  for (std::size_t i = open; i < line.size(); ++i) {
    depth += line[i] == '(' ? 1 : 0;
    depth -= line[i] == ')' ? 1 : 0;
    if (depth == 0) {
      return i;
    }
  }
  return std::string_view::npos;
}

/// The macro use that begins at `begin`, if one does.
std::optional<Use> UseAt(std::string_view line, std::size_t begin) {
  if (begin + 1 >= line.size() || (line[begin] != '$' && line[begin] != '%') ||
      line[begin + 1] != '(') {
    return std::nullopt;
  }
  std::size_t at = begin + 2;
  while (at < line.size() && IsNameLetter(line[at])) {
    ++at;
  }
  Use use{.begin = begin,
          .end = at + 1,
          .name = line.substr(begin + 2, at - begin - 2),
          .fallback = {},
          .falls_back_when_empty = false,
          .is_upper = line[begin] == '%'};
  if (use.name.empty() || at >= line.size()) {
    return std::nullopt;
  }
  if (line[at] == ')') {
    return use;
  }
  use.falls_back_when_empty = line.substr(at).starts_with(":=");
  const std::size_t equals = at + (use.falls_back_when_empty ? 1 : 0);
  const std::size_t close = ClosingParenthesis(line, begin + 1);
  if (line[equals] != '=' || close == std::string_view::npos) {
    return std::nullopt;
  }
  use.fallback = line.substr(equals + 1, close - equals - 1);
  use.end = close + 1;
  return use;
}

std::string Upper(std::string_view text) {
  std::string upper(text);
  std::ranges::transform(upper, upper.begin(), [](char letter) {
    return static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
  });
  return upper;
}

}  // namespace

bool PlugMacros::Define(std::string_view name, std::string_view value) {
  const auto [position, is_new] = values_.try_emplace(std::string(name), value);
  const bool is_changed = !is_new && position->second != value;
  position->second = value;
  return is_changed;
}

std::optional<std::string_view> PlugMacros::Find(std::string_view name) const {
  const auto found = values_.find(name);
  return found == values_.end() ? std::nullopt : std::optional<std::string_view>(found->second);
}

std::vector<std::string> PlugMacros::Names() const {
  std::vector<std::string> names;
  std::ranges::transform(values_, std::back_inserter(names), [](const auto& v) { return v.first; });
  return names;
}

PlugMacros::Expansion PlugMacros::Expand(std::string_view line) const {
  Expansion expansion{.text = std::string(line), .undefined = {}};
  for (int round = 0; round < kMaxRounds && ExpandOnce(expansion); ++round) {
  }
  return expansion;
}

/// Replaces every use of the line once; false when nothing more can be replaced.
bool PlugMacros::ExpandOnce(Expansion& expansion) const {
  const std::string_view line = expansion.text;
  std::string out;
  bool is_changed = false;
  expansion.undefined.clear();
  std::size_t at = 0;
  while (at < line.size()) {
    const std::optional<Use> use = UseAt(line, at);
    if (!use) {
      out += line[at++];
      continue;
    }
    const std::optional<std::string_view> value = Find(use->name);
    const bool is_usable = value && !(value->empty() && use->falls_back_when_empty);
    if (is_usable || use->fallback) {
      const std::string_view text = is_usable ? *value : *use->fallback;
      out += use->is_upper ? Upper(text) : std::string(text);
      is_changed = true;
    } else {
      expansion.undefined.emplace_back(use->name);
      out += line.substr(use->begin, use->end - use->begin);
    }
    at = use->end;
    if (out.size() > kMaxLineBytes) {
      expansion.is_too_long = true;
      return false;
    }
  }
  expansion.text = std::move(out);
  return is_changed;
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/mission/flag.hpp"

#include <fmt/format.h>

#include "limpet/core/config.hpp"
#include "limpet/core/number_text.hpp"

namespace limpet {
namespace {

bool IsQuoted(std::string_view text) {
  return text.size() >= 2 && text.starts_with('"') && text.ends_with('"');
}

std::size_t FindIf(std::string_view text) {
  for (std::size_t at = text.find('['); at != std::string_view::npos; at = text.find('[', at + 1)) {
    if (EqualsIgnoringCase(text.substr(at, 4), "[if]")) {
      return at;
    }
  }
  return std::string_view::npos;
}

/// Takes a leading word off `text`.
std::string_view TakeWord(std::string_view& text) {
  const std::size_t end = std::min(text.find_first_of(" \t"), text.size());
  const std::string_view word = text.substr(0, end);
  text = Trim(text.substr(end));
  return word;
}

void TakePrefixes(std::string_view& text, Flag& flag) {
  while (text.starts_with('@') || text.starts_with('#') || text.starts_with('<') ||
         text.starts_with('>')) {
    std::string_view word = TakeWord(text);
    if (word.starts_with('#')) {
      flag.is_also_local = word.ends_with('+');
      word.remove_suffix(flag.is_also_local ? 1 : 0);
      flag.group = std::string(word.substr(1));
    } else {
      flag.tag = std::string(word.starts_with('@') ? word.substr(1) : word);
    }
  }
}

/// Calls `take` with each macro and what stands between; false if there is no macro at all.
struct MacroUse {
  std::size_t begin;
  std::size_t end;
  std::string_view name;
};
std::optional<MacroUse> NextMacro(std::string_view text, std::size_t from, bool has_parentheses) {
  for (std::size_t at = text.find('$', from); at != std::string_view::npos;
       at = text.find('$', at + 1)) {
    const char open = at + 1 < text.size() ? text[at + 1] : '\0';
    if (open == '[' || (open == '(' && has_parentheses)) {
      const std::size_t close = text.find(open == '[' ? ']' : ')', at);
      if (close != std::string_view::npos) {
        return MacroUse{at, close + 1, text.substr(at + 2, close - at - 2)};
      }
    }
  }
  return std::nullopt;
}

}  // namespace

Value ValueOfText(std::string_view text) {
  text = Trim(text);
  if (IsQuoted(text)) {
    return std::string(text.substr(1, text.size() - 2));
  }
  const std::optional<double> number = ParseNumber(text);
  return number ? Value(*number) : Value(std::string(text));
}

Expected<Flag> Flag::Parse(std::string_view text) {
  Flag flag;
  text = Trim(text);
  if (const std::size_t at = FindIf(text); at != std::string_view::npos) {
    Expected<Condition> condition = Condition::Parse(text.substr(at + 4));
    if (!condition) {
      return condition.error();
    }
    flag.condition = *std::move(condition);
    text = Trim(text.substr(0, at));
  }
  TakePrefixes(text, flag);
  const std::size_t equals = text.find('=');
  flag.variable = std::string(Trim(text.substr(0, equals)));
  if (equals == std::string_view::npos || flag.variable.empty() ||
      flag.variable.find_first_of(" \t") != std::string::npos) {
    return Error{fmt::format("`{}` is not VARIABLE = value", text)};
  }
  flag.text = std::string(Trim(text.substr(equals + 1)));
  if (flag.text.empty()) {
    return Error{fmt::format("`{}` has no value", flag.variable)};
  }
  return flag;
}

Value Flag::Resolve(const MacroLookup& macros) const {
  const auto macro = NextMacro(text, 0, has_parenthesis_macros);
  if (!macro) {
    return ValueOfText(text);
  }
  std::string expanded = ExpandRuntimeMacros(text, macros, has_parenthesis_macros);
  const bool is_one_macro = macro->begin == 0 && macro->end == text.size();
  if (is_one_macro) {
    return ValueOfText(expanded);
  }
  const bool is_quoted = IsQuoted(expanded);
  return is_quoted ? expanded.substr(1, expanded.size() - 2) : std::move(expanded);
}

std::string ExpandRuntimeMacros(std::string_view text, const MacroLookup& macros,
                                bool has_parenthesis_macros) {
  std::string out;
  std::size_t done = 0;
  for (auto use = NextMacro(text, 0, has_parenthesis_macros); use;
       use = NextMacro(text, done, has_parenthesis_macros)) {
    out += text.substr(done, use->begin - done);
    const std::optional<std::string> value = macros(use->name);
    out += value ? std::string_view(*value) : text.substr(use->begin, use->end - use->begin);
    done = use->end;
  }
  return out.append(text.substr(done));
}

}  // namespace limpet

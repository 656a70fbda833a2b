// SPDX-License-Identifier: MIT
// The help of a command. CLI11 2.1 would write one, too, but neither wraps it to the width of a
// terminal nor puts a default in words (`one per core`).
#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "limpet/console/command.hpp"
#include "limpet/core/config.hpp"

namespace limpet {
namespace {

constexpr std::size_t kWidth = 80;  // [columns], of the narrowest terminal in use
constexpr std::size_t kMostLeft = 26;

/// Words from column `indent` on, where the first line already is.
std::string Wrapped(std::string_view text, std::size_t indent) {
  std::string result;
  std::size_t column = indent;
  for (const std::string& word : Split(text, ' ')) {
    if (word.empty()) continue;
    const bool is_first = column == indent;
    if (!is_first && column + 1 + word.size() > kWidth) {
      result += "\n" + std::string(indent, ' ');
      column = indent;
    } else if (!is_first) {
      result += ' ';
      ++column;
    }
    result += word;
    column += word.size();
  }
  return result + "\n";
}

/// Lines that begin with a blank stay; others flow together up to an empty line.
std::string Flowed(std::string_view text) {
  std::string result, paragraph;
  const auto flush = [&] {
    if (!paragraph.empty()) result += Wrapped(paragraph, 0);
    paragraph.clear();
  };
  while (text.ends_with('\n'))
    text.remove_suffix(1);
  for (const std::string& line : Split(text, '\n')) {
    if (line.empty() || line.front() == ' ') {
      flush();
      result += line + "\n";
    } else {
      paragraph += (paragraph.empty() ? "" : " ") + line;
    }
  }
  flush();
  return result;
}

/// `--out DIR`, `-p, --path DIR`. Of several long names the first: others are for old habits.
std::string LeftOf(const CommandOption& option) {
  std::string left;
  bool has_long = false;
  for (const std::string& name : Split(option.names, ',')) {
    if (has_long && name.starts_with("--")) continue;
    has_long = has_long || name.starts_with("--");
    left += (left.empty() ? "" : ", ") + name;
  }
  return left + (option.value.empty() ? "" : " " + option.value);
}

std::string RightOf(const CommandOption& option) {
  std::string right = option.meaning;
  if (option.is_repeatable) right += "; repeatable";
  if (!option.fallback.empty()) right += fmt::format(" (default {})", option.fallback);
  return right;
}

std::string UsageOf(const Command& command) {
  std::string usage = "usage: " + command.name;
  if (!command.words.empty()) usage += " " + command.words;
  bool has_more = false;
  for (const CommandOption& option : command.options) {
    if (option.is_required) usage += " " + LeftOf(option);
    has_more = has_more || !option.is_required;
  }
  // Wrapped lines stand under what follows the command's name.
  const std::size_t indent = std::string_view("usage: ").size() + command.name.size() + 1;
  usage += has_more ? " [options]" : "";
  return usage.size() <= kWidth || usage.size() <= indent
             ? usage + "\n"
             : usage.substr(0, indent) + Wrapped(usage.substr(indent), indent);
}

std::string OptionsOf(const Command& command) {
  std::vector<CommandOption> options = command.options;
  options.push_back({.names = "-h,--help", .meaning = "this text"});
  std::size_t left = 0;
  for (const CommandOption& option : options) {
    left = std::max(left, std::min(LeftOf(option).size(), kMostLeft));
  }
  std::string text;
  for (const CommandOption& option : options) {
    const std::string name = LeftOf(option);
    text += "  " + name;
    // A long name has its line to itself.
    text += name.size() > left ? "\n" + std::string(left + 4, ' ')
                               : std::string(left + 2 - name.size(), ' ');
    text += Wrapped(RightOf(option), left + 4);
  }
  return text;
}

}  // namespace

std::string HelpText(const Command& command) {
  std::string text = UsageOf(command);
  if (!command.about.empty()) text += "\n" + Flowed(command.about);
  text += "\n" + OptionsOf(command);
  if (!command.more.empty()) text += "\n" + Flowed(command.more);
  return text;
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/core/config.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

#include <fmt/format.h>

#include "limpet/core/config_entries.hpp"
#include "limpet/core/harmless_text.hpp"
#include "limpet/core/word_distance.hpp"

namespace limpet {
namespace {

char Lower(char letter) {
  return static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
}

std::string Join(const std::vector<ConfigProblem>& problems) {
  std::string text;
  for (const ConfigProblem& problem : problems) {
    text += (text.empty() ? "" : "\n") + problem.Format();
  }
  return text;
}

}  // namespace

const ConfigEntry* FindEntry(const std::vector<ConfigEntry>& entries, std::string_view key) {
  const auto found = std::ranges::find_if(
      entries, [key](const ConfigEntry& entry) { return EqualsIgnoringCase(entry.key, key); });
  return found == entries.end() ? nullptr : &*found;
}

const ConfigEntry* ConfigBlock::Find(std::string_view key) const { return FindEntry(entries, key); }

std::string ConfigProblem::Format() const {
  std::string place = where.file;
  if (where.line > 0) place += fmt::format(":{}", where.line);
  const auto led = [](const std::string& part) { return part.empty() ? "" : part + ": "; };
  return HarmlessText(led(place) + led(key) + text);
}

ConfigError::ConfigError(std::vector<ConfigProblem> problems)
    : std::runtime_error(Join(problems)), problems_(std::move(problems)) {}
ConfigError::ConfigError(ConfigProblem problem)
    : ConfigError(std::vector<ConfigProblem>{std::move(problem)}) {}

std::string NearestWord(std::string_view word, const std::vector<std::string>& candidates) {
  std::size_t best_distance = word.size() / 2 + 1;  // farther than half the word is another word
  std::string best;
  for (const std::string& candidate : candidates) {
    const std::size_t distance = WordDistance(word, candidate);
    if (distance < best_distance) {
      best_distance = distance;
      best = candidate;
    }
  }
  return best;
}

bool EqualsIgnoringCase(std::string_view a, std::string_view b) {
  return std::ranges::equal(a, b, {}, Lower, Lower);
}

std::string_view Trim(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) {
    return {};
  }
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

std::vector<std::string> Split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  while (true) {
    const std::size_t end = text.find(separator, begin);
    parts.emplace_back(text.substr(begin, end - begin));
    if (end == std::string_view::npos) {
      return parts;
    }
    begin = end + 1;
  }
}

}  // namespace limpet

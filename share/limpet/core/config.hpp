// SPDX-License-Identifier: MIT
// Configuration text with its origin, so that every complaint can name file and line.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace limpet {

struct SourceLine {
  std::string file;
  int line = 0;
};

struct ConfigEntry {
  std::string key;
  std::string value;
  SourceLine where;
};

/// One complaint: `file:line: key: text`.
struct ConfigProblem {
  SourceLine where;
  std::string key;
  std::string text;

  /// One line; nothing of the file in it is obeyed by a terminal.
  [[nodiscard]] std::string Format() const;
};

/// One ProcessConfig or Behavior block, in file order. Keys may repeat; they compare without case.
struct ConfigBlock {
  std::string name;
  SourceLine where;
  std::vector<ConfigEntry> entries;
  /// Lines that are no `key = value`, nested braces, ...: errors to the app whose block it is
  /// (ApplyBlock reports them); the blocks of others may hold any text.
  std::vector<ConfigProblem> problems{};

  /// First entry of `key`, or nullptr.
  [[nodiscard]] const ConfigEntry* Find(std::string_view key) const;
};

/// An impossible configuration; thrown while loading or constructing, never later.
class ConfigError : public std::runtime_error {
 public:
  explicit ConfigError(std::vector<ConfigProblem> problems);
  explicit ConfigError(ConfigProblem problem);
  [[nodiscard]] const std::vector<ConfigProblem>& problems() const { return problems_; }

 private:
  std::vector<ConfigProblem> problems_;
};

/// The candidate nearest to `word` in edit distance (case ignored), or "" if none is near enough to
/// be meant.
[[nodiscard]] std::string NearestWord(std::string_view word,
                                      const std::vector<std::string>& candidates);

[[nodiscard]] bool EqualsIgnoringCase(std::string_view a, std::string_view b);
[[nodiscard]] std::string_view Trim(std::string_view text);
[[nodiscard]] std::vector<std::string> Split(std::string_view text, char separator);

}  // namespace limpet

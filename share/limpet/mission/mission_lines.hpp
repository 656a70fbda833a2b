// SPDX-License-Identifier: MIT
// How MOOS reads one line of a mission file: comments, quotes, `key = value`, `${NAME}`.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/core/config.hpp"
#include "limpet/mission/source_text.hpp"

namespace limpet {

/// Removes the comment and outer blanks, and the first pair of double quotes (`//` inside it is
/// text) unless `keeps_quotes`.
[[nodiscard]] std::string CleanMissionLine(std::string_view line, bool keeps_quotes);

/// `key = value`, both trimmed; `key` is empty if there is no `=`.
struct KeyValue {
  std::string key;
  std::string value;
  bool has_equals = false;
};
[[nodiscard]] KeyValue SplitKeyValue(std::string_view line);

/// Takes a byte order mark off the text of a file; what there is to note of it.
[[nodiscard]] std::optional<ConfigProblem> PassByteOrderMark(std::string_view& text,
                                                             const std::string& file);

/// True for the key of a line that begins a block: MOOS ignores case and white space in it.
[[nodiscard]] bool IsBlockHeader(std::string_view key);

/// A line of a block that is neither a comment nor `key = value`. MOOS drops it.
[[nodiscard]] ConfigProblem BareLine(const TextLine& line, const std::string& block);
/// True for what MOOS passes over in a block of its own programs: a bare line, and a `${NAME}` that
/// nothing defines, of which it leaves the name.
[[nodiscard]] bool IsPassedOver(const ConfigProblem& problem);

/// The values of `${NAME}`: every `NAME = value` line of the file, last one first, then the
/// environment.
class MissionVariables {
 public:
  void Learn(const std::vector<TextLine>& lines);
  /// Most bytes of all lines of a file: many uses of a long value grow with the square of the file.
  static constexpr std::size_t kMaxBytes = std::size_t{4} << 20U;

  /// Replaces each `${NAME}` once. Unknown ones lose their braces, as in MOOS, and are problems.
  /// Throws ConfigError beyond kMaxBytes.
  [[nodiscard]] std::string Substitute(const TextLine& line, std::vector<ConfigProblem>& problems);

 private:
  std::size_t bytes_ = 0;  ///< of all values put in
  std::map<std::string, std::string, std::less<>> values_;
};

}  // namespace limpet

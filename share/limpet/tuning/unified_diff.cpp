// SPDX-License-Identifier: MIT
#include "limpet/tuning/unified_diff.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "limpet/core/config.hpp"

namespace limpet {
namespace {

constexpr int kContext = 3;

/// A file's lines with their carriage returns; whether the last one has an end.
struct RawLines {
  std::vector<std::string> lines;
  bool has_last_end = true;

  explicit RawLines(const std::string& text) : lines(Split(text, '\n')) {
    has_last_end = text.empty() || text.back() == '\n';
    if (has_last_end && !lines.empty()) lines.pop_back();
  }
  [[nodiscard]] int count() const { return static_cast<int>(lines.size()); }
  [[nodiscard]] const std::string& At(int line) const {
    return lines[static_cast<std::size_t>(line) - 1];
  }
  /// `text` ended as this file ends its lines.
  [[nodiscard]] std::string Ended(const std::string& text) const {
    const bool has_returns = !lines.empty() && lines.front().ends_with('\r');
    return has_returns ? text + "\r" : text;
  }
};

class DiffWriter {
 public:
  DiffWriter(const RawLines& old_lines, const std::vector<LineEdit>& edits)
      : old_(old_lines), edits_(edits) {}

  /// Hunks, nearby edits in one.
  std::string Hunks() {
    std::string text;
    for (std::size_t first = 0; first < edits_.size();) {
      std::size_t last = first;
      while (last + 1 < edits_.size() &&
             edits_[last + 1].line - edits_[last].line <= 2 * kContext + 1)
        ++last;
      text += Hunk(first, last);
      first = last + 1;
    }
    return text;
  }

 private:
  std::string Hunk(std::size_t first, std::size_t last) {
    const int begin =
        std::max(1, edits_[first].line - kContext + (edits_[first].is_inserted ? 1 : 0));
    const int end = std::min(old_.count(), edits_[last].line + kContext);
    body_.clear();
    old_count_ = new_count_ = 0;
    std::size_t edit = first;
    for (; edit <= last && edits_[edit].line == 0; ++edit)
      Add('+', old_.Ended(edits_[edit].text));
    for (int line = begin; line <= end; ++line)
      edit = WriteLine(line, edit, last);
    const int new_begin = begin + shift_;
    shift_ += new_count_ - old_count_;
    // Of an empty file the hunk begins before its first line.
    return fmt::format("@@ -{},{} +{},{} @@\n{}", old_count_ == 0 ? 0 : begin, old_count_,
                       new_begin, new_count_, body_);
  }

  /// One line of the old text with the edits at it; the first edit that is left.
  std::size_t WriteLine(int line, std::size_t edit, std::size_t last) {
    const bool is_last_line = line == old_.count() && !old_.has_last_end;
    const bool is_replaced = edit <= last && edits_[edit].line == line && !edits_[edit].is_inserted;
    const auto insertions = std::count_if(
        edits_.begin() + static_cast<std::ptrdiff_t>(edit),
        edits_.begin() + static_cast<std::ptrdiff_t>(last) + 1,
        [line](const LineEdit& each) { return each.line == line && each.is_inserted; });
    // A line that lacks its end gets one when others follow it.
    const bool changes_end = is_last_line && insertions > 0 && !is_replaced;
    Add(is_replaced || changes_end ? '-' : ' ', old_.At(line), is_last_line);
    if (changes_end) Add('+', old_.At(line));
    if (is_replaced) Add('+', old_.Ended(edits_[edit++].text), is_last_line && insertions == 0);
    for (; edit <= last && edits_[edit].line == line; ++edit)
      Add('+', old_.Ended(edits_[edit].text));
    return edit;
  }

  void Add(char sign, const std::string& line, bool lacks_end = false) {
    body_ += fmt::format("{}{}\n", sign, line);
    if (lacks_end) body_ += "\\ No newline at end of file\n";
    old_count_ += sign != '+' ? 1 : 0;
    new_count_ += sign != '-' ? 1 : 0;
  }

  const RawLines& old_;
  const std::vector<LineEdit>& edits_;
  std::string body_;
  int old_count_ = 0, new_count_ = 0;
  int shift_ = 0;  ///< lines that earlier hunks have added
};

}  // namespace

std::string UnifiedDiff(const std::string& name, const std::string& text,
                        std::vector<LineEdit> edits) {
  if (edits.empty()) return "";
  std::ranges::stable_sort(edits, [](const LineEdit& a, const LineEdit& b) {
    return a.line != b.line ? a.line < b.line : !a.is_inserted && b.is_inserted;
  });
  const RawLines lines(text);
  return fmt::format("--- a/{0}\n+++ b/{0}\n{1}", name, DiffWriter(lines, edits).Hunks());
}

}  // namespace limpet

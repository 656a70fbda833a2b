// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdio>
#include <optional>
#include <string>

namespace limpet {

/// Progress of long work: one line rewritten in place on a terminal, cut to its present width,
/// otherwise a plain line about every tenth of the way. Nothing in its texts is obeyed by a
/// terminal. Writes to stderr by default, so that results on stdout stay clean.
class ProgressLine {
 public:
  explicit ProgressLine(const std::string& label, std::FILE* out = stderr);
  /// A terminal's line is closed when the work ends.
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// `done` from 0 to 1; `detail` says what is going on. Cheap to call often.
  void Update(double done, const std::string& detail);
  /// Like Update, but writes whether due or not: for what must be told.
  void Announce(double done, const std::string& detail);
  /// True when Update would write: lets the caller skip composing a detail.
  [[nodiscard]] bool IsDue(double done) const;
  /// A line of its own above the progress.
  void Note(const std::string& text);

 private:
  [[nodiscard]] std::string LineFor(double done, const std::string& detail) const;

  std::string label_;
  std::FILE* out_;
  bool is_terminal_;
  bool has_open_line_ = false;
  std::optional<double> last_done_;  ///< as last announced
  std::chrono::steady_clock::time_point last_time_{};
};

}  // namespace limpet

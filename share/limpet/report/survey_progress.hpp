// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "limpet/console/progress_line.hpp"
#include "limpet/scoring/session_record.hpp"

namespace limpet {

/// What a phase of the survey is about, in a few words; empty for a phase that coverage speaks for.
[[nodiscard]] std::string TextOfPhase(const std::string& phase);

/// Tells of a session under way: a line on each change of phase, and coverage as it grows.
class SurveyProgress {
 public:
  explicit SurveyProgress(const std::string& session, std::FILE* out = stderr)
      : line_(session, out) {}
  /// After any message that `record` collected; cheap to call often.
  void Show(const SessionRecord& record);

 private:
  /// Warnings raised and cleared since the last call, each on a line of its own.
  void TellWarnings(const SessionRecord& record);
  /// The first few times of a warning only: one that comes and goes must not flood the terminal.
  void TellWarning(const WarningRecord& warning, Seconds time, const std::string& what);

  ProgressLine line_;
  std::vector<bool> is_clearing_told_;     ///< of each warning told
  std::map<std::string, int> times_told_;  ///< by app and id
  std::optional<Seconds> begun_;
  std::size_t phases_told_ = 0;
};

}  // namespace limpet

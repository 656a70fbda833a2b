// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "limpet/console/progress_line.hpp"
#include "apps/limpet/report/session_record.hpp"

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
  ProgressLine line_;
  std::size_t phases_told_ = 0;
};

}  // namespace limpet

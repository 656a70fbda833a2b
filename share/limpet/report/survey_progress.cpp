// SPDX-License-Identifier: MIT
#include "limpet/report/survey_progress.hpp"

#include <map>

#include <fmt/format.h>

#include "limpet/topics/survey_phase.hpp"

namespace limpet {
namespace {

std::string DetailOf(const SessionRecord& record, const Coverage& coverage) {
  const std::string& phase = record.phases.back().value;
  const std::string text = TextOfPhase(phase);
  if (!text.empty()) return fmt::format("{:<7} {}", phase, text);
  return fmt::format("{:<7} seabed {:3.0f} %  band {:3.0f} %  objects {}", phase,
                     100.0 * coverage.seabed, 100.0 * coverage.band, record.opis.size());
}

}  // namespace

std::string TextOfPhase(const std::string& phase) {
  switch (SurveyPhaseOf(phase).value_or(SurveyPhase::kIdle)) {
    case SurveyPhase::kAlign:
      return "waiting at the surface for a good fix";
    case SurveyPhase::kDive:
      return "diving to survey altitude";
    case SurveyPhase::kReturn:
      return "on the way home";
    case SurveyPhase::kAscend:
      return "coming up";
    case SurveyPhase::kFix:
      return "last fixes at the surface";
    case SurveyPhase::kDone:
      return "ended";
    case SurveyPhase::kIdle:
    case SurveyPhase::kSurvey:  // there figures say more
      break;
  }
  return "";
}

void SurveyProgress::TellWarning(const WarningRecord& warning, Seconds time,
                                 const std::string& what) {
  constexpr int kMostLines = 6;
  const std::string name =
      fmt::format("{} {} ({})", warning.app, warning.id, NameOf(warning.severity));
  const int told = ++times_told_[name];
  if (told > kMostLines) {
    return;
  }
  line_.Note(fmt::format("{:.0f} s: {}{}{}", (time - begun_.value_or(time)).value(), name, what,
                         told == kMostLines ? " (and so on; all are in report.json)" : ""));
}

void SurveyProgress::TellWarnings(const SessionRecord& record) {
  begun_ = record.begun;
  for (std::size_t i = 0; i < record.warnings.size(); ++i) {
    const WarningRecord& warning = record.warnings[i];
    if (i == is_clearing_told_.size()) {
      is_clearing_told_.push_back(false);
      TellWarning(warning, warning.from, ": " + warning.text);
    }
    if (warning.to && !is_clearing_told_[i]) {
      is_clearing_told_[i] = true;
      TellWarning(warning, *warning.to, " is over");
    }
  }
}

void SurveyProgress::Show(const SessionRecord& record) {
  TellWarnings(record);
  if (record.phases.empty()) return;
  const Coverage coverage =
      record.believed_coverage.empty() ? Coverage{} : record.believed_coverage.back().value;
  if (record.phases.size() > phases_told_) {
    phases_told_ = record.phases.size();
    line_.Announce(coverage.band_top, DetailOf(record, coverage));
  } else if (line_.IsDue(coverage.band_top)) {
    line_.Update(coverage.band_top, DetailOf(record, coverage));
  }
}

}  // namespace limpet

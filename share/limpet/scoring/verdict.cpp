// SPDX-License-Identifier: MIT
#include "limpet/scoring/verdict.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace limpet {

int StatusesRight(const SessionScore& session) {
  return static_cast<int>(
      std::count_if(session.opis.changes.begin(), session.opis.changes.end(),
                    [](const ChangeScore& change) { return change.is_right(); }));
}

bool IsHome(const SessionScore& session) {
  return session.ended == "home" && session.home_error_m && *session.home_error_m <= kHomeRadius;
}

namespace {

Verdict UnjudgedVerdict(const RunScore& run, std::size_t unjudged) {
  std::size_t reported = 0;
  for (const SessionScore& session : run.sessions) {
    reported += session.opis.reported.size() + session.opis.found.size();
  }
  return {
      .is_good = false,
      .is_judged = false,
      .text = fmt::format("no truth in {} of {} sessions: nothing is judged; {} objects reported",
                          unjudged, run.sessions.size(), reported)};
}

}  // namespace

Verdict VerdictOf(const RunScore& run) {
  const auto unjudged = static_cast<std::size_t>(std::ranges::count_if(
      run.sessions, [](const SessionScore& session) { return !session.has_truth; }));
  if (unjudged > 0) return UnjudgedVerdict(run, unjudged);
  std::size_t missed = 0, invented = 0, misplaced = 0, statuses = 0, away = 0;
  int right = 0;
  for (const SessionScore& session : run.sessions) {
    missed += session.opis.missed.size();
    invented += session.opis.invented.size();
    misplaced += static_cast<std::size_t>(
        std::count_if(session.opis.found.begin(), session.opis.found.end(),
                      [](const OpiScore& opi) { return opi.error_m > kGoodError; }));
    statuses += session.opis.changes.size();
    right += StatusesRight(session);
    away += IsHome(session) ? 0 : 1;
  }
  Verdict verdict{.is_good = false, .is_judged = true, .text = ""};
  verdict.is_good = !run.sessions.empty() && missed + invented + misplaced + away == 0 &&
                    static_cast<std::size_t>(right) == statuses;
  const auto count = [](std::size_t n) { return n == 0 ? std::string("none") : std::to_string(n); };
  verdict.text =
      fmt::format("{}objects: {} missed, {} invented, {} misplaced",
                  statuses > 0 ? fmt::format("{} of {} statuses right; ", right, statuses) : "",
                  count(missed), count(invented), count(misplaced));
  if (away > 0)
    verdict.text += fmt::format("; {} of {} sessions not home", away, run.sessions.size());
  return verdict;
}

}  // namespace limpet

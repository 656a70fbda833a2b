// SPDX-License-Identifier: MIT
// What pLog says of a disk that does not take the log.
#include <algorithm>

#include <fmt/format.h>

#include "apps/pLog/log_app.hpp"
#include "apps/pLog/log_warnings.hpp"

namespace limpet {
namespace {

constexpr Seconds kCountTime{5.0};  ///< between two counts of what is missing

int Counted(std::uint64_t messages) {
  constexpr std::uint64_t kMost = 1'000'000'000;
  return static_cast<int>(std::min(messages, kMost));
}

}  // namespace

void LogApp::Save() {
  const std::error_code trouble = session_.Save();
  if (session_.is_open()) {
    TellState(trouble ? trouble.message() : "");
  } else if (failed_at_) {
    TellState(failure_);
  }
}

void LogApp::TellState(const std::string& why) {
  const LogLosses losses = session_.losses();
  const LogState state{.is_written = why.empty(),
                       .missing = Counted(losses.dropped + unlogged_),
                       .in_doubt = Counted(losses.in_doubt)};
  if (state.is_written) {
    ClearWarning(warnings::kLogFailed);
  } else {
    Warn(warnings::kLogFailed,
         fmt::format("{}; {} messages wait, {} are missing", why, losses.waiting, state.missing));
  }
  if (state.missing > 0 || state.in_doubt > 0) {
    Warn(warnings::kLogDropped, fmt::format("{} messages are missing in the log, {} more may be",
                                            state.missing, state.in_doubt));
  }
  const bool has_counted = state.missing != told_.missing || state.in_doubt != told_.in_doubt;
  const bool is_counted_anew = has_counted && (!told_at_ || now() - *told_at_ >= kCountTime);
  // A former life may have left word that it is not written. Embedded there is none.
  const bool is_first = !told_at_ && context().runs_live;
  if (state.is_written != told_.is_written || is_counted_anew || is_first) {
    told_ = state;
    told_at_ = now();
    Publish(topics::kLogState, state);
  }
}

}  // namespace limpet

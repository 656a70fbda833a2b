// SPDX-License-Identifier: MIT
// What an operator sees of the log.
#include <fmt/format.h>

#include "apps/pLog/log_app.hpp"

namespace limpet {

void LogApp::Report(ReportLines& report) const {
  report.Pair("Log", failed_at_           ? "cannot be written"
                     : session_.is_open() ? "open"
                     : is_over_           ? "closed"
                                          : "not opened yet");
  report.Pair("Since", fmt::format("{:.0f} s", (now() - start_).value()));
  report.Pair("Variables", params_.wildcard_logging
                               ? fmt::format("{} without {}", Joined(params_.wildcard_patterns),
                                             Joined(params_.wildcard_omit_patterns))
                               : "those listed");
  report.Pair("Binaries", logs_binaries_ ? "in the .blog" : "left out");
  report.Pair("Table", sync_period_ ? fmt::format("{} columns each {:g} s", sync_names_.size(),
                                                  sync_period_->value())
                                    : "none");
  if (!context().runs_live) {
    return;  // what it counts would tell a run with the truth from one without
  }
  report.Pair("Folder", folder_.empty() ? "none yet" : folder_);
  report.Pair("Copies", fmt::format("{} at request, {} refused", copies_, refused_copies_));
  report.Pair("Messages", fmt::format("{}, {} of them binary", messages_, binaries_));
  report.Pair("Missing", fmt::format("{}, {} more in doubt", told_.missing, told_.in_doubt));
}

std::string LogApp::Joined(const std::vector<std::string>& patterns) {
  std::string text;
  for (const std::string& pattern : patterns) {
    text += (text.empty() ? "" : ",") + pattern;
  }
  return text.empty() ? "nothing" : text;
}

}  // namespace limpet

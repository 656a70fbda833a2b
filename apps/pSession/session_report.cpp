// SPDX-License-Identifier: MIT
// What an operator sees of the session on disk.
#include <fmt/format.h>

#include "apps/pSession/session_app.hpp"

namespace limpet {

void SessionApp::Report(ReportLines& report) const {
  report.Pair("Session", context().session);
  report.Pair("Former", former_ ? fmt::format("{}: {} objects, {} views", former_->session,
                                              former_->objects, former_->views)
                                : "none");
  if (!writer_) {
    report.Pair("Saved", "nowhere: no run folder");
  } else if (generation_ == 0 || !last_save_) {
    report.Pair("Saved", "not yet");
  } else {
    report.Pair("Saved", fmt::format("generation {}, {:.0f} s ago ({})", generation_,
                                     (now() - *last_save_).value(), last_cause_));
  }
  report.Pair("Holds",
              fmt::format("{} objects, {} frames, map of {} tiles, {:.0f} KiB packed",
                          memory_.objects.opis.size(), memory_.frames.size(), tiles_.List().tiles,
                          static_cast<double>(tiles_.packed_bytes()) / 1024.0));
  if (pending_) {
    report.Pair("Waiting", "for the map, to save: " + pending_->cause);
  }
}

}  // namespace limpet

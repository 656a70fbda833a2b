// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "limpet/app/app_caster.hpp"
#include "limpet/app/warning_board.hpp"
#include "limpet/launch/launch_plan.hpp"
#include "limpet/launch/supervisor.hpp"
#include "limpet/topics/event.hpp"

namespace limpet {

/// The processes and, in state `missing`, those whose program is not there.
[[nodiscard]] std::vector<Supervisor::Report> WithMissing(
    std::vector<Supervisor::Report> processes, const std::vector<MissingProgram>& missing);
/// What PLAUNCH_STATUS says of them, to be appended to the supervisor's.
[[nodiscard]] std::string StatusOfMissing(const std::vector<MissingProgram>& missing);

/// pLaunch's APPCAST: each process with its state, and a warning for each that is not well; and
/// PLAUNCH_WARNINGS.
class LaunchReport {
 public:
  /// `now`: MOOS time, as everywhere here.
  LaunchReport(const std::string& community, double warp, Seconds now);

  /// Mail of APPCAST_REQ.
  void OnRequest(std::string_view text, Seconds now) { caster_.OnRequest(text, now); }
  void AddEvent(const EventId& event, std::string_view text, Seconds now);
  /// Raises it, or clears it if the text is empty.
  void SetWarning(const WarningId& id, const std::string& text, Seconds now);
  /// Warns of processes that do not run.
  void Watch(const std::vector<Supervisor::Report>& processes, Seconds now);
  /// What PLAUNCH_WARNINGS is to be written as now, if it is.
  [[nodiscard]] std::optional<std::string> TakeWarnings(Seconds now) {
    return warnings_.TakeNews(now);
  }
  /// An APPCAST if one is due. `up`: names that the community knows.
  [[nodiscard]] std::optional<std::string> Take(const std::vector<Supervisor::Report>& processes,
                                                const std::set<std::string>& up, Seconds now);

 private:
  AppCaster caster_;
  WarningBoard warnings_;
  Seconds started_;
  std::int64_t looks_ = 0;
};

}  // namespace limpet

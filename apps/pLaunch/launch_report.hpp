// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "apps/pLaunch/launch_plan.hpp"
#include "apps/pLaunch/supervisor.hpp"
#include "limpet/app/app_caster.hpp"

namespace limpet {

/// The processes and, in state `missing`, those whose program is not there.
[[nodiscard]] std::vector<Supervisor::Report> WithMissing(
    std::vector<Supervisor::Report> processes, const std::vector<MissingProgram>& missing);
/// What PLAUNCH_STATUS says of them, to be appended to the supervisor's.
[[nodiscard]] std::string StatusOfMissing(const std::vector<MissingProgram>& missing);

/// pLaunch's APPCAST: each process with its state, and a warning for each that is not well.
class LaunchReport {
 public:
  LaunchReport(const std::string& community, double warp);

  /// Mail of APPCAST_REQ.
  void OnRequest(std::string_view text, Seconds now) { caster_.OnRequest(text, now); }
  /// Something happened, `elapsed` after the start (MOOS time).
  void AddEvent(Seconds elapsed, std::string_view text) { caster_.AddEvent(elapsed, text); }
  /// Raises it, or clears it if the text is empty.
  void SetWarning(const std::string& id, const std::string& text);
  /// An APPCAST if one is due. `up`: names that the community knows.
  [[nodiscard]] std::optional<std::string> Take(const std::vector<Supervisor::Report>& processes,
                                                const std::set<std::string>& up, Seconds now);

 private:
  void Watch(const std::vector<Supervisor::Report>& processes);

  AppCaster caster_;
  std::map<std::string, std::string> standing_;  ///< warnings by SetWarning
  std::int64_t looks_ = 0;
};

}  // namespace limpet

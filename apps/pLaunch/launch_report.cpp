// SPDX-License-Identifier: MIT
#include "apps/pLaunch/launch_report.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "limpet/app/report_lines.hpp"

namespace limpet {

std::vector<Supervisor::Report> WithMissing(std::vector<Supervisor::Report> processes,
                                            const std::vector<MissingProgram>& missing) {
  for (const MissingProgram& program : missing) {
    processes.push_back({.name = program.name,
                         .state = "missing",
                         .restarts = 0,
                         .last_end = "no program " + program.binary});
  }
  return processes;
}

std::string StatusOfMissing(const std::vector<MissingProgram>& missing) {
  std::string text;
  for (const MissingProgram& program : missing) {
    text += fmt::format(" # app={},state=missing,restarts=0,last=no program {},database=false",
                        program.name, program.binary);
  }
  return text;
}

LaunchReport::LaunchReport(const std::string& community, double warp) {
  caster_.Configure({.process = "pLaunch", .node = community, .warp = warp});
}

void LaunchReport::Watch(const std::vector<Supervisor::Report>& processes) {
  for (const Supervisor::Report& process : processes) {
    const std::string_view state = process.state;
    if (state == "missing") {
      caster_.RaiseWarning("DOWN_" + process.name,
                           fmt::format("{}: {}", process.name, process.last_end));
    } else if (state == "waiting" || state == "given_up") {
      caster_.RaiseWarning("DOWN_" + process.name,
                           fmt::format("{} {}{}", process.name, process.last_end,
                                       state == "given_up" ? ": given up" : ""));
    } else {
      caster_.ClearWarning("DOWN_" + process.name);
    }
  }
}

void LaunchReport::SetWarning(const std::string& id, const std::string& text) {
  std::string& standing = standing_[id];
  if (standing == text) {
    return;
  }
  if (!standing.empty()) {
    caster_.ClearWarning(id);
  }
  if (!text.empty()) {
    caster_.RaiseWarning(id, text);
  }
  standing = text;
}

std::optional<std::string> LaunchReport::Take(const std::vector<Supervisor::Report>& processes,
                                              const std::set<std::string>& up, Seconds now) {
  ++looks_;
  Watch(processes);
  if (!caster_.IsDue(now)) {
    return std::nullopt;
  }
  const auto running = std::ranges::count_if(
      processes, [](const auto& process) { return std::string_view(process.state) == "running"; });
  ReportLines report;
  report.Pair("Processes", fmt::format("{} of {} run", running, processes.size()));
  report.Blank();
  ReportTable table({"process", "state", "in community", ">restarts", "last end"});
  for (const Supervisor::Report& process : processes) {
    table.AddRow({process.name, process.state,
                  process.is_database         ? "it is"
                  : up.contains(process.name) ? "yes"
                                              : "no",
                  std::to_string(process.restarts), process.last_end});
  }
  report.Add(table);
  return EncodeAppCast(caster_.Cast(report.lines(), looks_, now));
}

}  // namespace limpet

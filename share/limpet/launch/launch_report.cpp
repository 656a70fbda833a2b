// SPDX-License-Identifier: MIT
#include "limpet/launch/launch_report.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "limpet/app/report_lines.hpp"
#include "limpet/launch/launch_warnings.hpp"

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

LaunchReport::LaunchReport(const std::string& community, double warp, Seconds now)
    : warnings_(warp), started_(now) {
  caster_.Configure({.process = "pLaunch", .node = community, .warp = warp});
}

void LaunchReport::AddEvent(const EventId& event, std::string_view text, Seconds now) {
  caster_.AddEvent(now - started_, fmt::format("{}: {}", event.name(), text));
}

void LaunchReport::Watch(const std::vector<Supervisor::Report>& processes, Seconds now) {
  for (const Supervisor::Report& process : processes) {
    const std::string_view state = process.state;
    std::string text;
    if (state == "missing") {
      text = fmt::format("{}: {}", process.name, process.last_end);
    } else if (state == "waiting" || state == "given_up") {
      text = fmt::format("{} {}{}", process.name, process.last_end,
                         state == "given_up" ? ": given up" : "");
    }
    SetWarning(warnings::kDown.Of(process.name), text, now);
  }
}

void LaunchReport::SetWarning(const WarningId& id, const std::string& text, Seconds now) {
  if (text.empty()) {
    if (warnings_.Clear(id)) {
      caster_.ClearWarning(id);
    }
  } else if (warnings_.Raise(id, text, now) != WarningBoard::Change::kNone) {
    caster_.RaiseWarning(id, text, now - started_);
  }
}

std::optional<std::string> LaunchReport::Take(const std::vector<Supervisor::Report>& processes,
                                              const std::set<std::string>& up, Seconds now) {
  ++looks_;
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

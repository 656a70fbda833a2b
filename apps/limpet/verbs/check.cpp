// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/check.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>
#include <tuple>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "apps/limpet/cli.hpp"
#include "apps/limpet/verbs/dry_run_check.hpp"
#include "limpet/console/shown_text.hpp"
#include "limpet/core/problem_order.hpp"
#include "limpet/preflight/preflight.hpp"
#include "limpet/runs/flown_mission.hpp"
#include "limpet/runs/session_runner.hpp"
#include "limpet/site/site_figure.hpp"
#include "limpet/site/site_text.hpp"

namespace limpet {
namespace {

Command CheckForm() {
  return {
      .name = "limpet check",
      .words = "<mission folder | file.moos | file.bhv>",
      .about =
          "Says everything that is wrong with a mission, with file and line, and runs "
          "nothing: what cannot be read, what cannot work (with its scenario.yaml: water, "
          "currents, places), and, as notes, what belongs to other people's apps or is "
          "near a limit. What is written for stock programs is noted, too, where Limpet's own "
          "would not start with it; the last line then says so. Behaviors from elsewhere are "
          "those of behavior_path in the helm's block and of LIMPET_BEHAVIOR_PATH. With --dry-run "
          "it then flies the mission in simulation, "
          "its change session after its discovery, with boxes for a camera and all safety rules "
          "armed, in the scenario's water and with its battery, and refuses it if a rule trips "
          "that asks for more than a "
          "warning, if the energy does not reach home with its reserve, or if it does not "
          "come home.",
      .options = {{.names = "--json", .meaning = "as JSON"},
                  {.names = "--draw",
                   .meaning = "draws the area as text, too (with --json on stderr); a terminal "
                              "gets it unasked"},
                  {.names = "--dry-run", .meaning = "flies the mission, too"},
                  {.names = "--seeds",
                   .value = "N",
                   .meaning = "so many seeds, each with all sessions",
                   .fallback = "3",
                   .rule = WholeNumber(1)},
                  {.names = "--seed",
                   .value = "N",
                   .meaning = "of the first flight",
                   .fallback = "1",
                   .rule = WholeNumber(0)},
                  {.names = "--figure",
                   .value = "FILE",
                   .meaning = "writes a picture of the area (SVG)"},
                  {.names = "--set",
                   .value = "OWNER.KEY=V",
                   .meaning = "checks the mission as if it said this, as `limpet survey` takes it",
                   .is_repeatable = true}},
      .more =
          "Exit code 0: nothing is wrong with it (notes or not; Limpet's own programs run it "
          "unless "
          "the last line says that they would refuse some); 2: it cannot be read; 3: it cannot "
          "work, or a flight of the dry run was refused.",
      .takes = "one mission folder, .moos or .bhv file",
      .least_words = 1,
      .most_words = 1};
}

nlohmann::ordered_json ProblemsJson(const std::vector<ConfigProblem>& problems) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const ConfigProblem& problem : problems) {
    list.push_back({{"file", problem.where.file},
                    {"line", problem.where.line},
                    {"key", problem.key},
                    {"text", problem.text}});
  }
  return list;
}

/// Null without a battery.
nlohmann::ordered_json EnergyJson(const std::optional<EnergyOutlook>& energy) {
  if (!energy) return nullptr;
  return {{"needed_wh", energy->needed_wh},
          {"home_wh", energy->home_wh},
          {"charged_wh", energy->charged_wh},
          {"reserve_wh", energy->reserve_wh}};
}

/// What the user named, and what is set in it before it is looked at; empty without `--set`.
struct CheckedMission {
  std::string path;
  MissionChange change;
};

MissionChange ChangeOf(const Arguments& given) {
  const std::vector<std::string> settings = given.All("set");
  if (settings.empty()) return {};
  return [settings](MissionFile& mission) {
    for (const std::string& setting : settings) {
      ApplySetting(mission, setting);
    }
  };
}

/// Settings are of one mission. Throws UsageError for a behavior file, and ConfigError for a folder
/// in which it is not clear which mission is meant.
std::filesystem::path ChangedMissionAt(const std::filesystem::path& path) {
  if (path.extension() == ".bhv") {
    throw UsageError(
        fmt::format("--set is for missions, not for a behavior file ({})", OneLine(path.string())));
  }
  return FlownMissionAt(path);
}

struct CheckLine {
  ConfigProblem problem;
  bool is_note = false;
  bool is_refused_here = false;
};

/// `file:line: key: text`; a note says so before its key, and behind its text if ours refuses it.
std::string LineText(const CheckLine& line) {
  ConfigProblem shown = line.problem;
  if (line.is_refused_here) shown.text += " [Limpet's own would not start with this]";
  if (line.is_note) shown.key = shown.key.empty() ? "note" : "note: " + shown.key;
  return OneLine(shown.Format());
}

std::string Counted(std::size_t count, const char* what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

/// How much was found; and of a mission for stock programs, if ours would not run it.
std::string SummaryOf(const MissionProblems& found) {
  const std::size_t problems = found.syntax.size() + found.geometry.size();
  std::string text = problems == 0 ? "no problems" : Counted(problems, "problem");
  if (!found.notes.empty()) text += ", " + Counted(found.notes.size(), "note");
  if (!found.refused_here.empty()) {
    text += fmt::format(
        "; for {} of them Limpet's own programs would not run it: it needs the stock ones, or a "
        "change",
        found.refused_here.size());
  }
  return text;
}

/// Problems and notes together, by file and line.
void PrintLines(const MissionProblems& found) {
  std::vector<CheckLine> lines;
  for (const auto* list : {&found.syntax, &found.geometry, &found.notes}) {
    for (const ConfigProblem& problem : *list) {
      const bool is_note = list == &found.notes;
      const bool is_refused_here =
          is_note && std::ranges::any_of(found.refused_here, [&problem](const auto& refused) {
            return OrderOf(refused) == OrderOf(problem);
          });
      lines.push_back({problem, is_note, is_refused_here});
    }
  }
  std::ranges::stable_sort(lines, {}, [](const CheckLine& line) {
    return std::tie(line.problem.where.file, line.problem.where.line);
  });
  for (const CheckLine& line : lines) {
    fmt::print("{}\n", LineText(line));
  }
  if (found.energy) {
    fmt::print(
        "energy: the survey takes about {:.0f} Wh, {:.0f} Wh of them for the way home with the "
        "wait at the surface; {:.0f} Wh in the battery, {:.0f} Wh in reserve\n",
        found.energy->needed_wh, found.energy->home_wh, found.energy->charged_wh,
        found.energy->reserve_wh);
  }
  fmt::print("{}\n", SummaryOf(found));
}

/// The area as text on a terminal, or if it is asked for: beside JSON on stderr, which leaves that
/// whole. As a picture if a file is named.
void DrawSite(const Arguments& given, const CheckedMission& checked) {
  const bool is_drawn = given.Has("draw") || (isatty(STDOUT_FILENO) != 0 && !given.Has("json"));
  if (!is_drawn && !given.Has("figure")) return;
  const std::optional<Site> site = SiteOf(checked.path, checked.change);
  constexpr int kColumns = 78;
  if (site && is_drawn) {
    fmt::print(given.Has("json") ? stderr : stdout, "{}", SiteText(*site, kColumns));
  }
  const std::optional<std::string> figure = given.Find("figure");
  if (!figure) return;
  if (!site) {
    throw UsageError(
        fmt::format("{} is not written: the mission has no area that can be drawn", *figure));
  }
  std::ofstream out(*figure);
  out << SiteSvg(*site) << std::flush;
  if (!out) throw UsageError(fmt::format("{}: cannot be written", OneLine(*figure)));
}

int CodeOf(const MissionProblems& found) {
  return !found.syntax.empty() ? kUsage : !found.geometry.empty() ? kRefused : kOk;
}

DryRunSeeds SeedsOf(const Arguments& given) {
  return {.first = static_cast<std::uint64_t>(given.Integer("seed")),
          .count = static_cast<int>(given.Integer("seeds"))};
}

int CheckInText(const Arguments& given, const CheckedMission& checked,
                const MissionProblems& found) {
  PrintLines(found);
  DrawSite(given, checked);
  const int code = CodeOf(found);
  if (code != kOk || !given.Has("dry-run")) return code;
  const DryRun run = FlyDryRun(checked.path, checked.change, SeedsOf(given), PrintFlight);
  PrintVerdict(run);
  return run.ExitCode();
}

/// One object, with `dry_run` if that is asked for: null if the mission is not fit to be flown.
int CheckInJson(const Arguments& given, const CheckedMission& checked,
                const MissionProblems& found) {
  nlohmann::ordered_json out{{"syntax", ProblemsJson(found.syntax)},
                             {"geometry", ProblemsJson(found.geometry)},
                             {"notes", ProblemsJson(found.notes)},
                             {"refused_here", ProblemsJson(found.refused_here)},
                             {"energy", EnergyJson(found.energy)}};
  int code = CodeOf(found);
  if (given.Has("dry-run")) {
    out["dry_run"] = nullptr;
    if (code == kOk) {
      const DryRun run =
          FlyDryRun(checked.path, checked.change, SeedsOf(given), [](const SeedFlight&) {});
      out["dry_run"] = JsonOf(run);
      code = run.ExitCode();
    }
  }
  fmt::print("{}\n", out.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
  DrawSite(given, checked);
  return code;
}

int CheckMission(const Arguments& given) {
  const std::string& path = given.positionals()[0];
  if (!std::filesystem::exists(path)) {
    throw UsageError(fmt::format("{}: there is no such file or folder", OneLine(path)));
  }
  const std::filesystem::path file = MissionFileAt(path);
  if (std::filesystem::exists(file) && !std::filesystem::is_directory(file) &&
      !std::filesystem::is_regular_file(file)) {
    throw UsageError(fmt::format(
        "{}: is no plain file, but a pipe or a device: it is not read; a copy of it can be checked",
        OneLine(file.string())));
  }
  const CheckedMission checked{.path = path, .change = ChangeOf(given)};
  const MissionProblems found =
      checked.change ? CheckMissionFile(ChangedMissionAt(path), checked.change) : CheckPath(path);
  return given.Has("json") ? CheckInJson(given, checked, found)
                           : CheckInText(given, checked, found);
}

}  // namespace

int RunCheck(std::span<const std::string> args) {
  return RunCommand(CheckForm(), args, CheckMission);
}

}  // namespace limpet

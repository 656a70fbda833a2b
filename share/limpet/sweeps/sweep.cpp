// SPDX-License-Identifier: MIT
#include "limpet/sweeps/sweep.hpp"

#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limpet/console/command_output.hpp"
#include "limpet/console/exit_code.hpp"
#include "limpet/console/shown_text.hpp"
#include "limpet/durable/durable_file.hpp"
#include "limpet/runs/run_settings.hpp"
#include "limpet/session/checksum.hpp"
#include "limpet/sweeps/refused_run.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSweepConfiguration = "configuration.json";
constexpr const char* kResults = "results";
constexpr const char* kWork = "work";

std::string SettingsText(const SweepTask& task) {
  std::string text;
  for (const std::string& setting : task.settings)
    text += setting + "\n";
  return text;
}

std::string KeyOf(const SweepTask& task) {
  return task.settings.empty() ? "default" : ChecksumOf(SettingsText(task));
}

/// Throws Refusal if results of another mission or program lie there.
void CompareWithEarlier(const fs::path& out, const RunConfiguration& now) {
  if (!fs::exists(out / kResults)) return;
  const Expected<std::string> text = ReadWhole(out / kSweepConfiguration);
  const auto before = RunConfiguration::FromText(text ? *text : "");
  if (!before) {
    throw Refusal(
        fmt::format("{} does not say what its runs were made with ({}); choose another "
                    "--out",
                    OneLine(out.string()), before.error().text));
  }
  const auto differences = DifferencesBetween(*before, now);
  if (differences.empty()) return;
  throw Refusal(
      fmt::format("{} holds runs of another configuration: {}; they are not mixed with "
                  "new ones: choose another --out",
                  OneLine(out.string()), fmt::join(differences, "; ")));
}

}  // namespace

std::string MachineFreeReport(const std::string& report_json) {
  nlohmann::ordered_json report = nlohmann::ordered_json::parse(report_json);
  for (auto& [name, session] : report.at("sessions").items()) {
    session.erase("wall_s");
    session.erase("realtime_factor");
  }
  return report.dump(1) + "\n";
}

Sweep::Sweep(SweepPlan plan)
    : plan_(std::move(plan)),
      folder_(plan_.out, RunFolder::Use::kNewRun),
      configuration_(RunConfiguration::Of(plan_.mission_folder, plan_.survey_options)),
      runner_(MakeTaskRunner(plan_.runner)) {
  configuration_.parts["the mission's name"] = MissionName(plan_.mission_folder);
  CompareWithEarlier(plan_.out, configuration_);
  folder_.Write({{kSweepConfiguration, configuration_.Text()}});
}

fs::path Sweep::ResultFile(const SweepTask& task) {
  return fs::path(kResults) / KeyOf(task) / fmt::format("{}.json", task.seed);
}

fs::path Sweep::WorkFolder(const SweepTask& task) const {
  return plan_.out / kWork / KeyOf(task) / std::to_string(task.seed);
}

ChildRun Sweep::RunOf(const SweepTask& task) const {
  ChildRun run{.args = {"survey", plan_.mission_folder.string(), "--seed",
                        std::to_string(task.seed), "--out", WorkFolder(task).string()},
               .log = WorkFolder(task).string() + ".txt",
               .program = plan_.program};
  run.args.insert(run.args.end(), plan_.survey_options.begin(), plan_.survey_options.end());
  for (const std::string& setting : task.settings)
    run.args.push_back("--set=" + setting);
  return run;
}

std::vector<SweepTask> Sweep::Missing(const std::vector<SweepTask>& tasks) {
  std::vector<SweepTask> missing;
  for (const SweepTask& task : tasks) {
    // report.json appears only once it is whole: that run was done.
    if (!fs::exists(plan_.out / ResultFile(task)) && fs::exists(WorkFolder(task) / "report.json")) {
      Take(task, kOk);
    }
    if (fs::exists(plan_.out / ResultFile(task))) {
      ++found_;
      continue;
    }
    missing.push_back(task);
  }
  return missing;
}

std::optional<std::vector<std::string>> Sweep::Results(const std::vector<SweepTask>& tasks) {
  const std::vector<SweepTask> missing = Missing(tasks);
  std::vector<ChildRun> runs;
  for (const SweepTask& task : missing) {
    fs::remove_all(WorkFolder(task));  // what a run left that was killed
    fs::create_directories(WorkFolder(task).parent_path());
    runs.push_back(RunOf(task));
  }
  std::size_t done = 0;
  const auto tell = [&] {
    if (plan_.on_progress) plan_.on_progress(done, runs.size());
  };
  if (!runs.empty()) tell();
  const bool is_complete = runner_->Run(runs, [&](const ChildEnd& end) {
    Take(missing[end.index], end.exit_code);
    ++run_;
    ++done;
    tell();
    return true;
  });
  if (!is_complete) return std::nullopt;
  RemoveEmptyFolders(tasks);
  std::vector<std::string> results;
  for (const SweepTask& task : tasks) {
    const Expected<std::string> text = ReadWhole(plan_.out / ResultFile(task));
    if (!text) throw std::runtime_error(text.error().text);
    results.push_back(*text);
  }
  return results;
}

void Sweep::RefuseIfChanged() const {
  RunConfiguration now = RunConfiguration::Of(plan_.mission_folder, plan_.survey_options);
  now.parts["the mission's name"] = MissionName(plan_.mission_folder);
  const auto differences = DifferencesBetween(configuration_, now);
  if (differences.empty()) return;
  throw Refusal(
      fmt::format("stopped: meanwhile {}; the last run does not count. Choose another "
                  "--out for the new one",
                  fmt::join(differences, "; ")));
}

void Sweep::Take(const SweepTask& task, int exit_code) {
  const fs::path log = RunOf(task).log;
  if (exit_code == kRefused || exit_code == kUsage) {
    throw Refusal("a run with " + RefusedRunText(task.seed, log));
  }
  RefuseIfChanged();
  const Expected<std::string> report = ReadWhole(WorkFolder(task) / "report.json");
  const std::string result =
      report ? MachineFreeReport(*report) : fmt::format("{{\"failed\": {}}}\n", exit_code);
  const fs::path file = ResultFile(task);
  folder_.Write({{file.string(), result},
                 {(file.parent_path() / "settings.txt").string(), SettingsText(task)}});
  if (!report) {
    fmt::print(stderr, "seed {} left no report (exit code {}): see {}\n", task.seed, exit_code,
               OneLine(log.string()));
    return;
  }
  if (plan_.keeps_runs) return;
  fs::remove_all(WorkFolder(task));
  fs::remove(log);
}

void Sweep::RemoveEmptyFolders(const std::vector<SweepTask>& tasks) const {
  std::error_code not_empty;  // what failed is kept
  for (const SweepTask& task : tasks) {
    for (fs::path empty = WorkFolder(task).parent_path(); empty != plan_.out;
         empty = empty.parent_path()) {
      fs::remove(empty, not_empty);
    }
  }
}

}  // namespace limpet

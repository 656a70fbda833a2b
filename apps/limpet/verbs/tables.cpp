// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/tables.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include <fmt/format.h>

#include "apps/limpet/cli.hpp"
#include "apps/limpet/report/expectation_check.hpp"
#include "apps/limpet/report/paper_tables.hpp"
#include "apps/limpet/verbs/child_runs.hpp"
#include "limpet/console/progress_line.hpp"
#include "limpet/mission/scenario.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTablesHelp =
    R"(usage: limpet tables <mission folder> [options]

Surveys with one seed after the other, several at a time, and prints the paper's tables
beside ours. Each run keeps <out>/<seed>/report.json. Seeds already done are not run again,
so that after an interruption or a full disk the same command goes on.
Where the mission has an expect.yaml, every run is held to its bounds: exit code 1 if fewer
runs than its share_of_runs keep them.

  --runs N             number of seeds (default 10)
  --seed N             first seed (default 1)
  --jobs J             runs at a time (default: one per core)
  --out DIR            default runs/tables-<mission>
  --json               print tables.json instead of the tables
  --sessions, --set, --gain, --planner, --without-truth: as of limpet survey
)";

struct TablesCommand {
  fs::path mission_folder, out;
  int first_seed = 1, runs = 10, jobs = 1;
  bool prints_json = false;
  std::vector<std::string> survey_options;
  /// The same for equal configurations; results of others must not be mixed in.
  [[nodiscard]] std::string Fingerprint() const {
    return fmt::format("{} {}\n", mission_folder.filename().string(),
                       fmt::join(survey_options, " "));
  }
  [[nodiscard]] fs::path RunFolder(int seed) const { return out / std::to_string(seed); }
  /// Left beside a run's folder when its process has ended.
  [[nodiscard]] fs::path EndMark(int seed) const { return out / fmt::format("{}.exit", seed); }
};

TablesCommand ReadTablesCommand(std::span<const std::string> args) {
  const std::vector<std::string> passed_on{"sessions", "set", "gain", "planner"};
  std::vector<std::string> with_value{"runs", "seed", "jobs", "out"};
  with_value.insert(with_value.end(), passed_on.begin(), passed_on.end());
  const Arguments given(args, with_value, {"json", "without-truth", "help"});
  if (given.positionals().size() != 1) {
    throw UsageError("tables takes one mission folder, e.g. missions/table1");
  }
  TablesCommand command;
  command.mission_folder = fs::path(given.positionals()[0]).lexically_normal();
  if (!command.mission_folder.has_filename()) {
    command.mission_folder = command.mission_folder.parent_path();
  }
  const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  command.runs = given.Integer("runs", 10, 1);
  command.first_seed = given.Integer("seed", 1, 0);
  command.jobs = given.Integer("jobs", cores, 1);
  command.out =
      given.Find("out").value_or("runs/tables-" + command.mission_folder.filename().string());
  command.prints_json = given.Has("json");
  for (const std::string& option : passed_on) {
    for (const std::string& value : given.All(option)) {
      command.survey_options.push_back(fmt::format("--{}={}", option, value));
    }
  }
  if (given.Has("without-truth")) command.survey_options.emplace_back("--without-truth");
  return command;
}

std::string TextOf(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

/// All of it or, with an exception, nothing: a half-written file would be taken for a whole one.
void Write(const fs::path& path, const std::string& text) {
  const fs::path aside = path.string() + ".new";
  std::ofstream file(aside);
  file << text;
  file.close();
  std::error_code error;
  if (file) fs::rename(aside, path, error);
  if (!file || error) {
    fs::remove(aside, error);
    throw std::runtime_error("cannot write " + path.string());
  }
}

bool IsDiskFull(const fs::path& folder) {
  constexpr std::uintmax_t kLeastRoom = std::uintmax_t{1} << 20;
  std::error_code error;
  const fs::space_info room = fs::space(folder, error);
  return !error && room.available < kLeastRoom;
}

/// Runs of another configuration in the same folder would make the tables a lie.
void PrepareFolder(const TablesCommand& command) {
  const fs::path mark = command.out / "options.txt";
  if (fs::exists(mark) && TextOf(mark) != command.Fingerprint()) {
    throw UsageError(fmt::format("{} holds runs with other options ({}); choose another --out",
                                 command.out.string(), TextOf(mark).substr(0, 120)));
  }
  if (!fs::exists(mark) && fs::exists(command.out) && !fs::is_empty(command.out)) {
    throw UsageError(
        fmt::format("{} holds something else; choose another --out", command.out.string()));
  }
  fs::create_directories(command.out);
  if (!fs::exists(mark)) Write(mark, command.Fingerprint());
}

enum class Reached { kAll, kInterrupted, kDiskFull };

struct MissingRuns {
  std::vector<int> seeds;
  std::vector<ChildRun> runs;  ///< of each seed
};

MissingRuns FindMissing(const TablesCommand& command) {
  MissingRuns missing;
  for (int seed = command.first_seed; seed < command.first_seed + command.runs; ++seed) {
    if (fs::exists(command.EndMark(seed))) continue;
    ChildRun run{{"survey", command.mission_folder.string(), "--seed", std::to_string(seed),
                  "--out", command.RunFolder(seed).string()},
                 command.out / fmt::format("{}.txt", seed)};
    run.args.insert(run.args.end(), command.survey_options.begin(), command.survey_options.end());
    missing.seeds.push_back(seed);
    missing.runs.push_back(std::move(run));
  }
  return missing;
}

/// Notes how a seed's run ended; false if the disk is full: then it counts as not yet run.
bool NoteEnd(const TablesCommand& command, int seed, int exit_code, ProgressLine& progress) {
  const bool has_report = fs::exists(command.RunFolder(seed) / "report.json");
  if (!has_report && IsDiskFull(command.out)) return false;
  try {
    Write(command.EndMark(seed), std::to_string(exit_code) + "\n");
  } catch (const std::runtime_error&) {
    if (IsDiskFull(command.out)) return false;
    throw;
  }
  if (!has_report) {
    progress.Note(fmt::format("seed {} left no report (exit code {}): see {}", seed, exit_code,
                              (command.out / fmt::format("{}.txt", seed)).string()));
  }
  return true;
}

/// Runs every seed that is not done.
Reached RunMissing(const TablesCommand& command) {
  const MissingRuns missing = FindMissing(command);
  const std::size_t known = static_cast<std::size_t>(command.runs) - missing.runs.size();
  ProgressLine progress("tables");
  if (known > 0) progress.Note(fmt::format("{} of {} seeds are already done", known, command.runs));
  std::size_t ended = known;
  bool is_full = false;
  progress.Update(static_cast<double>(ended) / command.runs, "started");
  const bool is_complete = RunChildren(missing.runs, command.jobs, [&](const ChildEnd& end) {
    const int seed = missing.seeds[end.index];
    is_full = !NoteEnd(command, seed, end.exit_code, progress);
    if (is_full) return false;
    ++ended;
    progress.Update(static_cast<double>(ended) / command.runs,
                    fmt::format("{} of {} runs, last seed {}", ended, command.runs, seed));
    return true;
  });
  if (is_full) return Reached::kDiskFull;
  return is_complete ? Reached::kAll : Reached::kInterrupted;
}

/// Seeds that a full disk cut short begin anew: what they left makes room for the tables.
void RemoveUnfinished(const TablesCommand& command) {
  for (const int seed : FindMissing(command).seeds) {
    std::error_code ignored;
    fs::remove_all(command.RunFolder(seed), ignored);
  }
}

void SayHowFar(const TablesCommand& command, Reached reached) {
  if (reached == Reached::kInterrupted) {
    fmt::print(stderr, "interrupted: the same command goes on where it stopped\n");
  } else if (reached == Reached::kDiskFull) {
    const std::size_t done =
        static_cast<std::size_t>(command.runs) - FindMissing(command).seeds.size();
    fmt::print(stderr,
               "the disk of {} is full: {} of {} seeds are done and kept; make room, then the same "
               "command goes on\n",
               command.out.string(), done, command.runs);
  }
}

RunStatistics Gather(const TablesCommand& command) {
  RunStatistics statistics;
  statistics.mission = command.mission_folder.filename().string();
  for (int seed = command.first_seed; seed < command.first_seed + command.runs; ++seed) {
    if (!fs::exists(command.EndMark(seed))) continue;
    const auto error = statistics.Add(TextOf(command.RunFolder(seed) / "report.json"));
    if (error) statistics.failed.push_back(static_cast<std::uint64_t>(seed));
  }
  return statistics;
}

/// Holds every run to the mission's expect.yaml; says which seed breaks which bound.
bool KeepBounds(const TablesCommand& command, const Expectations& expected) {
  int runs = 0, kept = 0;
  for (int seed = command.first_seed; seed < command.first_seed + command.runs; ++seed) {
    const fs::path report = command.RunFolder(seed) / "report.json";
    if (!fs::exists(command.EndMark(seed)) || !fs::exists(report)) continue;
    const ExpectationCheck check = CheckReport(expected, TextOf(report));
    if (check.is_other_method) return true;
    ++runs;
    kept += check.is_kept() ? 1 : 0;
    for (const std::string& breach : check.breaches) {
      fmt::print(stderr, "seed {}: {}\n", seed, breach);
    }
  }
  const bool is_enough = kept >= expected.share_of_runs * runs;
  fmt::print(stderr, "expect.yaml: {} of {} runs keep every bound{}\n", kept, runs,
             is_enough ? "" : fmt::format("; at least {} of them should", expected.share_of_runs));
  return is_enough;
}

}  // namespace

int RunTables(std::span<const std::string> args) {
  if (std::ranges::find(args, "--help") != args.end()) {
    fmt::print("{}", kTablesHelp);
    return kOk;
  }
  const TablesCommand command = ReadTablesCommand(args);
  if (!fs::exists(command.mission_folder / "mission.moos")) {
    throw UsageError(fmt::format("no mission in {}", command.mission_folder.string()));
  }
  const auto expected = LoadExpectations(command.mission_folder,
                                         LoadScenario(command.mission_folder / "scenario.yaml"));
  PrepareFolder(command);
  const Reached reached = RunMissing(command);
  if (reached == Reached::kDiskFull) RemoveUnfinished(command);
  const RunStatistics statistics = Gather(command);
  const auto tables = PaperTables(statistics);
  const std::string json = TablesJson(statistics, command.Fingerprint());
  fmt::print("{}", command.prints_json ? json : PlainText(tables));
  SayHowFar(command, reached);
  Write(command.out / "tables.json", json);
  Write(command.out / "tables.md", Markdown(tables));
  const bool keep_bounds = !expected || KeepBounds(command, *expected);
  return reached == Reached::kAll && keep_bounds && statistics.failed.empty() ? kOk : kFailed;
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/tables.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <thread>

#include <fmt/format.h>

#include "apps/limpet/cli.hpp"
#include "apps/limpet/command_output.hpp"
#include "apps/limpet/report/expectation_check.hpp"
#include "apps/limpet/report/paper_tables.hpp"
#include "apps/limpet/run_folder/run_configuration.hpp"
#include "apps/limpet/run_folder/run_folder.hpp"
#include "apps/limpet/verbs/child_runs.hpp"
#include "apps/limpet/verbs/run_settings.hpp"
#include "limpet/console/progress_line.hpp"
#include "limpet/console/shown_text.hpp"
#include "limpet/mission/scenario.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTablesHelp =
    R"(usage: limpet tables <mission folder> [options]

Surveys with one seed after the other, several at a time, and prints the paper's tables
beside ours. Each run keeps <out>/<seed>/report.json. Seeds already done are not run again,
so that after an interruption or a full disk the same command goes on. Once a seed is done, the
mission, its plugs, the options and the program must stay as they are (exit code 3 if not).
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
  [[nodiscard]] std::string MissionName() const { return limpet::MissionName(mission_folder); }
  [[nodiscard]] std::string OptionsText() const {
    return fmt::format("{} {}\n", MissionName(), fmt::join(survey_options, " "));
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
  command.mission_folder = MissionFolder(given.positionals()[0]);
  const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  command.runs = given.Integer("runs", 10, 1);
  command.first_seed = given.Integer("seed", 1, 0);
  command.jobs = given.Integer("jobs", cores, 1);
  command.out = given.Find("out").value_or("runs/tables-" + command.MissionName());
  if (command.out.empty()) throw UsageError("--out takes a folder, not an empty word");
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

bool IsDiskFull(const fs::path& folder) {
  constexpr std::uintmax_t kLeastRoom = std::uintmax_t{1} << 20;
  std::error_code error;
  const fs::space_info room = fs::space(folder, error);
  return !error && room.available < kLeastRoom;
}

constexpr const char* kConfigurationFile = "configuration.json";

/// The folder of the tables and what its runs are made with.
struct TablesFolder {
  RunFolder folder;
  RunConfiguration configuration;
};

bool HasDoneSeed(const TablesCommand& command) {
  for (const auto& entry : fs::directory_iterator(command.out)) {
    if (entry.path().extension() == ".exit") return true;
  }
  return false;
}

/// Runs of another configuration in the same folder would make the tables a lie.
TablesFolder OpenFolder(const TablesCommand& command) {
  RunConfiguration now = RunConfiguration::Of(command.mission_folder, command.survey_options);
  now.parts["the mission's name"] = command.MissionName();
  TablesFolder tables{RunFolder(command.out, RunFolder::Use::kNewRun), std::move(now)};
  if (HasDoneSeed(command)) {
    const auto before = RunConfiguration::FromText(TextOf(command.out / kConfigurationFile));
    if (!before) {
      throw Refusal(
          fmt::format("{} does not say what its runs were made with ({}); choose another "
                      "--out",
                      command.out.string(), before.error().text));
    }
    const auto differences = DifferencesBetween(*before, tables.configuration);
    if (!differences.empty()) {
      throw Refusal(
          fmt::format("{} holds runs of another configuration: {}; they are not mixed with "
                      "new ones: choose another --out",
                      command.out.string(), fmt::join(differences, "; ")));
    }
  }
  tables.folder.Write({{kConfigurationFile, tables.configuration.Text()}});
  return tables;
}

enum class Reached { kAll, kInterrupted, kDiskFull, kRefused, kChanged };

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

/// What has become of the runs of one command.
class SeedRuns {
 public:
  SeedRuns(const TablesCommand& command, TablesFolder& tables)
      : command_(command), tables_(tables), missing_(FindMissing(command)) {}

  /// Runs every seed that is not done.
  Reached Run() {
    const std::size_t known = static_cast<std::size_t>(command_.runs) - missing_.runs.size();
    if (known > 0) {
      progress_.Note(fmt::format("{} of {} seeds are already done", known, command_.runs));
    }
    ended_ = known;
    ClaimLogs();
    progress_.Update(static_cast<double>(ended_) / command_.runs, "started");
    const bool is_complete =
        RunChildren(missing_.runs, command_.jobs, [&](const ChildEnd& end) { return Take(end); });
    if (reached_ != Reached::kAll) return reached_;
    return is_complete ? Reached::kAll : Reached::kInterrupted;
  }

 private:
  void ClaimLogs() {
    std::vector<fs::path> logs;
    for (const ChildRun& run : missing_.runs)
      logs.push_back(run.log.filename());
    tables_.folder.written().Claim(logs);
  }

  /// False when no more runs should be started.
  bool Take(const ChildEnd& end) {
    const int seed = missing_.seeds[end.index];
    reached_ = Judge(seed, end.exit_code);
    if (reached_ != Reached::kAll) return false;
    ++ended_;
    progress_.Update(static_cast<double>(ended_) / command_.runs,
                     fmt::format("{} of {} runs, last seed {}", ended_, command_.runs, seed));
    return true;
  }

  /// Notes how a seed's run ended, unless it does not count: then it is run again next time.
  Reached Judge(int seed, int exit_code) {
    const fs::path log = command_.out / fmt::format("{}.txt", seed);
    if (exit_code == kRefused || exit_code == kUsage) {
      progress_.Note(fmt::format("seed {} was refused: see {}", seed, OneLine(log.string())));
      return Reached::kRefused;
    }
    RunConfiguration now = RunConfiguration::Of(command_.mission_folder, command_.survey_options);
    now.parts["the mission's name"] = command_.MissionName();
    if (const auto differences = DifferencesBetween(tables_.configuration, now);
        !differences.empty()) {
      progress_.Note(fmt::format("seed {} does not count: meanwhile {}", seed,
                                 OneLine(fmt::format("{}", fmt::join(differences, "; ")))));
      return Reached::kChanged;
    }
    const bool has_report = fs::exists(command_.RunFolder(seed) / "report.json");
    if (!has_report && IsDiskFull(command_.out)) return RoomMade(seed);
    try {
      tables_.folder.Write({{fmt::format("{}.exit", seed), std::to_string(exit_code) + "\n"}});
    } catch (const std::runtime_error&) {
      if (IsDiskFull(command_.out)) return RoomMade(seed);
      throw;
    }
    if (!has_report) {
      progress_.Note(fmt::format("seed {} left no report (exit code {}): see {}", seed, exit_code,
                                 OneLine(log.string())));
    }
    return Reached::kAll;
  }

  /// A seed that a full disk cut short begins anew: what its run left makes room for the tables.
  /// Its folder was made by that run, which had it to itself.
  Reached RoomMade(int seed) {
    std::error_code ignored;
    if (was_missing_.contains(seed)) fs::remove_all(command_.RunFolder(seed), ignored);
    return Reached::kDiskFull;
  }

  static std::set<int> WithoutFolder(const TablesCommand& command, const MissingRuns& missing) {
    std::set<int> seeds;
    for (const int seed : missing.seeds) {
      if (!fs::exists(fs::symlink_status(command.RunFolder(seed)))) seeds.insert(seed);
    }
    return seeds;
  }

  const TablesCommand& command_;
  TablesFolder& tables_;
  MissingRuns missing_;
  std::set<int> was_missing_ = WithoutFolder(command_, missing_);  ///< no folder when we began
  ProgressLine progress_{"tables"};
  std::size_t ended_ = 0;
  Reached reached_ = Reached::kAll;
};

void SayHowFar(const TablesCommand& command, Reached reached) {
  if (reached == Reached::kInterrupted) {
    fmt::print(stderr, "interrupted: the same command goes on where it stopped\n");
  } else if (reached == Reached::kChanged) {
    fmt::print(stderr,
               "stopped: what is run was changed while it ran; the tables hold the seeds "
               "before. Choose another --out for the new one\n");
  } else if (reached == Reached::kRefused) {
    fmt::print(stderr, "stopped: a run was refused\n");
  } else if (reached == Reached::kDiskFull) {
    const std::size_t done =
        static_cast<std::size_t>(command.runs) - FindMissing(command).seeds.size();
    fmt::print(stderr,
               "the disk of {} is full: {} of {} seeds are done and kept; make room, then the same "
               "command goes on\n",
               OneLine(command.out.string()), done, command.runs);
  }
}

RunStatistics Gather(const TablesCommand& command) {
  RunStatistics statistics;
  statistics.mission = command.MissionName();
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
      fmt::print(stderr, "seed {}: {}\n", seed, OneLine(breach));
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
  TablesFolder tables = OpenFolder(command);
  const Reached reached = SeedRuns(command, tables).Run();
  const RunStatistics statistics = Gather(command);
  const auto paper_tables = PaperTables(statistics);
  const std::string json = TablesJson(statistics, command.OptionsText());
  fmt::print("{}", command.prints_json ? json : PlainText(paper_tables));
  SayHowFar(command, reached);
  tables.folder.Write({{"tables.json", json}, {"tables.md", Markdown(paper_tables)}});
  const bool keep_bounds = !expected || KeepBounds(command, *expected);
  if (reached == Reached::kRefused) return kRefused;
  return reached == Reached::kAll && keep_bounds && statistics.failed.empty() ? kOk : kFailed;
}

}  // namespace limpet

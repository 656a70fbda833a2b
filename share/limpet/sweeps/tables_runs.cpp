// SPDX-License-Identifier: MIT
#include "limpet/sweeps/tables_runs.hpp"

#include <set>
#include <stdexcept>

#include "limpet/console/command_output.hpp"
#include "limpet/console/exit_code.hpp"
#include "limpet/console/progress_line.hpp"
#include "limpet/console/shown_text.hpp"
#include "limpet/durable/durable_file.hpp"
#include "limpet/sweeps/child_runs.hpp"
#include "limpet/sweeps/refused_run.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

bool IsDiskFull(const fs::path& folder) {
  constexpr std::uintmax_t kLeastRoom = std::uintmax_t{1} << 20;
  std::error_code error;
  const fs::space_info room = fs::space(folder, error);
  return !error && room.available < kLeastRoom;
}

constexpr const char* kConfigurationFile = "configuration.json";

bool HasDoneSeed(const TablesCommand& command) {
  for (const auto& entry : fs::directory_iterator(command.out)) {
    if (entry.path().extension() == ".exit") return true;
  }
  return false;
}

RunConfiguration ConfigurationOf(const TablesCommand& command) {
  RunConfiguration configuration =
      RunConfiguration::Of(command.mission_folder, command.survey_options);
  configuration.parts["the mission's name"] = command.MissionName();
  return configuration;
}

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
        runner_->Run(missing_.runs, [&](const ChildEnd& end) { return Take(end); });
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
      progress_.Note(RefusedRunText(static_cast<std::uint64_t>(seed), log));
      return Reached::kRefused;
    }
    const RunConfiguration now = ConfigurationOf(command_);
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
  std::unique_ptr<TaskRunner> runner_ = MakeTaskRunner(command_.runner);
  ProgressLine progress_{"tables"};
  std::size_t ended_ = 0;
  Reached reached_ = Reached::kAll;
};

}  // namespace

/// Runs of another configuration in the same folder would make the tables a lie.
TablesFolder OpenTablesFolder(const TablesCommand& command) {
  RunConfiguration now = ConfigurationOf(command);
  TablesFolder tables{RunFolder(command.out, RunFolder::Use::kNewRun), std::move(now)};
  if (HasDoneSeed(command)) {
    const Expected<std::string> text = ReadWhole(command.out / kConfigurationFile);
    const auto before = RunConfiguration::FromText(text ? *text : "");
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

Reached RunSeeds(const TablesCommand& command, TablesFolder& tables) {
  return SeedRuns(command, tables).Run();
}

std::size_t SeedsDone(const TablesCommand& command) {
  return static_cast<std::size_t>(command.runs) - FindMissing(command).seeds.size();
}

}  // namespace limpet

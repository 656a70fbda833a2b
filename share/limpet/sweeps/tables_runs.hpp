// SPDX-License-Identifier: MIT
// The many runs of `limpet tables`: one child process per seed, each counted once and only if it
// was made with what the others were made with.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "limpet/runs/run_configuration.hpp"
#include "limpet/runs/run_folder.hpp"
#include "limpet/runs/run_settings.hpp"
#include "limpet/sweeps/task_runner.hpp"

namespace limpet {

struct TablesCommand {
  std::filesystem::path mission_folder, out;
  int first_seed = 1, runs = 10;
  RunnerOptions runner{};
  std::vector<std::string> survey_options;
  [[nodiscard]] std::string MissionName() const { return limpet::MissionName(mission_folder); }
  [[nodiscard]] std::string OptionsText() const {
    return fmt::format("{} {}\n", MissionName(), fmt::join(survey_options, " "));
  }
  [[nodiscard]] std::filesystem::path RunFolder(int seed) const {
    return out / std::to_string(seed);
  }
  /// Left beside a run's folder when its process has ended.
  [[nodiscard]] std::filesystem::path EndMark(int seed) const {
    return out / fmt::format("{}.exit", seed);
  }
};

/// The folder of the tables, held while they are made, and what its runs are made with.
struct TablesFolder {
  RunFolder folder;
  RunConfiguration configuration;
};

/// Throws Refusal if the folder is in use, or holds something else or runs of another
/// configuration.
[[nodiscard]] TablesFolder OpenTablesFolder(const TablesCommand& command);

/// Why no more seeds were run.
enum class Reached { kAll, kInterrupted, kDiskFull, kRefused, kChanged };
/// Runs every seed that is not done. Throws Refusal if the runner cannot work here.
[[nodiscard]] Reached RunSeeds(const TablesCommand& command, TablesFolder& tables);

[[nodiscard]] std::size_t SeedsDone(const TablesCommand& command);

}  // namespace limpet

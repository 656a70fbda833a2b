// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "limpet/core/expected.hpp"
#include "limpet/durable/disk_jobs.hpp"
#include "limpet/durable/file_system.hpp"

namespace limpet {

/// What a mission manager must know to go on after a crash, whatever became of the database.
struct SurveyMemory {
  std::string phase = "IDLE";
  double phase_since = 0.0, deployed = 0.0;     ///< MOOS time [s]
  std::optional<double> home_north, home_east;  ///< NED [m]
  std::string ended = "home";                   ///< how the mission is to end
  std::optional<std::string> area{};            ///< SURVEY_AREA, in braces
  template <class V>
  void Describe(V& visit) {
    visit("phase", phase), visit("phase_since", phase_since), visit("deployed", deployed);
    visit("home_north", home_north), visit("home_east", home_east), visit("ended", ended);
    visit("area", area);
  }
};

/// Writes survey_state.txt of the run folder, durably, on a thread of its own: the mission does not
/// wait for a disk.
class SurveyKeeper {
 public:
  struct Outcome {
    std::optional<Error> trouble;  ///< nothing: it is on the disk
  };
  SurveyKeeper(std::filesystem::path run_folder, FileSystem& disk, bool has_thread)
      : run_folder_(std::move(run_folder)), disk_(disk), jobs_(has_thread) {}

  void Keep(const SurveyMemory& memory);
  /// What came of what was kept last, once; nothing while that is not known.
  [[nodiscard]] std::optional<Outcome> TakeOutcome();

 private:
  std::filesystem::path run_folder_;
  FileSystem& disk_;
  std::optional<Outcome> outcome_;  ///< a job's while it runs
  DiskJobs jobs_;
};

/// Nothing if there is none, or none that can be read.
[[nodiscard]] std::optional<SurveyMemory> RecallSurvey(const std::filesystem::path& run_folder);

}  // namespace limpet

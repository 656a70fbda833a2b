// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "limpet/core/expected.hpp"

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

/// Writes survey_state.txt of the run folder, durably; the complaint if that failed.
[[nodiscard]] std::optional<Error> KeepSurvey(const SurveyMemory& memory,
                                              const std::filesystem::path& run_folder);
/// Nothing if there is none, or none that can be read.
[[nodiscard]] std::optional<SurveyMemory> RecallSurvey(const std::filesystem::path& run_folder);

}  // namespace limpet

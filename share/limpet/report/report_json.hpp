// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "limpet/mission/scenario.hpp"
#include "limpet/scoring/report_settings.hpp"
#include "limpet/scoring/scorer.hpp"

namespace limpet {

/// report.json: keys in a fixed order; lengths to the millimetre,
/// shares and probabilities to four digits, so that the same seed gives the same bytes.
[[nodiscard]] std::string ReportJson(const RunScore& run);

/// run.json: how the run was made and the scenario it is judged by, so that a report can be made
/// again from the run's folder alone. Write it before the run, so that it is there after a crash.
[[nodiscard]] std::string RunJson(const ReportSettings& settings, const Scenario& scenario);

struct RunDescription {
  ReportSettings settings;
  Scenario scenario;
};
/// Reads `<run>/run.json`, and the wall times from `<run>/report.json` if there is one. Throws
/// ConfigError when the file is missing or not understood.
[[nodiscard]] RunDescription ReadRun(const std::filesystem::path& run);

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/runs/run_settings.hpp"

#include <optional>

#include "limpet/console/arguments.hpp"
#include "limpet/core/camera_params.hpp"
#include "limpet/core/number_text.hpp"
#include "limpet/helm/helm_params.hpp"
#include "limpet/runs/mission_check.hpp"
#include "limpet/survey/survey_params.hpp"

namespace limpet {
namespace {

/// What a block says under `key`; nothing if there is no such block, or it does not say it.
std::optional<double> NumberIn(const MissionFile& mission, const char* process, const char* key) {
  const ConfigBlock* block = mission.Block(process);
  const ConfigEntry* entry = block != nullptr ? block->Find(key) : nullptr;
  return ParseNumber(entry != nullptr ? entry->value : "");
}

}  // namespace

std::filesystem::path MissionFolder(const std::string& word) {
  if (word.empty()) throw UsageError("a mission folder cannot be an empty word");
  const std::filesystem::path folder = std::filesystem::path(word).lexically_normal();
  return folder.has_filename() ? folder : folder.parent_path();
}

std::string MissionName(const std::filesystem::path& folder) {
  return MissionFolder(std::filesystem::absolute(folder).string()).filename().string();
}

ReportSettings SettingsOf(const MissionFile& mission, const Scenario& scenario) {
  const auto helm = ReadAppParams<HelmParams>(mission, "pHelm");
  const auto survey = ReadAppParams<SurveyParams>(mission, "pSurvey");
  const ConfigBlock* camera = mission.Block("uSimCamera");
  const ConfigEntry* kind = camera != nullptr ? camera->Find("camera") : nullptr;
  ReportSettings settings;
  settings.planner = helm.views.planner;
  settings.gain = helm.views.gain;
  settings.camera = kind != nullptr && kind->value != "scenario" ? kind->value : scenario.camera;
  settings.camera_geometry = helm.views.camera.geometry();
  settings.frame_rate_hz =
      NumberIn(mission, "uSimCamera", "rate_hz").value_or(CameraTiming{}.rate.value());
  settings.altitude_m = survey.altitude.value();
  settings.highest_view_m =
      NumberIn(mission, "pMap", "highest_view_m").value_or(settings.highest_view_m);
  settings.turning_radius_m = helm.views.turning_radius.value();
  settings.object_height_max_m = survey.object_height_max.value();
  settings.object_radius_m =
      NumberIn(mission, "pMap", "object_radius_m").value_or(settings.object_radius_m);
  return settings;
}

}  // namespace limpet

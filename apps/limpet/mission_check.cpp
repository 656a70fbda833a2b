// SPDX-License-Identifier: MIT
#include "apps/limpet/mission_check.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "apps/limpet/session_runner.hpp"
#include "apps/pHelm/helm_params.hpp"
#include "apps/pSurvey/survey_app.hpp"
#include "limpet/helm/behavior_host.hpp"
#include "limpet/mission/expectations.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

void Add(std::vector<ConfigProblem>& problems, const std::vector<ConfigProblem>& more) {
  problems.insert(problems.end(), more.begin(), more.end());
}

/// Runs `work` and keeps the problems it throws.
template <class Work>
void Collect(std::vector<ConfigProblem>& problems, Work work) {
  try {
    work();
  } catch (const ConfigError& error) {
    Add(problems, error.problems());
  }
}

void CheckApps(const MissionFile& mission, std::vector<ConfigProblem>& problems) {
  std::vector<std::string> known;
  std::ranges::transform(AppRegistry(), std::back_inserter(known),
                         [](const auto& registered) { return registered.first; });
  for (const std::string& name : EmbeddedApps(mission)) {
    const auto entry = AppRegistry().find(name);
    if (entry == AppRegistry().end()) {
      problems.push_back(
          {{.file = mission.file, .line = 0},
           "Run",
           fmt::format("no app `{}`; nearest known: `{}`", name, NearestWord(name, known))});
    } else if (const ConfigBlock* block = mission.Block(name)) {
      Add(problems, entry->second.check(*block));
    }
  }
  // Embedded runs leave it out, but its block is wrong all the same.
  if (const ConfigBlock* block = mission.Block("pShare")) {
    Add(problems, AppRegistry().at("pShare").check(*block));
  }
}

void CheckBehaviors(const MissionFile& mission, const fs::path& folder,
                    std::vector<ConfigProblem>& problems) {
  Collect(problems, [&] {
    const auto helm = ReadAppParams<HelmParams>(mission, "pHelm");
    std::vector<BehaviorFile> files;
    for (const std::string& name : helm.behaviors) {
      files.push_back(LoadBehaviors(folder / name));
    }
    const BehaviorHost host(files, helm.behavior_setting);
  });
}

bool IsInside(const SurveyApp::Params& area, const Eigen::Vector3d& ned, double margin) {
  return ned.x() >= area.north_min.value() - margin && ned.x() <= area.north_max.value() + margin &&
         ned.y() >= area.east_min.value() - margin && ned.y() <= area.east_max.value() + margin;
}

void CheckObjects(const Scenario& scenario, const SurveyApp::Params& area, const SourceLine& where,
                  std::vector<ConfigProblem>& problems) {
  for (const ScenarioOpi& opi : scenario.opis) {
    for (const auto& [session, place] : opi.places) {
      if (!place) {
        continue;
      }
      if (!IsInside(area, *place, 0.0)) {
        problems.push_back(
            {where, opi.name,
             fmt::format("{} [{}, {}] is outside the area: north {} to {}, east {} to {}", session,
                         place->x(), place->y(), area.north_min.value(), area.north_max.value(),
                         area.east_min.value(), area.east_max.value())});
      }
      const double seabed = SeabedDepth(scenario.seabed, place->x(), place->y());
      if (place->z() > seabed + opi.radius_m || place->z() < 0.0) {
        problems.push_back(
            {where, opi.name,
             fmt::format("{} depth {} is not between the surface and the seabed at {:.2f} m",
                         session, place->z(), seabed)});
      }
    }
  }
}

}  // namespace

std::vector<ConfigProblem> CheckGeometry(const MissionFile& mission,
                                         const std::optional<Scenario>& scenario,
                                         const std::string& scenario_file) {
  std::vector<ConfigProblem> problems;
  const auto survey = ReadAppParams<SurveyApp::Params>(mission, "pSurvey");
  const auto helm = ReadAppParams<HelmParams>(mission, "pHelm");
  const SourceLine in_mission{.file = mission.file, .line = 0};
  const double narrow = std::min(survey.north_max.value() - survey.north_min.value(),
                                 survey.east_max.value() - survey.east_min.value()) +
                        2.0 * (survey.margin.value() - helm.tracking_allowance.value());
  if (narrow < 2.0 * helm.turning_radius.value()) {
    problems.push_back(
        {in_mission, "pSurvey",
         fmt::format("area and margin leave {:.1f} m, a turn of radius {} m needs {:.1f} m", narrow,
                     helm.turning_radius.value(), 2.0 * helm.turning_radius.value())});
  }
  if (survey.object_height_max.value() >= survey.altitude.value()) {
    problems.push_back({in_mission, "pSurvey",
                        "objects may float as high as the vehicle flies: object_height_max_m must "
                        "be below altitude_m"});
  }
  if (scenario) {
    const SourceLine where{.file = scenario_file, .line = 0};
    CheckObjects(*scenario, survey, where, problems);
    if (scenario->seabed.depth_m <= survey.altitude.value()) {
      problems.push_back({where, "seabed",
                          fmt::format("depth_m {} leaves no water above altitude_m {}",
                                      scenario->seabed.depth_m, survey.altitude.value())});
    }
  }
  return problems;
}

std::vector<ConfigProblem> CheckConfiguration(const MissionFile& mission, const fs::path& folder) {
  std::vector<ConfigProblem> problems;
  CheckApps(mission, problems);
  CheckBehaviors(mission, folder, problems);
  return problems;
}

MissionProblems CheckMission(const fs::path& folder) {
  MissionProblems found;
  std::optional<MissionFile> mission;
  std::optional<Scenario> scenario;
  const fs::path scenario_file = folder / "scenario.yaml";
  Collect(found.syntax, [&] { mission = LoadMission(folder / "mission.moos"); });
  Collect(found.syntax, [&] {
    if (fs::exists(scenario_file)) {
      scenario = LoadScenario(scenario_file);
    }
  });
  Collect(found.syntax,
          [&] { static_cast<void>(LoadExpectations(folder, scenario.value_or(Scenario{}))); });
  if (!mission) {
    return found;
  }
  Add(found.syntax, CheckConfiguration(*mission, folder));
  if (found.syntax.empty()) {
    Collect(found.syntax,
            [&] { found.geometry = CheckGeometry(*mission, scenario, scenario_file.string()); });
  }
  return found;
}

}  // namespace limpet

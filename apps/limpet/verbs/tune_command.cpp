// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/tune_command.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "apps/limpet/verbs/survey_options.hpp"
#include "apps/limpet/verbs/tune_form.hpp"
#include "apps/limpet/verbs/tune_keys.hpp"
#include "limpet/core/number_text.hpp"
#include "limpet/preflight/mission_reading.hpp"
#include "limpet/preflight/preflight.hpp"
#include "limpet/runs/run_settings.hpp"
#include "limpet/runs/session_runner.hpp"
#include "limpet/tuning/tuned_place.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

/// What an option says; a slip in a key is found before anything is flown for it.
ReportExpression ExpressionOf(const std::string& option, const std::string& text,
                              const Arguments& given) {
  Expected<ReportExpression> expression = ReportExpression::Parse(text);
  if (!expression) throw UsageError(fmt::format("{} {}", option, expression.error().text));
  std::vector<std::string> sessions = Split(given.Find("sessions").value_or(""), ',');
  std::ranges::transform(sessions, sessions.begin(),
                         [](const std::string& name) { return std::string(Trim(name)); });
  if (const auto problem = ImpossibleKey(*expression, sessions)) {
    throw UsageError(fmt::format("{} {}", option, *problem));
  }
  return *std::move(expression);
}

ParameterSpace SpaceOf(const Arguments& given) {
  std::vector<VariedParameter> parameters;
  for (const std::string& text : given.All("vary")) {
    Expected<VariedParameter> parameter = VariedParameter::Parse(text);
    if (!parameter) throw UsageError("--vary " + parameter.error().text);
    const bool is_double = std::ranges::any_of(parameters, [&](const VariedParameter& p) {
      return EqualsIgnoringCase(p.name, parameter->name);
    });
    if (is_double) throw UsageError(fmt::format("--vary {} is given twice", parameter->name));
    parameters.push_back(*std::move(parameter));
  }
  if (parameters.empty())
    throw UsageError("nothing to vary: --vary owner.key=low:high is expected");
  return ParameterSpace(std::move(parameters));
}

/// Throws UsageError for a range whose ends are not allowed: the search would find out run by run.
void RefuseBadRanges(const TuneCommand& command) {
  const std::vector<VariedParameter>& parameters = command.space.parameters();
  SettingValues lows, highs;
  for (const VariedParameter& parameter : parameters) {
    lows.push_back(parameter.low);
    highs.push_back(parameter.high);
  }
  for (const SettingValues& ends : {lows, highs}) {
    const MissionProblems found = CheckLoadedMission(
        MissionWith(command, command.space.TextsOf(ends)), command.plan.mission_folder);
    for (const ConfigProblem& problem : found.syntax) {
      // Of one that only does not go with another, some settings may be flown.
      if (problem.text.find("allowed: ") == std::string::npos) continue;
      const auto ranged = std::ranges::find_if(parameters, [&](const VariedParameter& parameter) {
        return problem.where.file.find(parameter.name + "=") != std::string::npos;
      });
      if (ranged == parameters.end()) continue;
      throw UsageError(fmt::format("--vary {}={:g}:{:g}: {}", ranged->name, ranged->low,
                                   ranged->high, problem.text));
    }
  }
}

}  // namespace

TuneCommand ReadTuneCommand(const Arguments& given) {
  if (given.positionals().size() != 1) throw UsageError(TuneForm().takes + " is expected");
  if (!given.Has("objective")) throw UsageError("--objective is missing");
  const fs::path mission = MissionFolder(given.positionals()[0]);
  if (!fs::exists(mission / "mission.moos")) {
    throw UsageError(fmt::format("no mission in {}", mission.string()));
  }
  TuneCommand command{.space = SpaceOf(given),
                      .objective = ExpressionOf("--objective", *given.Find("objective"), given),
                      .constraints = {},
                      .plan = {},
                      .settings = given.All("set")};
  for (const std::string& text : given.All("constraint")) {
    command.constraints.push_back(ExpressionOf("--constraint", text, given));
    if (!command.constraints.back().is_condition()) {
      throw UsageError(fmt::format("--constraint `{}` compares nothing", text));
    }
  }
  command.task = {.mission = MissionName(mission),
                  .objective = command.objective.text(),
                  .constraints = given.All("constraint"),
                  .maximises = given.Has("maximise"),
                  .first_seed = static_cast<std::uint64_t>(given.Integer("seed")),
                  .rules = {.method = *given.Find("method"),
                            .settings = given.Integer("settings"),
                            .runs = static_cast<std::size_t>(given.Integer("runs")),
                            .share = given.Number("share").value_or(1.0),
                            .seed = static_cast<std::uint64_t>(given.Integer("seed"))}};
  for (const char* option : {"planner", "gain"}) {
    if (given.Has(option))
      command.settings.push_back(fmt::format("pHelm.{}={}", option, *given.Find(option)));
  }
  const fs::path out = given.Find("out").value_or("runs/tune-" + command.task.mission);
  command.plan = {.mission_folder = mission,
                  .out = out,
                  .survey_options = SurveyOptionsGiven(given),
                  .runner = RunnerOptionsOf(given, out),
                  .keeps_runs = given.Has("keep-runs")};
  if (!MissionReading(MissionWith(command, {}), mission).Launches("pSurvey")) {
    throw UsageError(
        fmt::format("{} launches no pSurvey: limpet tune flies surveys, as limpet survey does",
                    (mission / "mission.moos").string()));
  }
  if (const auto first = FirstSettings(command.space, command.task.rules); !first) {
    throw UsageError("--vary: " + first.error().text);
  }
  static_cast<void>(DefaultOf(command));  // complains of names that there are not
  RefuseBadRanges(command);
  return command;
}

MissionFile MissionWith(const TuneCommand& command, const std::vector<std::string>& more) {
  MissionFile mission = LoadMission(command.plan.mission_folder / "mission.moos");
  for (const std::string& setting : command.settings)
    ApplySetting(mission, setting);
  for (const std::string& setting : more)
    ApplySetting(mission, setting);
  return mission;
}

SettingValues DefaultOf(const TuneCommand& command) {
  const MissionReading reading(MissionWith(command, {}), command.plan.mission_folder);
  SettingValues values;
  for (const VariedParameter& parameter : command.space.parameters()) {
    const TunedPlace place = FindTunedPlace(reading, parameter.name);
    const std::optional<double> number = ParseNumber(place.value);
    if (!number) {
      throw ConfigError(
          {place.entry, parameter.name,
           fmt::format("is `{}`, which is no number: it cannot be varied over a range",
                       place.value)});
    }
    values.push_back(*number);
  }
  return values;
}

}  // namespace limpet

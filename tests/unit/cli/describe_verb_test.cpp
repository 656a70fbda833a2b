// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "apps/limpet/cli.hpp"
#include "apps/limpet/verbs/describe.hpp"
#include "limpet/app/app_example.hpp"
#include "limpet/describe/parameter_list.hpp"
#include "limpet/describe/variable_list.hpp"
#include "limpet/helm/registry.hpp"
#include "limpet/mission/mission_file.hpp"
#include "limpet/mission/shared_settings.hpp"
#include "limpet/topics/event.hpp"
#include "limpet/topics/warning.hpp"

namespace limpet {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const std::filesystem::path kSource = LIMPET_SOURCE_DIR;

struct Output {
  int exit_code = 0;
  std::string text;
};

Output Describe(const std::vector<std::string>& args) {
  testing::internal::CaptureStdout();
  const int exit_code = RunDescribe(args);
  return {exit_code, testing::internal::GetCapturedStdout()};
}

std::string TextOf(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

TEST(Describe, SaysWhatABehaviorMayBeGiven) {
  const Output output = Describe({"BHV_HoldAltitude"});
  EXPECT_EQ(output.exit_code, kOk);
  EXPECT_THAT(output.text, HasSubstr("altitude_m: required"));
  EXPECT_THAT(output.text, HasSubstr("allowed: "));
}

TEST(Describe, SaysWhichParametersAMissionMaySayOnceForAll) {
  EXPECT_THAT(Describe({"pSurvey"}).text, HasSubstr("else the mission's global survey_altitude_m"));
  EXPECT_THAT(Describe({"pNav", "--markdown"}).text,
              HasSubstr("0: unknown; global `object_radius_m` |"));
  const auto list = nlohmann::json::parse(Describe({"BHV_RevisitOpi", "--json"}).text);
  for (const nlohmann::json& parameter : list.at(0).at("parameters")) {
    const std::string name = parameter.at("name");
    EXPECT_EQ(parameter.at("global"), name.starts_with("settled_") ? name : "");
  }
}

TEST(Describe, EveryGlobalReachesParametersThatThereAre) {
  for (const SharedSetting& setting : SharedSettings()) {
    for (const SharedSetting::Taker& taker : setting.takers) {
      const bool is_app = AppRegistry().contains(taker.owner);
      ASSERT_TRUE(is_app || BehaviorRegistry().contains(taker.owner)) << taker.owner;
      const std::vector<ParamSpec> specs = is_app ? AppRegistry().at(taker.owner).describe()
                                                  : BehaviorRegistry().at(taker.owner).describe();
      EXPECT_TRUE(std::ranges::any_of(
          specs, [&taker](const ParamSpec& spec) { return spec.name == taker.key; }))
          << taker.owner << " " << taker.key;
    }
  }
}

TEST(Describe, SaysWhatAMissionMustSay) {
  const std::string text = Describe({"pSurvey"}).text;
  EXPECT_THAT(text, HasSubstr("altitude_m: required"));
  EXPECT_THAT(text, HasSubstr("margin_m = 2 m"));
  const auto list = nlohmann::json::parse(Describe({"pSurvey", "--json"}).text);
  for (const nlohmann::json& parameter : list.at(0).at("parameters")) {
    if (parameter.at("name") == "altitude_m") {
      EXPECT_TRUE(parameter.at("required").get<bool>());
      EXPECT_TRUE(parameter.at("default").is_null());
    }
  }
  EXPECT_THAT(Describe({"pSurvey", "--markdown"}).text, HasSubstr("| `altitude_m` | required |"));
}

TEST(Describe, EveryExampleIsTakenByItsApp) {
  for (const auto& [name, entry] : AppRegistry()) {
    const std::string example = AppExample(name, entry);
    const MissionFile mission = ParseMission(example, "example.moos");
    ASSERT_NE(mission.Block(name), nullptr) << example;
    for (const ConfigProblem& problem : entry.check(*mission.Block(name))) {
      ADD_FAILURE() << name << ": " << problem.Format();
    }
    for (const ParamSpec& spec : entry.describe()) {
      EXPECT_TRUE(!spec.is_required || mission.Block(name)->Find(spec.name) != nullptr)
          << spec.name;
    }
  }
}

TEST(Describe, SaysWhoWritesAndReadsAVariable) {
  const auto list = nlohmann::json::parse(
      Describe({"variables", (kSource / "missions/table1").string(), "--json"}).text);
  const auto state = std::find_if(list.begin(), list.end(),
                                  [](const auto& v) { return v.at("name") == "NAV_STATE"; });
  ASSERT_NE(state, list.end());
  EXPECT_THAT(state->at("writers"), Contains("pNav"));
  EXPECT_THAT(state->at("readers"), Contains("pHelm"));
  EXPECT_EQ(state->at("unit"), "m, rad, s");
}

TEST(Describe, SaysWhatAWarningMeansAndWhatToDo) {
  const std::string text = Describe({"NAV_STALE"}).text;
  EXPECT_THAT(text, HasSubstr("NAV_STALE: alarm, raised by pPilot"));
  EXPECT_THAT(text, HasSubstr("to do "));
  EXPECT_THAT(text, HasSubstr("clears "));
  EXPECT_THAT(Describe({"SILENT_NAV_X"}).text, HasSubstr("SILENT_<VARIABLE>: "))
      << "the id as it was raised";
  EXPECT_THAT(Describe({"GOING_HOME"}).text, HasSubstr("GOING_HOME: event, note"));
}

TEST(Describe, ListsTheWarningsOfAppsBehaviorsAndTheDatabase) {
  const auto list = nlohmann::json::parse(Describe({"warnings", "--json"}).text);
  std::map<std::string, std::string> severities;
  for (const auto& warning : list.at("warnings")) {
    severities[warning.at("id")] = warning.at("severity");
  }
  EXPECT_EQ(severities.at("NAV_INVALID"), "alarm");
  EXPECT_EQ(severities.at("OUTSIDE_REGION"), "alarm");
  EXPECT_EQ(severities.at("OBJECTS_GIVEN_UP"), "note");
  EXPECT_TRUE(severities.contains("SLOW_<CLIENT>") && severities.contains("DOWN_<PROCESS>"));
  EXPECT_FALSE(list.at("events").empty());
}

TEST(Describe, NamesTheNearestOfAMisspeltName) {
  try {
    static_cast<void>(RunDescribe(std::vector<std::string>{"pHlem"}));
    FAIL() << "took a name that does not exist";
  } catch (const UsageError& error) {
    EXPECT_THAT(error.what(), HasSubstr("did you mean `pHelm`"));
  }
}

TEST(Describe, EveryVariableHasAMeaningARateAndAWriter) {
  for (const auto& [name, variable] : VariableCatalog()) {
    EXPECT_THAT(variable.meaning, Not(IsEmpty())) << name;
    EXPECT_THAT(variable.facts.rate, Not(IsEmpty())) << name;
    EXPECT_THAT(variable.facts.writers, Not(IsEmpty())) << name;
  }
}

TEST(Describe, EveryWarningSaysWhoRaisesItWhatItMeansWhatToDoAndWhenItClears) {
  for (const WarningDeclaration& warning : WarningCatalog()) {
    const WarningFacts& facts = warning.facts;
    for (const std::string& text : {facts.meaning, facts.action, facts.clears}) {
      EXPECT_TRUE(text.ends_with('.')) << warning.id << ": `" << text << "`";
    }
    for (const std::string& raiser : facts.raised_by) {
      const bool is_known = AppRegistry().contains(raiser) || BehaviorRegistry().contains(raiser) ||
                            raiser == "LimpetDB" || raiser == "pLaunch" || raiser == "limpet";
      EXPECT_TRUE(is_known) << warning.id << " is raised by " << raiser;
    }
  }
  for (const auto& [id, facts] : EventCatalog()) {
    EXPECT_TRUE(facts.meaning.ends_with('.')) << id;
    EXPECT_THAT(facts.reported_by, Not(IsEmpty())) << id;
  }
}

TEST(Describe, EveryWarningIsRaisedInATest) {
  // A disk that is too slow, and a step that CVODE gives up, are not to be had at will.
  const std::set<std::string> not_at_will{"LOG_DROPPED", "INTEGRATOR_FAILED"};
  std::string tests;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kSource / "tests")) {
    if (entry.path().extension() == ".cpp") tests += TextOf(entry.path());
  }
  for (const WarningDeclaration& warning : WarningCatalog()) {
    const bool is_tested = tests.find('"' + std::string(warning.stem())) != std::string::npos;
    EXPECT_TRUE(is_tested || not_at_will.contains(warning.id)) << warning.id;
  }
}

TEST(Documentation, ListsTheParametersThatTheCodeHas) {
  EXPECT_TRUE(TextOf(kSource / "docs/parameters.md") == Describe({"parameters", "--markdown"}).text)
      << "docs/parameters.md is behind the code; in the repository root run\n"
         "  ./limpet describe parameters --markdown > docs/parameters.md";
}

TEST(Documentation, ListsTheVariablesThatTheCodeHas) {
  const std::string mission = (kSource / "missions/table1").string();
  EXPECT_TRUE(TextOf(kSource / "docs/variables.md") ==
              Describe({"variables", mission, "--markdown"}).text)
      << "docs/variables.md is behind the code; in the repository root run\n"
         "  ./limpet describe variables missions/table1 --markdown > docs/variables.md";
}

TEST(Documentation, ListsTheWarningsThatTheCodeHas) {
  EXPECT_TRUE(TextOf(kSource / "docs/warnings.md") == Describe({"warnings", "--markdown"}).text)
      << "docs/warnings.md is behind the code; in the repository root run\n"
         "  ./limpet describe warnings --markdown > docs/warnings.md";
}

TEST(Documentation, ListsTheKeysOfAVehiclesFile) {
  EXPECT_TRUE(TextOf(kSource / "docs/vehicle-file.md") == Describe({"vehicle", "--markdown"}).text)
      << "docs/vehicle-file.md is behind the code; in the repository root run\n"
         "  ./limpet describe vehicle --markdown > docs/vehicle-file.md";
}

TEST(Documentation, ListsWhatAScenarioCanSayBeyondTheDataSheets) {
  EXPECT_TRUE(TextOf(kSource / "docs/scenario-file.md") ==
              Describe({"scenario", "--markdown"}).text)
      << "docs/scenario-file.md is behind the code; in the repository root run\n"
         "  ./limpet describe scenario --markdown > docs/scenario-file.md";
}

TEST(Documentation, ListsTheRulesOfPSafety) {
  EXPECT_TRUE(TextOf(kSource / "docs/safety.md") == Describe({"safety", "--markdown"}).text)
      << "docs/safety.md is behind the code; in the repository root run\n"
         "  ./limpet describe safety --markdown > docs/safety.md";
}

TEST(DescribeVerb, TellsTheKeysOfAVehiclesFileInEveryForm) {
  EXPECT_THAT(Describe({"vehicle"}).text, testing::HasSubstr("mass_kg = 35"));
  EXPECT_THAT(Describe({"vehicle", "--json"}).text, testing::HasSubstr("\"max_thrust_n\""));
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/describe.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "apps/limpet/cli.hpp"
#include "limpet/core/config.hpp"
#include "limpet/describe/parameter_list.hpp"
#include "limpet/describe/safety_list.hpp"
#include "limpet/describe/scenario_list.hpp"
#include "limpet/describe/variable_list.hpp"
#include "limpet/describe/vehicle_list.hpp"
#include "limpet/describe/warning_list.hpp"
#include "limpet/helm/behavior_modules.hpp"

namespace limpet {
namespace {

Command DescribeForm() {
  return {.name = "limpet describe",
          .words =
              "[parameters | variables [mission] | warnings | vehicle | scenario | faults | safety "
              "| NAME ...]",
          .about = R"(What the code itself says of its apps, behaviors and detectors:

  (nothing)                   their names, and those of variables and warnings
  parameters                  every parameter of them all
  variables [mission folder]  every variable; with a mission, who reads it
  warnings                    every warning and event of apps and behaviors
  vehicle                     every key of a vehicle's file
  scenario                    what a scenario can add to the data sheets
  faults                      what a scenario can let fail
  safety                      the rules of pSafety
  NAME ...                    any of these, by name)",
          .options = {{.names = "--json", .meaning = "as JSON"},
                      {.names = "--markdown",
                       .meaning = "as the pages of docs/ (parameters, variables, warnings, "
                                  "vehicle-file, scenario-file, safety)"}}};
}

enum class Form { kText, kJson, kMarkdown };

Form FormOf(const Arguments& given) {
  if (given.Has("json") && given.Has("markdown")) {
    throw UsageError("choose one of --json and --markdown");
  }
  return given.Has("json") ? Form::kJson : given.Has("markdown") ? Form::kMarkdown : Form::kText;
}

std::vector<Variable> AllVariables() {
  std::vector<Variable> variables;
  std::ranges::transform(VariableCatalog(), std::back_inserter(variables),
                         [](const auto& named) { return named.second; });
  return variables;
}

std::string Show(const std::vector<ParameterOwner>& owners, Form form) {
  if (form != Form::kText) return form == Form::kJson ? Json(owners) : Markdown(owners);
  std::string text;
  for (const ParameterOwner& owner : owners) {
    text += (text.empty() ? "" : "\n") + PlainText(owner);
  }
  return text;
}

std::string Show(const std::vector<Variable>& variables, const Readers& readers, Form form) {
  if (form != Form::kText) {
    return form == Form::kJson ? Json(variables, readers) : Markdown(variables, readers);
  }
  std::string text;
  for (const Variable& variable : variables) {
    text += (text.empty() ? "" : "\n") + PlainText(variable, readers);
  }
  return text;
}

std::string Show(const WarningList& list, Form form) {
  if (form == Form::kJson) return Json(list);
  return form == Form::kText ? PlainText(list) : Markdown(list);
}

std::string ShowVehicleKeys(Form form) {
  if (form == Form::kJson) return VehicleKeysJson();
  return form == Form::kText ? VehicleKeysText() : VehicleKeysMarkdown();
}

std::string ShowScenarioKeys(Form form) {
  if (form == Form::kJson) return ScenarioKeysJson();
  return form == Form::kText ? ScenarioKeysText() : ScenarioKeysMarkdown();
}

std::string ShowSafetyRules(Form form) {
  if (form == Form::kJson) throw UsageError("safety has no --json; SAFETY_STATE is JSON");
  return form == Form::kText ? SafetyRulesText(SafetySettings()) : SafetyRulesMarkdown();
}

std::string ShowNames(Form form) {
  if (form != Form::kText) {
    throw UsageError(
        "say what to describe: parameters, variables, warnings, vehicle, scenario, faults, safety, "
        "or names");
  }
  std::string text = "apps, behaviors, detectors:\n";
  for (const ParameterOwner& owner : AllParameterOwners()) {
    text += fmt::format("  {} ({} parameters)\n", owner.name, owner.parameters.size());
  }
  text += "variables:\n";
  for (const auto& [name, variable] : VariableCatalog()) {
    text += fmt::format("  {:<22} {}\n", name, variable.meaning);
  }
  text += "warnings:\n";
  for (const WarningDeclaration& warning : WarningCatalog()) {
    text += fmt::format("  {:<22} {}\n", warning.id, warning.facts.meaning);
  }
  return text;
}

std::string ShowVariables(std::span<const std::string> mission, Form form) {
  if (mission.size() > 1) throw UsageError("describe variables takes one mission folder");
  return Show(AllVariables(), mission.empty() ? Readers{} : ReadersOf(mission[0]), form);
}

/// What names on the command line stand for.
struct Described {
  std::vector<ParameterOwner> owners;
  std::vector<Variable> variables;
  WarningList warnings;

  /// False if nothing has this name.
  bool Add(const std::string& name) {
    const std::vector<ParameterOwner> all = AllParameterOwners();
    const auto owner = std::ranges::find_if(
        all, [&name](const ParameterOwner& other) { return EqualsIgnoringCase(name, other.name); });
    if (owner != all.end()) {
      owners.push_back(*owner);
      return true;
    }
    if (const auto found = VariableCatalog().find(name); found != VariableCatalog().end()) {
      variables.push_back(found->second);
      return true;
    }
    const auto events = EventCatalog().find(name);
    if (events != EventCatalog().end()) warnings.events.insert(*events);
    const std::size_t before = warnings.warnings.size();
    std::ranges::copy_if(WarningCatalog(), std::back_inserter(warnings.warnings),
                         [&name](const WarningDeclaration& warning) {
                           return warning.id == name || warning.Covers(name);
                         });
    return events != EventCatalog().end() || warnings.warnings.size() > before;
  }
  [[nodiscard]] bool has_warnings() const {
    return !warnings.warnings.empty() || !warnings.events.empty();
  }
};

[[noreturn]] void RefuseName(const std::string& name) {
  std::vector<std::string> known{"parameters", "variables", "warnings", "vehicle",
                                 "scenario",   "faults",    "safety"};
  std::ranges::transform(AllParameterOwners(), std::back_inserter(known), &ParameterOwner::name);
  for (const auto& [variable, facts] : VariableCatalog())
    known.push_back(variable);
  std::ranges::transform(WarningCatalog(), std::back_inserter(known), &WarningDeclaration::id);
  const std::string nearest = NearestWord(name, known);
  throw UsageError(
      fmt::format("no app, behavior, detector, variable or warning `{}`{}", name,
                  nearest.empty() ? "" : fmt::format("; did you mean `{}`?", nearest)));
}

std::string ShowNamed(std::span<const std::string> names, Form form) {
  Described found;
  for (const std::string& name : names) {
    if (!found.Add(name)) RefuseName(name);
  }
  const int kinds = (found.owners.empty() ? 0 : 1) + (found.variables.empty() ? 0 : 1) +
                    (found.has_warnings() ? 1 : 0);
  if (kinds > 1 && form == Form::kJson) {
    throw UsageError("--json describes variables, warnings, or who has parameters, one at a time");
  }
  return (found.owners.empty() ? "" : Show(found.owners, form)) +
         (found.variables.empty() ? "" : Show(found.variables, {}, form)) +
         (found.has_warnings() ? Show(found.warnings, form) : "");
}

int DescribeNamed(const Arguments& given) {
  const Form form = FormOf(given);
  LoadBehaviorModules({}, {});  // those of the environment
  const std::span<const std::string> words = given.positionals();
  if (words.empty()) {
    fmt::print("{}", ShowNames(form));
  } else if (words[0] == "variables") {
    fmt::print("{}", ShowVariables(words.subspan(1), form));
  } else if (words[0] == "parameters") {
    if (words.size() > 1) throw UsageError("describe parameters takes nothing else");
    fmt::print("{}", Show(AllParameterOwners(), form));
  } else if (words[0] == "warnings") {
    if (words.size() > 1) throw UsageError("describe warnings takes nothing else");
    fmt::print("{}", Show(WarningList{WarningCatalog(), EventCatalog()}, form));
  } else if (words[0] == "vehicle") {
    if (words.size() > 1) throw UsageError("describe vehicle takes nothing else");
    fmt::print("{}", ShowVehicleKeys(form));
  } else if (words[0] == "scenario") {
    if (words.size() > 1) throw UsageError("describe scenario takes nothing else");
    fmt::print("{}", ShowScenarioKeys(form));
  } else if (words[0] == "faults") {
    if (words.size() > 1 || form != Form::kText) {
      throw UsageError(
          "describe faults takes nothing else; --markdown: they are in scenario's page");
    }
    fmt::print("{}", FaultsText());
  } else if (words[0] == "safety") {
    if (words.size() > 1) throw UsageError("describe safety takes nothing else");
    fmt::print("{}", ShowSafetyRules(form));
  } else {
    fmt::print("{}", ShowNamed(words, form));
  }
  return kOk;
}

}  // namespace

int RunDescribe(std::span<const std::string> args) {
  return RunCommand(DescribeForm(), args, DescribeNamed);
}

}  // namespace limpet

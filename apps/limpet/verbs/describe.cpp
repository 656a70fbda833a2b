// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/describe.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "apps/limpet/cli.hpp"
#include "apps/limpet/describe/parameter_list.hpp"
#include "apps/limpet/describe/variable_list.hpp"
#include "limpet/core/config.hpp"

namespace limpet {
namespace {

constexpr const char* kDescribeHelp =
    R"(usage: limpet describe                             names of apps, behaviors and variables
       limpet describe parameters                  every parameter of every app and behavior
       limpet describe variables [mission folder]  every variable; with a mission, who reads it
       limpet describe NAME...                     apps, behaviors or variables, by name

  --json               as JSON
  --markdown           as the pages of docs/ (parameters and variables)
)";

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

std::string ShowNames(Form form) {
  if (form != Form::kText)
    throw UsageError("say what to describe: parameters, variables, or names");
  std::string text = "apps, behaviors:\n";
  for (const ParameterOwner& owner : AllParameterOwners()) {
    text += fmt::format("  {} ({} parameters)\n", owner.name, owner.parameters.size());
  }
  text += "variables:\n";
  for (const auto& [name, variable] : VariableCatalog()) {
    text += fmt::format("  {:<22} {}\n", name, variable.meaning);
  }
  return text;
}

std::string ShowVariables(std::span<const std::string> mission, Form form) {
  if (mission.size() > 1) throw UsageError("describe variables takes one mission folder");
  return Show(AllVariables(), mission.empty() ? Readers{} : ReadersOf(mission[0]), form);
}

std::string ShowNamed(std::span<const std::string> names, Form form) {
  std::vector<ParameterOwner> owners;
  std::vector<Variable> variables;
  const std::vector<ParameterOwner> all = AllParameterOwners();
  std::vector<std::string> known{"parameters", "variables"};
  std::ranges::transform(all, std::back_inserter(known), &ParameterOwner::name);
  for (const auto& [name, variable] : VariableCatalog())
    known.push_back(name);
  for (const std::string& name : names) {
    const auto is_named = [&name](const std::string& other) {
      return EqualsIgnoringCase(name, other);
    };
    const auto owner = std::ranges::find_if(all, is_named, &ParameterOwner::name);
    const auto variable = VariableCatalog().find(name);
    if (owner != all.end()) {
      owners.push_back(*owner);
    } else if (variable != VariableCatalog().end()) {
      variables.push_back(variable->second);
    } else {
      const std::string nearest = NearestWord(name, known);
      throw UsageError(
          fmt::format("no app, behavior or variable `{}`{}", name,
                      nearest.empty() ? "" : fmt::format("; did you mean `{}`?", nearest)));
    }
  }
  if (!owners.empty() && !variables.empty() && form == Form::kJson) {
    throw UsageError("--json describes either variables, or apps and behaviors, at a time");
  }
  return (owners.empty() ? "" : Show(owners, form)) +
         (variables.empty() ? "" : Show(variables, {}, form));
}

}  // namespace

int RunDescribe(std::span<const std::string> args) {
  const Arguments given(args, {}, {"json", "markdown", "help"});
  if (given.Has("help")) {
    fmt::print("{}", kDescribeHelp);
    return kOk;
  }
  const Form form = FormOf(given);
  const std::span<const std::string> words = given.positionals();
  if (words.empty()) {
    fmt::print("{}", ShowNames(form));
  } else if (words[0] == "variables") {
    fmt::print("{}", ShowVariables(words.subspan(1), form));
  } else if (words[0] == "parameters") {
    if (words.size() > 1) throw UsageError("describe parameters takes nothing else");
    fmt::print("{}", Show(AllParameterOwners(), form));
  } else {
    fmt::print("{}", ShowNamed(words, form));
  }
  return kOk;
}

}  // namespace limpet

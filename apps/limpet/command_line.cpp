// SPDX-License-Identifier: MIT
#include "apps/limpet/command_line.hpp"

#include <exception>
#include <span>

#include <fmt/format.h>

#include "apps/limpet/cli.hpp"
#include "apps/limpet/verbs/verbs.hpp"
#include "limpet/console/command_output.hpp"
#include "limpet/console/shown_text.hpp"
#include "limpet/core/config.hpp"

namespace limpet {
namespace {

void PrintVerbs() {
  fmt::print(
      "limpet: cover the seabed, look again, go home, say what changed\n\n"
      "usage: limpet <verb> [options]\n\n");
  for (const Verb& verb : Verbs()) {
    fmt::print("  {:<10} {}\n", verb.name, verb.summary);
  }
  fmt::print(
      "\n`limpet help <verb>` says more. ./limpet build builds, ./limpet test runs\n"
      "every test.\n");
}

const Verb& VerbOf(const std::string& word) {
  std::vector<std::string> names;
  for (const Verb& verb : Verbs()) {
    if (word == verb.name) return verb;
    names.emplace_back(verb.name);
  }
  const std::string nearest = NearestWord(word, names);
  throw UsageError(
      fmt::format("no verb `{}`{}; `limpet --help` lists them", word,
                  nearest.empty() ? "" : fmt::format("; did you mean `{}`?", nearest)));
}

int Dispatch(const std::vector<std::string>& words) {
  const bool asks_for_help =
      !words.empty() && (words[0] == "--help" || words[0] == "-h" || words[0] == "help");
  if (words.empty() || (asks_for_help && words.size() == 1)) {
    PrintVerbs();
    return words.empty() ? kUsage : kOk;
  }
  if (asks_for_help) {  // `limpet help log grep` is `limpet log grep --help`
    std::vector<std::string> rest(words.begin() + 2, words.end());
    rest.emplace_back("--help");
    return VerbOf(words[1]).run(rest);
  }
  if (words[0] == "--version") {
    fmt::print("limpet 0.1.0\n");
    return kOk;
  }
  return VerbOf(words[0]).run(std::span(words).subspan(1));
}

void Say(const char* what) {
  for (const std::string& line : Split(what, '\n')) {
    fmt::print(stderr, "limpet: {}\n", OneLine(line));
  }
}

void SayProblems(const ConfigError& error) {
  for (const ConfigProblem& problem : error.problems()) {
    fmt::print(stderr, "{}\n", OneLine(problem.Format()));
  }
}

}  // namespace

int RunCommandLine(const std::vector<std::string>& words) {
  try {
    return Dispatch(words);
  } catch (const UsageError& error) {
    Say(error.what());
    return kUsage;
  } catch (const ConfigError& error) {
    SayProblems(error);
    return kUsage;
  } catch (const Refusal& error) {
    Say(error.what());
    return kRefused;
  } catch (const std::exception& error) {
    Say(error.what());
    return kFailed;
  }
}

}  // namespace limpet

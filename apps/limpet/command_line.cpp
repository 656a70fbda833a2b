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
      "limpet: cover the seabed, look again, go home, say what changed\n\nusage: limpet <verb> "
      "[options]\n\n");
  for (const Verb& verb : Verbs()) {
    fmt::print("  {:<10} {}\n", verb.name, verb.summary);
  }
  fmt::print(
      "\n`limpet <verb> --help` says more. ./limpet build builds, ./limpet test runs every "
      "test.\n");
}

int Dispatch(const std::vector<std::string>& words) {
  if (words.empty() || words[0] == "--help" || words[0] == "help") {
    PrintVerbs();
    return words.empty() ? kUsage : kOk;
  }
  if (words[0] == "--version") {
    fmt::print("limpet 0.1.0\n");
    return kOk;
  }
  std::vector<std::string> names;
  for (const Verb& verb : Verbs()) {
    if (words[0] == verb.name) {
      return verb.run(std::span(words).subspan(1));
    }
    names.emplace_back(verb.name);
  }
  const std::string nearest = NearestWord(words[0], names);
  throw UsageError(
      fmt::format("no verb `{}`{}; `limpet --help` lists them", words[0],
                  nearest.empty() ? "" : fmt::format("; did you mean `{}`?", nearest)));
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

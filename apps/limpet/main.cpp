// SPDX-License-Identifier: MIT
// limpet: one command in front of everything.
#include <algorithm>
#include <csignal>
#include <exception>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "apps/limpet/cli.hpp"
#include "apps/limpet/session_runner.hpp"
#include "apps/limpet/verbs/verbs.hpp"
#include "limpet/console/shown_text.hpp"
#include "limpet/core/config.hpp"

namespace {

void OnSignal(int signal) {
  limpet::interrupt_requested = true;
  std::signal(signal, SIG_DFL);  // a second Ctrl-C kills
}

void PrintHelp() {
  fmt::print(
      "limpet: cover the seabed, look again, go home, say what changed\n\nusage: limpet <verb> "
      "[options]\n\n");
  for (const limpet::Verb& verb : limpet::Verbs()) {
    fmt::print("  {:<10} {}\n", verb.name, verb.summary);
  }
  fmt::print(
      "\n`limpet <verb> --help` says more. ./limpet build builds, ./limpet test runs every "
      "test.\n");
}

int Dispatch(const std::vector<std::string>& words) {
  if (words.empty() || words[0] == "--help" || words[0] == "help") {
    PrintHelp();
    return words.empty() ? limpet::kUsage : limpet::kOk;
  }
  if (words[0] == "--version") {
    fmt::print("limpet 0.1.0\n");
    return limpet::kOk;
  }
  std::vector<std::string> names;
  for (const limpet::Verb& verb : limpet::Verbs()) {
    if (words[0] == verb.name) {
      return verb.run(std::span(words).subspan(1));
    }
    names.emplace_back(verb.name);
  }
  const std::string nearest = limpet::NearestWord(words[0], names);
  throw limpet::UsageError(
      fmt::format("no verb `{}`{}; `limpet --help` lists them", words[0],
                  nearest.empty() ? "" : fmt::format("; did you mean `{}`?", nearest)));
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGINT, OnSignal);
  std::signal(SIGTERM, OnSignal);
  try {
    return Dispatch(std::vector<std::string>(argv + 1, argv + argc));
  } catch (const limpet::UsageError& error) {
    fmt::print(stderr, "limpet: {}\n", limpet::ShownLines(error.what()));
    return limpet::kUsage;
  } catch (const limpet::ConfigError& error) {
    fmt::print(stderr, "{}\n", limpet::ShownLines(error.what()));
    return limpet::kUsage;
  } catch (const std::exception& error) {
    fmt::print(stderr, "limpet: {}\n", limpet::ShownLines(error.what()));
    return limpet::kFailed;
  }
}

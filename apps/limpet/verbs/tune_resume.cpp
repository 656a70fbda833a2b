// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/tune_resume.hpp"

#include <algorithm>
#include <array>
#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "apps/limpet/verbs/tune_form.hpp"
#include "limpet/console/command_output.hpp"
#include "limpet/console/shown_text.hpp"
#include "limpet/runs/run_settings.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

/// Options that say how a search is run and shown, not what it finds.
constexpr std::array kOfThisCall{"--jobs", "--runner", "--runner-options", "--keep-runs", "--json"};
/// What the folder is said by.
constexpr std::array kFolders{"--out", "--resume"};

template <std::size_t N>
bool IsAmong(const CommandOption& option, const std::array<const char*, N>& names) {
  return std::ranges::find(names, option.names) != names.end();
}

/// Name by which code asks for the value of an option: the long one, without its dashes.
std::string NameOf(const CommandOption& option) {
  const std::string from = option.names.substr(option.names.find("--") + 2);
  return from.substr(0, from.find(','));
}

/// `--runs=3`, or what it is where the option is not given.
std::string Shown(const CommandOption& option, const Arguments& words) {
  std::vector<std::string> values = words.All(NameOf(option));
  if (!option.is_repeatable) {
    const auto last = words.Find(NameOf(option));
    values = last ? std::vector<std::string>{*last} : std::vector<std::string>{};
  }
  if (values.empty()) return fmt::format("without --{}", NameOf(option));
  if (option.value.empty()) return fmt::format("with --{}", NameOf(option));
  for (std::string& value : values)
    value = fmt::format("--{}={}", NameOf(option), value);
  return fmt::format("with {}", fmt::join(values, " "));
}

/// REQUIRES: `given` has the option.
bool Agrees(const CommandOption& option, const Arguments& before, const Arguments& given) {
  const std::string name = NameOf(option);
  if (option.value.empty()) return before.Has(name);
  if (!option.is_repeatable) return before.Find(name) == given.Find(name);
  const std::vector<std::string> known = before.All(name);
  return std::ranges::all_of(given.All(name), [&known](const std::string& value) {
    return std::ranges::find(known, value) != known.end();
  });
}

[[noreturn]] void Refuse(const std::string& folder, const std::string& before,
                         const std::string& now) {
  throw Refusal(
      fmt::format("the search in {} was asked for {}, not {}: leave that out, or choose "
                  "another --out for a new one",
                  OneLine(folder), OneLine(before), OneLine(now)));
}

void CompareMissions(const Arguments& before, const Arguments& given) {
  for (const std::string& mission : given.positionals()) {
    const std::string& former = before.positionals().front();
    const auto place = [](const std::string& word) {
      return fs::weakly_canonical(fs::absolute(MissionFolder(word)));
    };
    if (place(mission) != place(former)) {
      Refuse(*given.Find("resume"), "with the mission " + former, "with " + mission);
    }
  }
}

}  // namespace

std::vector<std::string> ResumedWords(const std::vector<std::string>& asked,
                                      const Arguments& given) {
  const Command form = TuneForm();
  const Arguments before = ReadArguments(form, asked);
  CompareMissions(before, given);
  std::vector<std::string> words = asked;
  for (const CommandOption& option : form.options) {
    if (IsAmong(option, kFolders) || !given.Has(NameOf(option))) continue;
    if (IsAmong(option, kOfThisCall)) {
      const std::string value = option.value.empty() ? "" : "=" + *given.Find(NameOf(option));
      words.push_back(fmt::format("--{}{}", NameOf(option), value));
    } else if (!Agrees(option, before, given)) {
      Refuse(*given.Find("resume"), Shown(option, before), Shown(option, given));
    }
  }
  words.push_back("--out=" + *given.Find("resume"));
  return words;
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/safety.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <vector>

#include <fmt/format.h>

#include "apps/limpet/cli.hpp"
#include "apps/limpet/verbs/scratch_folder.hpp"
#include "limpet/core/app_keys.hpp"
#include "limpet/describe/safety_list.hpp"
#include "limpet/mission/mission_file.hpp"
#include "limpet/mission/scenario.hpp"
#include "limpet/mission/scenario_place.hpp"
#include "limpet/runs/flown_mission.hpp"
#include "limpet/safety/safety_params.hpp"
#include "limpet/safety_trials/safety_trial.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

Command SafetyForm() {
  return {
      .name = "limpet safety",
      .words = "list [mission] | test <mission>",
      .about = R"(The safety rules of pSafety (what each one watches: docs/safety.md).

  list [mission]  limits, waiting times, what each rule asks for in each phase
                  and when it lets go; with a mission: with its limits
  test <mission>  flies the mission, shortened and with boxes for a camera,
                  once for each fault and phase that it may begin in, and
                  prints what its rule asked for, after how long ("-": nothing,
                  as the table says, or it was over before))",
      .options = {{.names = "--seed",
                   .value = "N",
                   .meaning = "of the flights",
                   .fallback = "1",
                   .rule = WholeNumber(0)},
                  {.names = "--only", .value = "WORD", .meaning = "faults with it in their name"}},
      .more =
          "A mission is its folder, or a .moos file. Exit code 1 if `test` finds an answer "
          "that is not the table's, comes late, or leaves the vehicle below.",
      .takes = "`list` and perhaps a mission, or `test` and a mission",
      .least_words = 1,
      .most_words = 2};
}

fs::path MissionFileOf(const std::string& path) {
  if (!fs::exists(path)) {
    throw UsageError(fmt::format("{}: there is no such file or folder", path));
  }
  return FlownMissionAt(path);
}

SafetySettings SettingsOf(const std::string& path) {
  const MissionFile mission = LoadMission(MissionFileOf(path));
  const ConfigBlock* block = mission.Block("pSafety");
  if (block == nullptr) {
    throw UsageError(fmt::format("{}: the mission has no block of pSafety", path));
  }
  return ReadParams<SafetyParams>(*block, CommonAppKeys()).Applied("pSafety");
}

int ListRules(std::span<const std::string> missions) {
  fmt::print("{}",
             SafetyRulesText(missions.empty() ? SafetySettings() : SettingsOf(missions.front())));
  return kOk;
}

std::string TrialText(const SafetyTrialResult& result) {
  std::string answer = result.instead.empty() ? "-" : "other rule";
  if (result.action != SafetyAction::kNone) {
    answer = fmt::format("{} {:.1f} s", NameOf(result.action), result.after_s);
  }
  return result.complaint.empty() ? answer : "! " + answer;
}

/// What the table of flights has no room for, line by line.
struct TrialRemarks {
  std::vector<std::string> complaints, notes;
};

/// Flies one fault in every phase.
void FlyRow(const MissionFile& mission, const TrialPlaces& places, const SafetyCase& tested,
            std::uint64_t seed, TrialRemarks& remarks) {
  fmt::print("{:<18}{:<24}", tested.name, SafetyRuleOf(tested.rule).name);
  for (const SafetyPhase phase : kTriedPhases) {
    if (!tested.ShowsFrom(phase)) {
      fmt::print("{:<15}", "");
      continue;
    }
    const SafetyTrialResult result = FlySafetyTrial(mission, places, tested, phase, seed);
    fmt::print("{:<15}", TrialText(result));
    std::fflush(stdout);
    const auto remark = [&](std::vector<std::string>& lines, const std::string& text) {
      if (!text.empty()) {
        lines.push_back(fmt::format("{} in {}: {}", tested.name, NameOf(phase), text));
      }
    };
    remark(remarks.complaints, result.complaint);
    remark(remarks.notes, result.instead);
  }
  fmt::print("\n");
}

/// Those whose names hold a word. Throws UsageError if none does.
std::vector<SafetyCase> CasesNamed(const std::string& word) {
  std::vector<SafetyCase> cases;
  std::vector<std::string> names;
  for (const SafetyCase& tested : SafetyCases()) {
    names.emplace_back(tested.name);
    if (tested.name.find(word) != std::string_view::npos) cases.push_back(tested);
  }
  if (cases.empty()) {
    const std::string nearest = NearestWord(word, names);
    throw UsageError(fmt::format("--only {}: no fault has it in its name; {}", word,
                                 nearest.empty() ? fmt::format("faults: {}", fmt::join(names, ", "))
                                                 : fmt::format("did you mean `{}`?", nearest)));
  }
  return cases;
}

int TestRules(const Arguments& given, const std::string& path) {
  const fs::path file = MissionFileOf(path);
  const MissionFile mission = ShortenedForTrials(LoadMission(file));
  const ScratchFolder scratch("limpet_safety");
  const TrialPlaces places{.mission_folder = file.has_parent_path() ? file.parent_path() : ".",
                           .scratch = scratch.path()};
  if (!LoadScenario(ScenarioFileOf(mission, places.mission_folder)).faults.empty()) {
    throw UsageError(fmt::format(
        "{}: its scenario has `faults` of its own; take them out to try the rules", path));
  }
  const std::vector<SafetyCase> cases = CasesNamed(given.Find("only").value_or(""));
  fmt::print("{:<18}{:<24}", "fault", "rule");
  for (const SafetyPhase phase : kTriedPhases) {
    fmt::print("{:<15}", NameOf(phase));
  }
  fmt::print("\n");
  TrialRemarks remarks;
  for (const SafetyCase& tested : cases) {
    FlyRow(mission, places, tested, static_cast<std::uint64_t>(given.Integer("seed")), remarks);
  }
  for (const std::string& note : remarks.notes) {
    fmt::print("other rule: {}\n", note);
  }
  const std::vector<std::string>& complaints = remarks.complaints;
  for (const std::string& complaint : complaints) {
    fmt::print("{}\n", complaint);
  }
  fmt::print("{}\n", complaints.empty()
                         ? "every answer is the table's"
                         : fmt::format("{} answers are not the table's", complaints.size()));
  return complaints.empty() ? kOk : kFailed;
}

int DoSafety(const Arguments& given) {
  const std::span<const std::string> words(given.positionals());
  if (words[0] == "list") return ListRules(words.subspan(1));
  if (words[0] != "test" || words.size() != 2) {
    throw UsageError("limpet safety does `list [mission]` and `test <mission>`");
  }
  return TestRules(given, words[1]);
}

}  // namespace

int RunSafety(std::span<const std::string> args) {
  return RunCommand(SafetyForm(), args, DoSafety);
}

}  // namespace limpet

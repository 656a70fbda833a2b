// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/safety.hpp"

#include <filesystem>

#include <fmt/format.h>

#include "apps/limpet/cli.hpp"
#include "limpet/core/app_keys.hpp"
#include "limpet/describe/safety_list.hpp"
#include "limpet/mission/mission_file.hpp"
#include "limpet/safety/safety_params.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

Command SafetyForm() {
  return {.name = "limpet safety",
          .words = "list [mission folder | file.moos]",
          .about =
              "The safety rules of pSafety: what each one's limit is, how long it waits, what "
              "it asks for in each phase of a mission, and when it lets go. With a mission: "
              "with that mission's limits. What each rule watches: docs/safety.md.",
          .options = {},
          .takes = "`list` and perhaps a mission",
          .least_words = 1,
          .most_words = 2};
}

SafetySettings SettingsOf(const std::string& path) {
  if (!fs::exists(path)) {
    throw UsageError(fmt::format("{}: there is no such file or folder", path));
  }
  const MissionFile mission =
      LoadMission(fs::is_directory(path) ? fs::path(path) / "mission.moos" : fs::path(path));
  const ConfigBlock* block = mission.Block("pSafety");
  if (block == nullptr) {
    throw UsageError(fmt::format("{}: the mission has no block of pSafety", path));
  }
  return ReadParams<SafetyParams>(*block, CommonAppKeys()).Applied("pSafety");
}

int ListRules(const Arguments& given) {
  const auto words = given.positionals();
  if (words[0] != "list") {
    throw UsageError(
        fmt::format("`{}` is nothing that `limpet safety` does; it does `list`", words[0]));
  }
  fmt::print("{}", SafetyRulesText(words.size() > 1 ? SettingsOf(words[1]) : SafetySettings()));
  return kOk;
}

}  // namespace

int RunSafety(std::span<const std::string> args) {
  return RunCommand(SafetyForm(), args, ListRules);
}

}  // namespace limpet

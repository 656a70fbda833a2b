// SPDX-License-Identifier: MIT
#include "limpet/mission/stand_ins.hpp"

#include <algorithm>

#include "limpet/core/program_search.hpp"
#include "limpet/mission/mission_file.hpp"
#include "limpet/mission/mission_lines.hpp"
#include "limpet/mission/mission_places.hpp"

namespace limpet {
namespace {

bool Says(const ConfigBlock& block, const StandInLine& line) {
  return std::ranges::any_of(block.entries, [&line](const ConfigEntry& entry) {
    return EqualsIgnoringCase(entry.key, line.key) ||
           std::ranges::any_of(line.other_names, [&entry](const std::string& name) {
             return EqualsIgnoringCase(entry.key, name);
           });
  });
}

void NotePassedOver(ConfigBlock& block, std::vector<ConfigProblem>& warnings) {
  std::erase_if(block.problems, [&warnings](const ConfigProblem& problem) {
    if (!IsPassedOver(problem)) return false;
    warnings.push_back(problem);
    warnings.back().text += problem.key.starts_with('$') ? "; its bare name is left, as by MOOS"
                                                         : "; ignored, as by MOOS";
    return true;
  });
}

}  // namespace

std::span<const ProgramStandIn> StandIns() {
  static const std::vector<ProgramStandIn> all{
      {.stock = "pHelmIvP",
       .own = "pHelm",
       .lines = {{.key = "start_in_drive",
                  .value = "false",
                  .other_names = {"start_indrive", "start_engaged", "active_start"}},
                 {.key = "at_points", .value = "true"},
                 {.key = "survey_altitude_m", .value = "4"},
                 {.key = "turning_radius_m", .value = "3"},
                 {.key = "camera_fov_across_deg", .value = "80"},
                 {.key = "camera_fov_along_deg", .value = "60"},
                 {.key = "camera_width_px", .value = "640"},
                 {.key = "camera_height_px", .value = "480"}}}};
  return all;
}

const ProgramStandIn* StandInFor(std::string_view program) {
  const auto found = std::ranges::find_if(StandIns(), [program](const ProgramStandIn& stand_in) {
    return EqualsIgnoringCase(stand_in.stock, program);
  });
  return found == StandIns().end() ? nullptr : &*found;
}

std::string OwnNameOf(std::string_view program) {
  const ProgramStandIn* stand_in = StandInFor(program);
  return stand_in == nullptr ? std::string(program) : stand_in->own;
}

bool IsStoodInFor(std::string_view program) {
  const ProgramStandIn* stand_in = StandInFor(program);
  return stand_in != nullptr && !FindOnPath(stand_in->stock);
}

void TakeStandInLines(MissionFile& mission) {
  for (ConfigBlock& block : mission.blocks) {
    const ProgramStandIn* stand_in = StandInFor(ProgramOfBlock(block, mission));
    if (stand_in == nullptr) continue;
    NotePassedOver(block, mission.warnings);
    for (const StandInLine& line : stand_in->lines) {
      if (!Says(block, line)) block.entries.push_back({line.key, line.value, block.where});
    }
  }
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/comparison/session_comparison.hpp"

#include <cstddef>

#include "estimation/change/frame_gate.hpp"
#include "estimation/change/object_statuses.hpp"
#include "estimation/mapping/former_map.hpp"
#include "limpet/comparison/session_matches.hpp"
#include "limpet/core/app_keys.hpp"
#include "limpet/core/config.hpp"
#include "limpet/mission/mission_file.hpp"
#include "limpet/session/datum.hpp"

namespace limpet {
namespace {

/// pMap's block for a session: of `mission` if given, else of the session's own mission.
ConfigBlock MapBlockFor(const SavedSession& session, const std::optional<std::string>& mission) {
  std::optional<ConfigBlock> block;
  if (mission) {
    const MissionFile file = LoadMission(*mission);
    if (const ConfigBlock* found = file.Block("pMap")) block = *found;
  } else {
    block = BlockOf(session, "pMap");
  }
  if (!block) {
    throw ConfigError(ConfigProblem{
        .where = {.file = mission.value_or(session.folder.string()), .line = 0},
        .key = "",
        .text = "no mission with a block `ProcessConfig = pMap`: give one with --mission"});
  }
  return *block;
}

SessionPrior PriorFrom(const SavedSession& a, const ConfigBlock& block) {
  SessionPrior prior = PriorOf(a.facts, a.memory);
  for (const ConfigEntry& entry : block.entries) {
    prior.map_parameters.push_back({entry.key, entry.value});
  }
  return prior;
}

/// Parameters are read here, where a problem has a file and a line.
MapParams MapParamsOf(const ConfigBlock& block) {
  return ReadParams<MapParams>(block, CommonAppKeys());
}

/// What session B, replayed, believes about the objects of both.
ObjectStatuses Compare(const SavedSession& a, const SavedSession& b,
                       const std::optional<std::string>& mission) {
  RequireOneDatum(a.facts, b.facts, a.folder);
  const ConfigBlock block_a = MapBlockFor(a, mission);
  static_cast<void>(MapParamsOf(block_a));
  const MapParams params = MapParamsOf(MapBlockFor(b, mission));
  ObjectStatuses statuses(params.status, params.camera.geometry());
  const SessionPrior prior = PriorFrom(a, block_a);
  statuses.SetFormerViews(FormerViewsOf(prior, params));
  statuses.SetFormer(prior.former.objects);
  statuses.SetObstacles(b.memory.obstacles.obstacles);
  FrameGate gate(params.frame_gate());
  const std::vector<std::string> phase_of = PhaseOfFrames(b.memory);
  for (std::size_t i = 0; i < phase_of.size(); ++i) {
    const ObservedFrame& frame = b.memory.frames[i];
    if (!gate.Judge(frame.exposure, frame.altitude, phase_of[i]).drop) {
      statuses.AddFrame(frame);
    }
  }
  if (b.memory.water) {
    statuses.contrasts().Set(b.memory.water->contrasts);
  }
  statuses.SetLandmarks(MatchedLandmarks(a, b, prior));
  statuses.Rejudge();
  return statuses;
}

/// True for a place that is only worth a look: nothing was judged there.
bool IsTentative(const OpiBelief& object) { return !object.landmark && !object.former_id; }

}  // namespace

std::optional<Eigen::Vector3d> SessionComparison::MovedFrom_W(const OpiBelief& object) const {
  if (object.decided != Status::kMoved || !object.former_id) return std::nullopt;
  const auto former = former_W.find(*object.former_id);
  return former != former_W.end() ? std::optional(former->second) : std::nullopt;
}

SessionComparison CompareSessions(const SavedSession& a, const SavedSession& b,
                                  const std::optional<std::string>& mission) {
  ObjectStatuses statuses = Compare(a, b, mission);
  SessionComparison comparison{.a = a.facts, .b = b.facts, .offset = {}, .objects = {}};
  for (const OpiBelief& object : statuses.Assess()) {
    if (!IsTentative(object)) comparison.objects.push_back(object);
  }
  comparison.offset = statuses.offset();
  for (const FormerObject& former : PriorOf(a.facts, a.memory).former.objects)
    comparison.former_W[former.id] = comparison.offset.Apply(former.object.p_W);
  return comparison;
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/session/session_memory.hpp"

#include <cmath>

#include "limpet/core/config.hpp"
#include "limpet/core/frames.hpp"
#include "limpet/core/record.hpp"
#include "limpet/session/sights_csv.hpp"

namespace limpet {
namespace {

constexpr const char* kArea = "area.txt";
constexpr const char* kObjects = "objects.json";
constexpr const char* kSights = "sights.csv";
constexpr const char* kMap = "map.ot";
constexpr std::string_view kMission = "mission/";

constexpr double kViewDistance = 0.5;  ///< looks from nearer, or turned less, tell little more [m]
constexpr double kViewTurn = 0.26;     ///< [rad]

double Rounded(double value) { return std::round(value * 1e4) / 1e4; }

std::vector<std::array<double, 7>> ThinViews(const std::vector<Sight>& sights) {
  std::vector<std::array<double, 7>> views;
  const Sight* last = nullptr;
  for (const Sight& sight : sights) {
    if (!sight.altitude) continue;
    const Pose pose = sight.pose();
    const bool is_new = last == nullptr ||
                        (pose.p_WB - last->pose().p_WB).norm() >= kViewDistance ||
                        std::abs(WrapAngle(pose.yaw - last->yaw)) >= kViewTurn;
    if (!is_new) continue;
    last = &sight;
    views.push_back({Rounded((sight.exposure - sights.front().exposure).value()),
                     Rounded(pose.p_WB.x()), Rounded(pose.p_WB.y()), Rounded(pose.p_WB.z()),
                     Rounded(pose.roll), Rounded(pose.pitch), Rounded(pose.yaw)});
  }
  return views;
}

const std::string* Find(const SessionFiles& files, const char* name) {
  const auto found = files.find(name);
  return found == files.end() ? nullptr : &found->second;
}

}  // namespace

SessionFiles FilesOf(const SessionMemory& memory) {
  SessionFiles files;
  if (memory.area) {
    files[kArea] = EncodeRecord(*memory.area) + "\n";
  }
  files[kObjects] = std::get<std::string>(TopicCodec<OpiBeliefs>::Encode(memory.objects)) + "\n";
  files[kSights] = SightsToCsv(memory.sights);
  if (!memory.map.empty()) {
    files[kMap] = memory.map;
  }
  for (const auto& [name, bytes] : memory.mission) {
    files[std::string(kMission) + name] = bytes;
  }
  return files;
}

Expected<SessionMemory> MemoryOf(const SessionFiles& files) {
  SessionMemory memory;
  if (const std::string* text = Find(files, kArea)) {
    memory.area = DecodeRecord<SurveyArea>(Trim(*text));
    if (!memory.area) return Error{std::string(kArea) + ": not a survey area"};
  }
  const std::string* objects = Find(files, kObjects);
  const std::optional<OpiBeliefs> beliefs =
      objects == nullptr ? std::nullopt : TopicCodec<OpiBeliefs>::Decode(*objects);
  if (!beliefs) {
    return Error{std::string(kObjects) + ": missing, or not a list of objects"};
  }
  memory.objects = *beliefs;
  if (const std::string* text = Find(files, kSights)) {
    Expected<std::vector<Sight>> sights = SightsFromCsv(*text);
    if (!sights) return Error{std::string(kSights) + ": " + sights.error().text};
    memory.sights = *std::move(sights);
  }
  if (const std::string* map = Find(files, kMap)) {
    memory.map = *map;
  }
  for (const auto& [name, bytes] : files) {
    if (name.starts_with(kMission)) memory.mission[name.substr(kMission.size())] = bytes;
  }
  return memory;
}

SessionPrior PriorOf(const SessionFacts& facts, const SessionMemory& memory) {
  constexpr double kLikely = 0.5;
  SessionPrior prior;
  prior.session = facts.session;
  prior.views = ThinViews(memory.sights);
  for (const OpiBelief& opi : memory.objects.opis) {
    if (opi.landmark < 0 || opi.probability < kLikely) continue;
    prior.opis.push_back({.id = opi.id,
                          .ned = opi.ned,
                          .cov = opi.cov,
                          .color = opi.color,
                          .log_likelihood_ratio = opi.log_likelihood_ratio,
                          .looks = opi.looks});
  }
  return prior;
}

}  // namespace limpet

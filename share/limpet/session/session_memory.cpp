// SPDX-License-Identifier: MIT
#include "limpet/session/session_memory.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "limpet/core/config.hpp"
#include "limpet/core/record.hpp"
#include "limpet/session/former_views.hpp"
#include "limpet/session/frames_csv.hpp"
#include "limpet/session/landmark_rows.hpp"

namespace limpet {
namespace {

constexpr const char* kArea = "area.txt";
constexpr const char* kFormer = "former.txt";
constexpr const char* kObjects = "objects.json";
constexpr const char* kObstacles = "obstacles.json";
constexpr const char* kLandmarks = "landmarks.json";
constexpr const char* kKnownLandmarks = "known_landmarks.json";
constexpr const char* kFrames = "frames.csv";
constexpr const char* kFramesOfOld =
    "sights.csv";  // the same, as sessions before 2026-11-27 have it
constexpr const char* kPhases = "phases.csv";
constexpr const char* kWater = "water.json";
constexpr std::string_view kMapTiles = "map/";
constexpr const char* kMapOfOld = "map.ot";  // all of it, as sessions before the tiles have it
constexpr const char* kDepths = "depths.csv";
constexpr std::string_view kMission = "mission/";

const std::string* Find(const SessionFiles& files, const char* name) {
  const auto found = files.find(name);
  return found == files.end() ? nullptr : &found->second;
}

Expected<std::vector<ObservedFrame>> FramesIn(const SessionFiles& files) {
  const char* name = Find(files, kFrames) != nullptr ? kFrames : kFramesOfOld;
  const std::string* text = Find(files, name);
  if (text == nullptr) return std::vector<ObservedFrame>();
  Expected<std::vector<ObservedFrame>> frames = FramesFromCsv(*text);
  if (!frames) return Error{std::string(name) + ": " + frames.error().text};
  return frames;
}

}  // namespace

FormerFacts FormerFactsOf(const SessionFacts& facts) {
  return {.mission = facts.mission,
          .session = facts.session,
          .seed = std::to_string(facts.seed),
          .saved_at = facts.saved_at};
}

SessionFiles FilesOf(const SessionMemory& memory) {
  SessionFiles files = memory.map;
  if (memory.area) {
    files[kArea] = EncodeRecord(*memory.area) + "\n";
  }
  if (memory.former) {
    files[kFormer] = EncodeRecord(*memory.former) + "\n";
  }
  files[kObjects] = std::get<std::string>(TopicCodec<OpiBeliefs>::Encode(memory.objects)) + "\n";
  if (!memory.obstacles.obstacles.empty()) {
    files[kObstacles] =
        std::get<std::string>(TopicCodec<Obstacles>::Encode(memory.obstacles)) + "\n";
  }
  if (!memory.landmarks.ids.empty()) {
    files[kLandmarks] =
        std::get<std::string>(TopicCodec<LandmarkCovariance>::Encode(memory.landmarks)) + "\n";
  }
  if (memory.known_landmarks) {
    files[kKnownLandmarks] =
        std::get<std::string>(TopicCodec<Landmarks>::Encode(*memory.known_landmarks)) + "\n";
  }
  files[kFrames] = FramesToCsv(memory.frames);
  files[kPhases] = PhasesToCsv(memory.phases);
  if (memory.water) {
    files[kWater] = std::get<std::string>(TopicCodec<WaterRecord>::Encode(*memory.water)) + "\n";
  }
  AddChips(memory.chips, files);
  if (!memory.depths.empty()) {
    files[kDepths] = memory.depths;
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
  if (const std::string* text = Find(files, kFormer)) {
    memory.former = DecodeRecord<FormerFacts>(Trim(*text));
    if (!memory.former) return Error{std::string(kFormer) + ": names no session"};
  }
  const std::string* objects = Find(files, kObjects);
  const std::optional<OpiBeliefs> beliefs =
      objects == nullptr ? std::nullopt : TopicCodec<OpiBeliefs>::Decode(*objects);
  if (!beliefs) {
    return Error{std::string(kObjects) + ": missing, or not a list of objects"};
  }
  memory.objects = *beliefs;
  if (const std::string* text = Find(files, kObstacles)) {
    const std::optional<Obstacles> obstacles = TopicCodec<Obstacles>::Decode(*text);
    if (!obstacles) return Error{std::string(kObstacles) + ": not a list of obstacles"};
    memory.obstacles = *obstacles;
  }
  if (const std::string* text = Find(files, kLandmarks)) {
    const std::optional<LandmarkCovariance> joint = TopicCodec<LandmarkCovariance>::Decode(*text);
    if (!joint || joint->cov_W.rows() != static_cast<Eigen::Index>(3 * joint->ids.size())) {
      return Error{std::string(kLandmarks) + ": not a joint covariance of landmarks"};
    }
    memory.landmarks = *joint;
  }
  if (const std::string* text = Find(files, kKnownLandmarks)) {
    memory.known_landmarks = TopicCodec<Landmarks>::Decode(*text);
    if (!memory.known_landmarks) return Error{std::string(kKnownLandmarks) + ": no landmarks"};
  }
  if (const std::string* text = Find(files, kPhases)) {
    Expected<std::vector<PhaseStart>> phases = PhasesFromCsv(*text);
    if (!phases) return Error{std::string(kPhases) + ": " + phases.error().text};
    memory.phases = *std::move(phases);
  }
  Expected<std::vector<ObservedFrame>> frames = FramesIn(files);
  if (!frames) return frames.error();
  memory.frames = *std::move(frames);
  if (const std::string* text = Find(files, kWater)) {
    memory.water = TopicCodec<WaterRecord>::Decode(*text);
    if (!memory.water) return Error{std::string(kWater) + ": not a record of the water"};
  }
  Expected<std::vector<SavedChip>> chips = ChipsFrom(files);
  if (!chips) return chips.error();
  memory.chips = *std::move(chips);
  if (const std::string* depths = Find(files, kDepths)) {
    memory.depths = *depths;
  }
  for (const auto& [name, bytes] : files) {
    if (name.starts_with(kMapTiles) || name == kMapOfOld) memory.map[name] = bytes;
    if (name.starts_with(kMission)) memory.mission[name.substr(kMission.size())] = bytes;
  }
  return memory;
}

std::vector<std::string> PhaseOfFrames(const SessionMemory& memory) {
  std::vector<std::string> phase_of(memory.frames.size());
  for (const PhaseStart& start : memory.phases) {
    if (start.frame >= phase_of.size()) break;
    std::fill(phase_of.begin() + static_cast<std::ptrdiff_t>(start.frame), phase_of.end(),
              start.phase);
  }
  return phase_of;
}

SessionPrior PriorOf(const SessionFacts& facts, const SessionMemory& memory) {
  constexpr double kLikely = 0.5;
  SessionPrior prior;
  prior.session = facts.session;
  std::vector<int> landmarks;
  for (const OpiBelief& opi : memory.objects.opis) {
    if (!opi.landmark || opi.posterior.present() < kLikely) continue;
    landmarks.push_back(*opi.landmark);
    prior.former.objects.push_back({.id = opi.id,
                                    .object = opi.object,
                                    .log_likelihood_ratio = opi.log_likelihood_ratio,
                                    .looks = opi.looks});
  }
  if (memory.water) prior.water = memory.water->estimate;
  prior.obstacles = memory.obstacles.obstacles;
  prior.former.joint_cov_W = CovarianceOf(landmarks, memory.landmarks).value_or(Eigen::MatrixXd());
  AddFormerViews(memory, landmarks, prior);
  return prior;
}

}  // namespace limpet

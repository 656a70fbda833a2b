// SPDX-License-Identifier: MIT
#include "limpet/session/session_record.hpp"

#include "limpet/core/config.hpp"
#include "limpet/core/record.hpp"
#include "limpet/session/sights_csv.hpp"

namespace limpet {
namespace {

constexpr const char* kArea = "area.txt";
constexpr const char* kObjects = "objects.json";
constexpr const char* kSights = "sights.csv";
constexpr const char* kMap = "map.ot";
constexpr std::string_view kMission = "mission/";

const std::string* Find(const SessionFiles& files, const char* name) {
  const auto found = files.find(name);
  return found == files.end() ? nullptr : &found->second;
}

}  // namespace

SessionFiles FilesOf(const SessionRecord& record) {
  SessionFiles files;
  if (record.area) {
    files[kArea] = EncodeRecord(*record.area) + "\n";
  }
  files[kObjects] = std::get<std::string>(TopicCodec<OpiBeliefs>::Encode(record.objects)) + "\n";
  files[kSights] = SightsToCsv(record.sights);
  if (!record.map.empty()) {
    files[kMap] = record.map;
  }
  for (const auto& [name, bytes] : record.mission) {
    files[std::string(kMission) + name] = bytes;
  }
  return files;
}

Expected<SessionRecord> RecordOf(const SessionFiles& files) {
  SessionRecord record;
  if (const std::string* text = Find(files, kArea)) {
    record.area = DecodeRecord<SurveyArea>(Trim(*text));
    if (!record.area) return Error{std::string(kArea) + ": not a survey area"};
  }
  const std::string* objects = Find(files, kObjects);
  const std::optional<OpiBeliefs> beliefs =
      objects == nullptr ? std::nullopt : TopicCodec<OpiBeliefs>::Decode(*objects);
  if (!beliefs) {
    return Error{std::string(kObjects) + ": missing, or not a list of objects"};
  }
  record.objects = *beliefs;
  if (const std::string* text = Find(files, kSights)) {
    Expected<std::vector<Sight>> sights = SightsFromCsv(*text);
    if (!sights) return Error{std::string(kSights) + ": " + sights.error().text};
    record.sights = *std::move(sights);
  }
  if (const std::string* map = Find(files, kMap)) {
    record.map = *map;
  }
  for (const auto& [name, bytes] : files) {
    if (name.starts_with(kMission)) record.mission[name.substr(kMission.size())] = bytes;
  }
  return record;
}

SessionPrior PriorOf(const SessionFacts& facts, const OpiBeliefs& objects) {
  constexpr double kLikely = 0.5;
  SessionPrior prior{.session = facts.session, .opis = {}};
  for (const OpiBelief& opi : objects.opis) {
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

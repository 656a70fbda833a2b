// SPDX-License-Identifier: MIT
#include "apps/pSession/session_app.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "apps/pSession/session_warnings.hpp"
#include "estimation/mapping/map_export.hpp"
#include "limpet/app/registry.hpp"
#include "limpet/durable/durable_file.hpp"
#include "limpet/mission/expanded_text.hpp"
#include "limpet/mission/vehicle_settings.hpp"
#include "limpet/session/cut_session.hpp"
#include "limpet/session/datum.hpp"
#include "limpet/session/saved_session.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPeriodic = "periodic";
constexpr const char* kSessionFolder = "session";

/// The map for other programs; not worth its time on every periodic save.
void AddExports(const std::string& map, SessionFiles& files) {
  const Expected<OccupiedMap> occupied = OccupiedOfStream(map);
  if (!occupied) return;  // no map yet
  files["export/map_color.ot"] = ToColorOctree(*occupied);
  files["export/map.ply"] = ToPly(*occupied);
  files["export/map.csv"] = ToCsv(*occupied);
}

/// A behavior file as the helm reads it; as it is if its plugs are wrong, which the helm says.
std::string WithPlugs(const std::string& text, const std::filesystem::path& file) {
  try {
    return ExpandedText(text, file);
  } catch (const ConfigError&) {
    return text;
  }
}

}  // namespace

SessionApp::SessionApp(const AppContext& context, const Params& params)
    : App(context), params_(params), jobs_(context.runs_live) {
  if (!context.prior_folder.empty()) {
    LoadFormer();
  }
  Subscribe(topics::kSurveyArea, &SessionApp::OnArea);
  Subscribe(topics::kSurveyPhase, &SessionApp::OnPhase);
  Subscribe(topics::kNavLandmarks, &SessionApp::OnLandmarks);
  Subscribe(topics::kMapOpis, &SessionApp::OnObjects);
  Subscribe(topics::kNavLandmarkJoint, &SessionApp::OnLandmarkJoint);
  Subscribe(topics::kNavCameraFrame, &SessionApp::OnFrame);
  SubscribeIfWritten(topics::kDetectionChips, &SessionApp::OnChips);
  SubscribeIfWritten(topics::kMapObstacles, &SessionApp::OnObstacles);
  Subscribe(topics::kNavTrackShift, &SessionApp::OnTrackShift);
  Subscribe(topics::kWaterRecord, &SessionApp::OnWater);
  Subscribe(topics::kMapDepths, &SessionApp::OnDepths);
  SubscribeRaw(topics::kMapSnapshot.name, [this](const MessagePtr& map) { OnSnapshot(map); });
  Subscribe(topics::kSessionSave, &SessionApp::OnSave);
  if (!context.ends_cut_life) CopyMission();
  if (!context.run_folder.empty()) {
    writer_.emplace(context.run_folder / kSessionFolder, *context.disk);
    GoOnFromSaved();
  }
}

void SessionApp::GoOnFromSaved() {
  const fs::path folder = context().run_folder / kSessionFolder;
  if (!fs::exists(folder)) return;
  is_folder_ours_ = false;
  if (context().link->is_replaying()) {
    FindOwnGeneration();
    return;
  }
  if (!context().is_restarted) {
    Warn(warnings::kFormerSession, folder.string() +
                                       " holds a former session: nothing is saved until this one "
                                       "is deployed and has seen something");
    return;
  }
  const Expected<StoredSession> stored = LoadSession(folder);
  const Expected<SessionMemory> saved = stored ? MemoryOf(stored->files) : stored.error();
  if (!saved) {
    Warn(warnings::kSessionNotResumed, saved.error().text);
    return;
  }
  const std::optional<FormerFacts> former = memory_.former;
  memory_ = *saved;
  memory_.former = former;
  map_size_ = memory_.map.size();
  is_folder_ours_ = true;
  ReportEvent(events::kSessionResumed,
              fmt::format("goes on from saved generation {}", stored->generation));
}

// The former life may have ended before it set aside what it had found in the folder.
void SessionApp::FindOwnGeneration() {
  const Expected<StoredSession> stored = LoadSession(context().run_folder / kSessionFolder);
  is_folder_ours_ = stored && stored->facts.saved_at >= context().link->Now().value();
  if (!is_folder_ours_ || !context().ends_cut_life) return;
  Expected<SessionMemory> saved = MemoryOf(stored->files);
  is_folder_ours_ = saved.has_value();  // what cannot be read is set aside, not saved over
  if (!saved) return;
  cut_facts_ = stored->facts;
  memory_.mission = std::move(saved->mission);
  memory_.former = std::move(saved->former);
}

bool SessionApp::MaySave() {
  if (is_folder_ours_) {
    return true;
  }
  if (!memory_.area || memory_.frames.empty()) {
    return false;
  }
  const Expected<fs::path> aside =
      SetSessionAside(context().run_folder / kSessionFolder, *context().disk);
  if (!aside) {
    Warn(warnings::kSessionNotSaved, aside.error().text);
    return false;
  }
  Warn(warnings::kFormerSessionAside,
       "a former session was in the run folder; it is now " + aside->string());
  ClearWarning(warnings::kFormerSession);
  is_folder_ours_ = true;
  return true;
}

void SessionApp::LoadFormer() {
  const SavedSession former = LoadSavedSession(context().prior_folder, "former session");
  RequireOneDatum(former.facts, FactsNow(), context().prior_folder);
  if (const auto note = CutNote(context().prior_folder)) Warn(warnings::kFormerSessionCut, *note);
  prior_ = PriorWithParameters(former);
  prior_map_ = former.memory.map;
  memory_.former = FormerFactsOf(former.facts);
  former_ = Former{prior_->session, prior_->former.objects.size(), prior_->views.size()};
}

void SessionApp::CopyMission() {
  std::error_code absent;  // a test or a bench has no mission folder
  for (const fs::directory_entry& entry :
       fs::directory_iterator(context().mission_folder, absent)) {
    // What the vehicle was told; scenario.yaml is the truth, which it must not know.
    const std::string extension = entry.path().extension().string();
    if (extension != ".moos" && extension != ".bhv") continue;
    if (Expected<std::string> text = ReadWhole(entry.path())) {
      memory_.mission[entry.path().filename().string()] =
          extension == ".bhv" ? WithPlugs(*text, entry.path()) : *text;
    }
  }
  for (const FactFile* kind : FactFiles()) {
    const fs::path named =
        FindFactFile(*kind, context().Global(kind->global), context().mission_folder);
    for (const fs::path& file : FactFileChain(*kind, named)) {
      if (Expected<std::string> text = ReadWhole(file)) {
        memory_.mission[file.filename().string()] = *std::move(text);
      }
    }
  }
  if (!context().blocks.empty()) {
    memory_.mission[kMissionAsRun] = MissionText(context().globals, context().blocks);
  }
}

void SessionApp::OnPhase(const Stamped<std::string>& phase) {
  memory_.phases.push_back({memory_.frames.size(), phase.value});
}

void SessionApp::OnObjects(const Stamped<OpiBeliefs>& objects) {
  memory_.objects = objects.value;
  memory_.known_landmarks = landmarks_;
}

void SessionApp::OnFrame(const Stamped<ObservedFrame>& frame) {
  memory_.frames.push_back(frame.value);
  chips_.Add(frame.value);
}

void SessionApp::OnTrackShift(const Stamped<TrackShift>& shift) {
  for (ObservedFrame& frame : memory_.frames) {
    frame.X_WB = shift.value.Apply(frame.exposure.value(), frame.X_WB);
  }
}

void SessionApp::OnSave(const Stamped<std::string>& cause) { StartSaving(cause.value, cause.time); }

void SessionApp::StartSaving(const std::string& cause, Seconds now) {
  pending_ = Pending{cause, now};
  Publish(topics::kMapSnapshotRequest, cause);
}

void SessionApp::OnDepths(const Stamped<PackedBytes>& depths) {
  memory_.depths = depths.value.bytes;
}

// A large survey's map is tens of megabytes: it is kept as it was sent, an eighth of that, and
// unpacked once, into the file.
void SessionApp::OnSnapshot(const MessagePtr& map) {
  if (!HasUsableStamp(map->name, map->time, map->source)) return;
  std::optional<PackedBytes> bytes = TopicCodec<PackedBytes>::Decode(map->value);
  if (!bytes) {
    Warn(warnings::kBadMail.Of(map->name), "does not decode; sent by " + map->source);
    return;
  }
  ClearWarning(warnings::kBadMail, map->name);
  ClearWarning(warnings::kMapSilent);
  memory_.map.clear();
  map_ = map;
  map_size_ = bytes->bytes.size();
  if (pending_) {
    Commit(pending_->cause, map->time, std::move(bytes->bytes));
  }
}

std::string SessionApp::LastMap() const {
  if (map_ == nullptr) return memory_.map;
  std::optional<PackedBytes> bytes = TopicCodec<PackedBytes>::Decode(map_->value);
  return bytes ? std::move(bytes->bytes) : std::string();
}

void SessionApp::Tick(Seconds now) {
  if (prior_) {
    Publish(topics::kSessionPrior, *prior_);
    prior_.reset();
    if (!prior_map_.empty()) {
      Publish(topics::kSessionPriorMap, PackedBytes{prior_map_});
      prior_map_.clear();
    }
  }
  if (!DiskIsIdle(now)) {
    return;
  }
  TellSaved();
  if (put_off_) {
    StartSaving(*std::exchange(put_off_, std::nullopt), now);
  } else if (!last_save_) {
    Commit("start", now, LastMap());  // self-describing from its first second
  } else if (pending_ && now - pending_->since > params_.map_within) {
    Warn(warnings::kMapSilent, "no MAP_SNAPSHOT: saved with the last map known");
    Commit(pending_->cause, now, LastMap());
  } else if (!pending_ && now - *last_save_ >= SaveEvery()) {
    StartSaving(kPeriodic, now);
  }
}

// A map is written as a whole: at a fixed pace, what a long survey writes would grow with the
// square of its time, and fill disk and log.
Seconds SessionApp::SaveEvery() const {
  constexpr double kMapBytesPerSecond = 128e3;
  return std::max(params_.save_every, Seconds(static_cast<double>(map_size_) / kMapBytesPerSecond));
}

bool SessionApp::DiskIsIdle(Seconds now) {
  constexpr Seconds kLong(30.0);
  const bool is_idle = jobs_.is_idle();
  if (!is_idle && last_save_ && now - *last_save_ > kLong) {
    Warn(warnings::kSessionNotSaved, "the disk has not taken the last generation yet");
  }
  return is_idle;
}

void SessionApp::Finish(Seconds now) {
  jobs_.Wait();
  TellSaved();
  if (context().ends_cut_life) {
    Commit("recovered", now, LastMap());
  } else if (!last_save_ || pending_ || now > *last_save_) {
    Commit(pending_ ? pending_->cause : "end", now, LastMap());
  }
  jobs_.Wait();
  TellSaved();
}

SessionFacts SessionApp::FactsNow() const {
  if (cut_facts_) return *cut_facts_;
  return {.limpet = "",
          .mission = context().mission_folder.filename().string(),
          .session = context().session,
          .community = context().Global("Community"),
          .seed = context().seed,
          .lat_origin = context().Global("LatOrigin"),
          .long_origin = context().Global("LongOrigin"),
          .saved_at = 0.0,
          .cause = ""};
}

void SessionApp::Commit(std::string cause, Seconds now, std::string map) {
  pending_.reset();
  if (!jobs_.is_idle()) {
    put_off_ = std::move(cause);
    return;
  }
  TellSaved();
  last_save_ = now;
  if (!writer_ || context().link->is_replaying() || !MaySave()) {
    return;
  }
  SessionFacts facts = FactsNow();
  facts.saved_at = now.value();
  facts.cause = cause;
  memory_.chips = ChipsOf(memory_.objects, chips_, memory_.chips);
  SessionFiles files;
  if (cause != kPeriodic) {
    AddExports(map, files);
  }
  files.merge(FilesOf(memory_, std::move(map)));
  jobs_.Put([this, facts = std::move(facts), files = std::move(files)] {
    saved_ = Saved{facts.cause, writer_->Commit(facts, files)};
  });
  if (jobs_.is_idle()) {
    TellSaved();
  }
}

void SessionApp::TellSaved() {
  if (!saved_) {
    return;
  }
  const Saved saved = *std::exchange(saved_, std::nullopt);
  if (!saved.generation) {
    Warn(warnings::kSessionNotSaved, saved.generation.error().text);
    return;
  }
  ClearWarning(warnings::kSessionNotSaved);
  generation_ = *saved.generation;
  last_cause_ = saved.cause;
  ReportEvent(events::kSessionSaved,
              fmt::format("saved generation {}: {}", generation_, saved.cause));
  Publish(topics::kSessionSaved, fmt::format("generation={},cause={}", generation_, saved.cause));
}

LIMPET_REGISTER_APP(SessionApp, "pSession", 2.0);

}  // namespace limpet

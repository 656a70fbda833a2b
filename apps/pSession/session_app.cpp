// SPDX-License-Identifier: MIT
#include "apps/pSession/session_app.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "apps/pSession/session_warnings.hpp"
#include "estimation/mapping/map_export.hpp"
#include "estimation/mapping/saved_map.hpp"
#include "limpet/app/registry.hpp"
#include "limpet/durable/durable_file.hpp"
#include "limpet/mission/expanded_text.hpp"
#include "limpet/mission/vehicle_settings.hpp"
#include "limpet/session/cut_session.hpp"
#include "limpet/session/datum.hpp"
#include "limpet/session/former_map_warning.hpp"
#include "limpet/session/saved_session.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPeriodic = "periodic";
constexpr const char* kSessionFolder = "session";

/// Packed; a larger map would take hundreds of megabytes on its way to be text.
constexpr std::size_t kLargestExported = std::size_t{4} << 20U;
/// Tiles of a former session that are handed over in a tick.
constexpr std::size_t kTilesPerTick = 64;

std::size_t BytesOf(const SessionFiles& files) {
  std::size_t sum = 0;
  for (const auto& [name, bytes] : files) {
    sum += bytes.size();
  }
  return sum;
}

/// Tiles of a former session's map; one that was saved as a whole is cut up.
Expected<std::vector<MapTile>> TilesOfMap(const SessionMap& map) {
  std::vector<MapTile> tiles;
  for (const auto& [file, bytes] : map) {
    if (const std::optional<TileKey> key = TileOfFile(file)) {
      tiles.push_back({.key = *key, .packed = bytes});
      continue;
    }
    Expected<std::vector<MapTile>> parts = TilesOf(bytes);
    if (!parts) return Error{file + ": " + parts.error().text};
    tiles.insert(tiles.end(), parts->begin(), parts->end());
  }
  return tiles;
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
  Subscribe(topics::kMapTile, &SessionApp::OnTile);
  Subscribe(topics::kMapTiles, &SessionApp::OnTiles);
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
  tiles_.GoOnFrom(std::exchange(memory_.map, {}));
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
  Expected<std::vector<MapTile>> tiles = TilesOfMap(former.memory.map);
  if (tiles) {
    prior_tiles_ = *std::move(tiles);
  } else {
    Warn(warnings::kFormerMap,
         "the former session's voxels are not taken over: " + tiles.error().text);
  }
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
  has_asked_for_all_ = false;
  Publish(topics::kMapSnapshotRequest, cause);
}

void SessionApp::OnDepths(const Stamped<PackedBytes>& depths) {
  memory_.depths = depths.value.bytes;
}

void SessionApp::OnTile(const Stamped<MapTile>& tile) {
  tiles_.Put(tile.value);
  if (pending_) pending_->since = tile.time;
}

void SessionApp::OnTiles(const Stamped<MapTileList>& tiles) {
  tiles_.EndRetelling();
  if (tiles.value != tiles_.List()) {
    AskForAllTiles(
        fmt::format("{} of {} tiles, or others", tiles_.List().tiles, tiles.value.tiles));
    return;
  }
  ClearWarning(warnings::kMapSilent);
  if (pending_) Commit(pending_->cause, tiles.time);
}

// Once for each save: a pMap that tells what does not fit its own list would be asked for ever.
void SessionApp::AskForAllTiles(const std::string& why) {
  if (has_asked_for_all_) return;
  has_asked_for_all_ = true;
  tiles_.BeginRetelling();
  Publish(topics::kMapTilesRequest, why);
}

void SessionApp::HandOverFormer() {
  if (prior_) Publish(topics::kSessionPrior, *std::exchange(prior_, std::nullopt));
  for (std::size_t i = 0; i < kTilesPerTick && !prior_tiles_.empty(); ++i) {
    Publish(topics::kSessionPriorMap, prior_tiles_.back());
    prior_tiles_.pop_back();
  }
}

void SessionApp::Tick(Seconds now) {
  HandOverFormer();
  if (!DiskIsIdle(now)) {
    return;
  }
  TellSaved();
  if (put_off_) {
    StartSaving(*std::exchange(put_off_, std::nullopt), now);
  } else if (!last_save_) {
    Commit("start", now);  // self-describing from its first second
  } else if (pending_ && now - pending_->since > params_.map_within) {
    Warn(warnings::kMapSilent, "no MAP_TILES: saved with the last map known");
    Commit(pending_->cause, now);
  } else if (!pending_ && now - *last_save_ >= SaveEvery()) {
    StartSaving(kPeriodic, now);
  }
}

// Frames and depths are written as a whole: at a fixed pace, what a long survey writes would grow
// with the square of its time.
Seconds SessionApp::SaveEvery() const {
  constexpr double kBytesPerSecond = 128e3;
  return std::max(params_.save_every, Seconds(static_cast<double>(written_) / kBytesPerSecond));
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
    Commit("recovered", now);
  } else if (!last_save_ || pending_ || now > *last_save_) {
    Commit(pending_ ? pending_->cause : "end", now);
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

void SessionApp::AddExports(const SessionTiles::Files& tiles, SessionFiles& files) {
  if (tiles_.packed_bytes() > kLargestExported) {
    ReportEvent(events::kExportsLeftOut,
                "the map is large: `limpet map export` makes the files for other programs");
    return;
  }
  SessionMap map = tiles.to_write;
  for (const std::string& file : tiles.unchanged) {
    const Expected<std::string> bytes = writer_->ReadLast(file);
    if (!bytes) return ReportEvent(events::kExportsLeftOut, bytes.error().text);
    map[file] = *bytes;
  }
  const Expected<OccupiedMap> occupied = OccupiedOf(map);
  if (!occupied || map.empty()) return;  // no map yet
  files["export/map_color.ot"] = ToColorOctree(*occupied);
  files["export/map.ply"] = ToPly(*occupied);
  files["export/map.csv"] = ToCsv(*occupied);
}

void SessionApp::Commit(std::string cause, Seconds now) {
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
  SessionTiles::Files tiles = tiles_.FilesNow();
  if (cause != kPeriodic) {
    AddExports(tiles, files);
  }
  files.merge(FilesOf(memory_));
  files.merge(tiles.to_write);
  written_ = BytesOf(files);
  jobs_.Put([this, facts = std::move(facts), files = std::move(files), tiles = std::move(tiles)] {
    saved_ = Saved{facts.cause, tiles.versions, writer_->Commit(facts, files, tiles.unchanged)};
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
    // What was on the disk alone may not be there any more.
    if (tiles_.has_saved()) AskForAllTiles("the session could not be saved");
    return;
  }
  ClearWarning(warnings::kSessionNotSaved);
  tiles_.OnSaved(saved.tiles);
  generation_ = *saved.generation;
  last_cause_ = saved.cause;
  ReportEvent(events::kSessionSaved,
              fmt::format("saved generation {}: {}", generation_, saved.cause));
  Publish(topics::kSessionSaved, fmt::format("generation={},cause={}", generation_, saved.cause));
}

LIMPET_REGISTER_APP(SessionApp, "pSession", 2.0);

}  // namespace limpet

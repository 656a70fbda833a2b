// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "apps/pSession/session_tiles.hpp"
#include "limpet/app/app.hpp"
#include "limpet/core/params.hpp"
#include "limpet/durable/disk_jobs.hpp"
#include "limpet/objects/best_chips.hpp"
#include "limpet/session/session_memory.hpp"
#include "limpet/topics/chips.hpp"

namespace limpet {

/// Saves what the session knows, a generation at a time, and hands over what a former one knew.
/// A former session that is missing or damaged is a ConfigError: nothing flies on half a memory.
class SessionApp final : public App {
 public:
  static constexpr bool kReplaysMail = true;  ///< what it knows is what it heard
  struct Params {
    Seconds save_every{60.0};
    Seconds map_within{2.0};
    template <class V>
    void Describe(V& visit) {
      using namespace literals;
      visit("save_every_s", save_every,
            "Time between two saved generations; more where much is to be written: 1 s per 128 kB",
            InRange(1.0_s, 3600.0_s));
      visit("map_within_s", map_within,
            "Wait this long for the map, or its next tile, then save without a new one",
            InRange(0.1_s, 60.0_s));
    }
  };

  SessionApp(const AppContext& context, const Params& params);
  void Tick(Seconds now) override;
  void Report(ReportLines& report) const override;
  void Finish(Seconds now) override;

 private:
  void OnArea(const Stamped<SurveyArea>& area) { memory_.area = area.value; }
  void OnPhase(const Stamped<std::string>& phase);
  void OnLandmarks(const Stamped<Landmarks>& landmarks) { landmarks_ = landmarks.value; }
  void OnObjects(const Stamped<OpiBeliefs>& objects);
  void OnLandmarkJoint(const Stamped<LandmarkCovariance>& joint) {
    memory_.landmarks = joint.value;
  }
  void OnFrame(const Stamped<ObservedFrame>& frame);
  void OnChips(const Stamped<ImageChips>& chips) { chips_.Add(chips.value); }
  void OnObstacles(const Stamped<Obstacles>& obstacles) { memory_.obstacles = obstacles.value; }
  void OnTrackShift(const Stamped<TrackShift>& shift);
  void OnWater(const Stamped<WaterRecord>& water) { memory_.water = water.value; }
  void OnDepths(const Stamped<PackedBytes>& depths);
  void OnTile(const Stamped<MapTile>& tile);
  void OnTiles(const Stamped<MapTileList>& tiles);
  void OnSave(const Stamped<std::string>& cause);
  void LoadFormer();
  void CopyMission();
  /// Started again without the mail of its former life: goes on from what that saved.
  void GoOnFromSaved();
  /// Before it goes through its former life: whether that is what the folder holds.
  void FindOwnGeneration();
  [[nodiscard]] SessionFacts FactsNow() const;
  /// False while a former session is in its folder that this one is not worth: nothing flown yet.
  /// Once it is, the former one is set aside.
  [[nodiscard]] bool MaySave();
  void StartSaving(const std::string& cause, Seconds now);
  /// By value: the pending cause dies with the saving that this ends. Put off while the disk is
  /// still at the one before.
  void Commit(std::string cause, Seconds now);
  /// The map for other programs; not worth its time on every periodic save.
  void AddExports(const SessionTiles::Files& tiles, SessionFiles& files);
  void TellSaved();
  void AskForAllTiles(const std::string& why);
  void HandOverFormer();
  [[nodiscard]] Seconds SaveEvery() const;
  /// False while the disk is at work; warns if that takes long.
  [[nodiscard]] bool DiskIsIdle(Seconds now);

  struct Pending {
    std::string cause;
    Seconds since;  ///< it was asked for, or a part of the map has come
  };
  Params params_;
  SessionMemory memory_;
  Landmarks landmarks_;  ///< as last heard; those that the objects were judged with are in memory_
  BestChips chips_;      ///< of all landmarks; those of the objects go into memory_
  std::optional<SessionWriter> writer_;
  std::optional<SessionPrior> prior_;
  SessionTiles tiles_;
  bool has_asked_for_all_ = false;    ///< of the tiles, since the map was last asked for
  std::size_t written_ = 0;           ///< with the last generation [bytes]
  std::vector<MapTile> prior_tiles_;  ///< of the former session's octree; not handed over yet
  std::optional<Pending> pending_;    ///< waits for the map
  std::optional<Seconds> last_save_;
  struct Former {
    std::string session;
    std::size_t objects = 0, views = 0;
  };
  std::optional<Former> former_;  ///< for the report
  bool is_folder_ours_ = true;    ///< nothing of another life is in it
  /// Facts of the cut life that this one brings to its end, as that life saved them last.
  std::optional<SessionFacts> cut_facts_;
  int generation_ = 0;  ///< last one on disk
  std::string last_cause_;
  struct Saved {
    std::string cause;
    std::map<TileKey, std::uint64_t> tiles;
    Expected<int> generation;
  };
  std::optional<Saved> saved_;          ///< not told yet; the job's while it runs
  std::optional<std::string> put_off_;  ///< cause
  DiskJobs jobs_;
};

}  // namespace limpet

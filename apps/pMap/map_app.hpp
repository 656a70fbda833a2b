// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/pMap/map_drawing.hpp"
#include "estimation/change/sight_gate.hpp"
#include "estimation/change/status_book.hpp"
#include "estimation/mapping/object_layer.hpp"
#include "estimation/mapping/semantic_octree.hpp"
#include "limpet/app/app.hpp"
#include "limpet/core/camera_params.hpp"
#include "limpet/survey/survey_grid.hpp"
#include "limpet/topics/mapping.hpp"
#include "limpet/topics/mission.hpp"
#include "limpet/topics/navigation.hpp"

namespace limpet {

/// What the vehicle believes about the ground and the objects on it: coverage, the status of every
/// object, and the semantic octree.
class MapApp final : public App {
 public:
  static constexpr bool kReplaysMail = true;  ///< what it knows is what it heard
  struct Params {
    CameraParams camera;
    StatusParams status;
    Meters cell{0.25};
    Meters voxel{0.2};
    double object_threshold = 0.7;
    Meters highest_view{6.5};
    Seconds publish_every{0.5};
    Seconds altitude_lasts{5.0};
    template <class V>
    void Describe(V& visit) {
      using namespace literals;
      camera.Describe(visit);
      status.Describe(visit);
      visit("cell_m", cell, "Cell of the survey grid", InRange(0.05_m, 5.0_m));
      visit("voxel_m", voxel, "Voxel of the semantic octree", InRange(0.05_m, 2.0_m));
      visit("object_threshold", object_threshold, "P_a from which a voxel belongs to an object",
            InRange(0.51, 0.95));
      visit("highest_view_m", highest_view, "Frames from higher above the seabed show nothing",
            InRange(0.5_m, 100.0_m));
      visit("publish_every_s", publish_every, "Shortest time between two reports of the map",
            InRange(0.1_s, 60.0_s));
      visit("altitude_lasts_s", altitude_lasts, "How long an altitude stands in for a lost one",
            InRange(0.1_s, 60.0_s));
    }
    [[nodiscard]] SightGate::Params sight_gate() const {
      return {.highest_view = highest_view, .altitude_lasts = altitude_lasts};
    }
  };

  MapApp(const AppContext& context, const Params& params);
  void Tick(Seconds now) override;
  void Report(ReportLines& report) const override;

 private:
  void OnArea(const Stamped<SurveyArea>& area);
  void OnPhase(const Stamped<std::string>& phase);
  void OnSight(const Stamped<Sight>& sight);
  void OnBeams(const Stamped<PosedBeams>& beams);
  void OnTrackShift(const Stamped<TrackShift>& shift);
  void OnLandmarks(const Stamped<Landmarks>& landmarks);
  void OnPrior(const Stamped<SessionPrior>& prior);
  void OnGridRequest(const Stamped<std::string>& cause);
  /// Tells the operator of frames that are left out where frames should count.
  void WarnOfDrop(const std::optional<SightDrop>& drop);
  void WarnOfHunches();
  [[nodiscard]] double TallestObject() const;
  /// Beams of one ping that had a range, and those of them that the map took.
  void CountBeams(int given, int used);
  void OnSnapshotRequest(const Stamped<std::string>& request);
  /// By what looks are counted, for who plans them.
  void TellHowItLooks();
  void UpdateObjects();
  void PublishObjects();

  Params params_;
  CameraGeometry camera_;
  SightGate gate_;
  StatusBook book_;
  SemanticOctree octree_;
  ObjectLayer layer_;
  std::vector<ObjectStatus> objects_;
  std::optional<SurveyArea> area_;
  std::optional<SurveyGrid> grid_;
  std::string phase_;
  std::optional<Seconds> last_publish_;
  bool landmarks_changed_ = false;  ///< since places were last judged exactly where they are
  std::optional<Value> last_objects_;
  bool has_told_looks_ = false;
  int beams_ = 0, beams_left_out_ = 0, beams_in_window_ = 0, left_out_in_window_ = 0;
  MapDrawing drawing_;
};

}  // namespace limpet

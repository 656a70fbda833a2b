// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/pMap/map_drawing.hpp"
#include "apps/pMap/map_teller.hpp"
#include "apps/pMap/obstacle_notices.hpp"
#include "estimation/change/frame_gate.hpp"
#include "estimation/change/object_statuses.hpp"
#include "estimation/mapping/anchored_grid.hpp"
#include "estimation/mapping/ground_looks.hpp"
#include "estimation/mapping/map_params.hpp"
#include "estimation/mapping/object_layer.hpp"
#include "estimation/mapping/obstacle_finder.hpp"
#include "estimation/mapping/semantic_map.hpp"
#include "limpet/app/app.hpp"
#include "limpet/topics/mapping.hpp"
#include "limpet/topics/mission.hpp"
#include "limpet/topics/navigation.hpp"
#include "limpet/topics/sensors.hpp"

namespace limpet {

/// What the vehicle believes about the ground and the objects on it: coverage, the status of every
/// object, and the semantic map.
class MapApp final : public App {
 public:
  static constexpr bool kReplaysMail = true;  ///< what it knows is what it heard
  using Params = MapParams;

  MapApp(const AppContext& context, const Params& params);
  void Tick(Seconds now) override;
  void Report(ReportLines& report) const override;
  /// Who asked for the map hears all of it.
  void Finish(Seconds now) override;

 private:
  void OnArea(const Stamped<SurveyArea>& area);
  void OnPhase(const Stamped<std::string>& phase);
  void OnSurfaceFix(const Stamped<bool>& is_up);
  void OnFrame(const Stamped<ObservedFrame>& frame);
  void OnContrast(const Stamped<GroundContrast>& image);
  void OnBeams(const Stamped<PosedBeams>& beams);
  void OnSonar(const Stamped<PosedSonar>& sonar);
  /// Tells of obstacles if others are known than before.
  void TellObstacles();
  /// Has the echoes that obstacles are made of stand in the map.
  void PaintObstacles();
  void OnTrackShift(const Stamped<TrackShift>& shift);
  void OnLandmarks(const Stamped<Landmarks>& landmarks);
  void OnPrior(const Stamped<SessionPrior>& prior);
  void OnPriorTile(const Stamped<MapTile>& tile);
  void OnGridRequest(const Stamped<std::string>& cause);
  /// Tells the operator of frames that are left out where frames should count.
  void WarnOfDrop(const std::optional<FrameDrop>& drop);
  void WarnOfTentativeObjects();
  void WarnOfDoubtedLandmarks();
  void WarnOfAllGone();
  [[nodiscard]] double TallestObject() const;
  /// Beams of one ping that had a range, and those of them that the map took.
  void CountBeams(int given, int used);
  void OnSnapshotRequest(const Stamped<std::string>& request);
  void OnTilesRequest(const Stamped<std::string>& request);
  /// Goes on telling the map, as far as `most` tiles go; which those were, once it has been told.
  void TellMap(int most);
  /// Publishes what looks are planned by: the camera, and the water as it was last told.
  void TellHowItLooks();
  [[nodiscard]] DetectionModel PlannedDetection() const;
  [[nodiscard]] LookModel PlannedLook() const;
  /// Takes another water for what has been seen and for plans if the estimate has left it.
  void FollowWater(const VisibilityBelief& water);
  /// Has views planned with images drawn in as those of late.
  void FollowSeams(double allowance);
  /// The water as now estimated, now and then, and whether the seabed is in sight.
  void TellWater(Seconds now);
  void WarnOfMurk(const VisibilityBelief& water);
  /// Chance that a frame shows an object on the seabed below, or `farther` times as far off;
  /// nothing if the altitude is not known.
  [[nodiscard]] std::optional<double> ChanceAtSeabed(const VisibilityBelief& water,
                                                     double farther = 1.0) const;
  void UpdateObjects();
  void PublishObjects();

  Params params_;
  CameraModel camera_;
  FrameGate gate_;
  ObjectStatuses statuses_;
  SemanticMap map_;
  ObjectLayer layer_;
  GroundLooks ground_looks_;
  MapTeller map_teller_;
  ObstacleFinder obstacle_finder_;
  ObstacleNotices obstacle_notices_;
  std::vector<VoxelKey> obstacle_voxels_;  ///< as painted
  std::vector<OpiBelief> objects_;
  std::optional<SurveyArea> area_;
  std::optional<AnchoredGrid> ground_;
  std::string phase_;
  bool is_up_for_fix_ = false;
  std::optional<Seconds> back_from_fix_by_;  ///< until a frame has come from low enough
  std::optional<Seconds> last_publish_;
  std::optional<Seconds> last_water_;
  bool landmarks_changed_ = false;  ///< since places were last judged exactly where they are
  std::optional<Value> last_objects_;
  bool has_told_looks_ = false;
  bool is_murky_ = false;       ///< as last warned of
  Meters planned_visibility_;   ///< by which coverage is counted and views are planned
  double planned_seams_ = 0.0;  ///< by what images are drawn in where views are planned [m]
  int beams_ = 0, beams_left_out_ = 0, beams_in_window_ = 0, left_out_in_window_ = 0;
  MapDrawing drawing_;
};

}  // namespace limpet

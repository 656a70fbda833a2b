// SPDX-License-Identifier: MIT
#include "apps/pMap/map_app.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "apps/pMap/map_warnings.hpp"
#include "estimation/mapping/dvl_beams.hpp"
#include "estimation/mapping/former_map.hpp"
#include "limpet/app/registry.hpp"
#include "limpet/session/former_map_warning.hpp"
#include "limpet/survey/grid_frame.hpp"
#include "limpet/survey/look.hpp"
#include "limpet/survey/survey_area_warnings.hpp"
#include "limpet/topics/surface_fix.hpp"
#include "limpet/topics/survey_phase.hpp"

namespace limpet {
MapApp::MapApp(const AppContext& context, const Params& params)
    : App(context),
      params_(params),
      camera_(params.camera.geometry()),
      gate_(params.frame_gate()),
      statuses_(params.status, camera_),
      map_(params.voxel, params.beams),
      layer_({.threshold = params.object_threshold}, params.status, camera_),
      ground_looks_(params.status.LookFrom(camera_), params.status.looks),
      map_teller_(map_, ground_looks_),
      obstacle_finder_(params.beams),
      planned_visibility_(params.status.detection.visibility),
      drawing_(context.Global("Community"), [this](std::string variable, std::string text) {
        PublishRaw(std::move(variable), std::move(text));
      }) {
  Subscribe(topics::kSurveyArea, &MapApp::OnArea);
  Subscribe(topics::kSurveyPhase, &MapApp::OnPhase);
  SubscribeIfWritten(topics::kSurfaceFix, &MapApp::OnSurfaceFix);
  Subscribe(topics::kNavCameraFrame, &MapApp::OnFrame);
  Subscribe(topics::kGroundContrast, &MapApp::OnContrast);
  Subscribe(topics::kNavBeams, &MapApp::OnBeams);
  SubscribeIfWritten(topics::kNavSonar, &MapApp::OnSonar);
  Subscribe(topics::kNavTrackShift, &MapApp::OnTrackShift);
  Subscribe(topics::kNavLandmarks, &MapApp::OnLandmarks);
  Subscribe(topics::kSessionPrior, &MapApp::OnPrior);
  Subscribe(topics::kSessionPriorMap, &MapApp::OnPriorTile);
  Subscribe(topics::kMapSnapshotRequest, &MapApp::OnSnapshotRequest);
  Subscribe(topics::kMapTilesRequest, &MapApp::OnTilesRequest);
  Subscribe(topics::kMapGridRequest, &MapApp::OnGridRequest);
}

void MapApp::OnArea(const Stamped<SurveyArea>& area) {
  if (const auto problem = ProblemOf(area.value, params_.cell.value())) {
    Warn(warnings::kAreaRefused, "SURVEY_AREA " + *problem);
    return;
  }
  ClearWarning(warnings::kAreaRefused);
  if (area_ != area.value) {
    area_ = area.value;
    ground_.emplace(area.value, params_.cell, camera_, map_.beams(), params_.seam_loss);
    ground_->SetReach(HalfRange(PlannedDetection()));
    ground_->SetObstacles(obstacle_finder_.obstacles());
  }
}

void MapApp::OnGridRequest(const Stamped<std::string>& /*cause*/) {
  has_told_looks_ = false;  // who asks has been restarted
  if (ground_) {
    Publish(topics::kMapDelta, ground_->grid().Everything());
  }
}

void MapApp::OnPhase(const Stamped<std::string>& phase) { phase_ = phase.value; }

void MapApp::OnSurfaceFix(const Stamped<bool>& is_up) {
  constexpr Seconds kLongestDive(120.0);
  if (is_up_for_fix_ && !is_up.value) back_from_fix_by_ = now() + kLongestDive;
  is_up_for_fix_ = is_up.value;
}

void MapApp::WarnOfDrop(const std::optional<FrameDrop>& drop) {
  if (drop == FrameDrop::kOutOfOrder) {
    Warn(warnings::kFrameOutOfOrder, "a frame came late and was left out");
    return;
  }
  ClearWarning(warnings::kFrameOutOfOrder);
  // On the way down frames from above are no trouble.
  const bool is_surveying = IsSurveying(phase_);
  // Nor are they on a way up for a fix, nor on the way down from it.
  if (!drop && !is_up_for_fix_) back_from_fix_by_.reset();
  const bool is_high_meant = is_up_for_fix_ || now() < back_from_fix_by_.value_or(now());
  if (is_surveying && !is_high_meant && drop == FrameDrop::kTooHigh) {
    Warn(warnings::kViewTooHigh,
         fmt::format("frames from higher than highest_view_m = {:g} above the seabed show nothing",
                     params_.highest_view.value()));
  } else {
    ClearWarning(warnings::kViewTooHigh);
  }
  if (is_surveying && drop == FrameDrop::kNoAltitude) {
    Warn(warnings::kViewWithoutAltitude,
         fmt::format("frames are left out: no altitude within altitude_lasts_s = {:g}",
                     params_.altitude_lasts.value()));
  } else {
    ClearWarning(warnings::kViewWithoutAltitude);
  }
}

void MapApp::OnFrame(const Stamped<ObservedFrame>& frame) {
  const FrameGate::Verdict verdict =
      gate_.Judge(frame.value.exposure, frame.value.altitude, phase_);
  WarnOfDrop(verdict.drop);
  if (verdict.drop) {
    return;
  }
  statuses_.AddFrame(frame.value);
  layer_.AddFrame(statuses_.frames().back(), statuses_);
  if (ground_) {
    ground_->Observe({.t = frame.value.exposure.value(),
                      .X_WB = frame.value.X_WB,
                      .altitude = *verdict.altitude,
                      .sigma = frame.value.sigma.value_or(PlaceSigma{})});
    FollowSeams(ground_->recent_allowance());
  }
}

void MapApp::OnContrast(const Stamped<GroundContrast>& image) {
  const Seconds age = Seconds(image.value.exposure) - gate_.altitude_time();
  const bool has_altitude = gate_.altitude() && age <= params_.altitude_lasts;
  if (has_altitude && IsMappingPhase(phase_)) {
    statuses_.contrasts().Add(*gate_.altitude(), image.value);
  }
}

double MapApp::TallestObject() const {
  constexpr double kTallest = 3.0;  // before the area says how high objects may float [m]
  const double radius = params_.status.object_radius.value();
  return std::max(kTallest, area_ ? area_->object_height_max + 2.0 * radius : 0.0);
}

void MapApp::CountBeams(int given, int used) {
  constexpr int kWindow = 200;  // ten seconds of a DVL
  constexpr double kTooMany = 0.25;
  beams_ += given;
  beams_left_out_ += given - used;
  beams_in_window_ += given;
  left_out_in_window_ += given - used;
  if (beams_in_window_ < kWindow) {
    return;
  }
  if (left_out_in_window_ >= kTooMany * beams_in_window_) {
    Warn(warnings::kBeamsLeftOut,
         fmt::format("{} of the last {} DVL beams end where neither seabed nor objects can be",
                     left_out_in_window_, beams_in_window_));
  } else {
    ClearWarning(warnings::kBeamsLeftOut);
  }
  beams_in_window_ = left_out_in_window_ = 0;
}

void MapApp::OnBeams(const Stamped<PosedBeams>& beams) {
  const PosedBeams& ping = beams.value;
  obstacle_finder_.AddBeams(beams.time.value(), ping);
  const std::array<std::optional<double>, 4> ranges{ping.b1, ping.b2, ping.b3, ping.b4};
  const std::vector<BeamEnd> ends = BeamEnds(ping.pose(), ranges, TallestObject(), params_.beams);
  CountBeams(static_cast<int>(std::ranges::count_if(ranges, [](const auto& r) { return !!r; })),
             map_.beams().Add(beams.time.value(), ping, ends));
  if (ground_) {
    ground_->TakePings();
  }
}

void MapApp::OnSonar(const Stamped<PosedSonar>& sonar) {
  obstacle_finder_.AddSonar(sonar.time.value(), sonar.value);
}

void MapApp::PaintObstacles() {
  constexpr float kOccupied = 3.5F;  // log-odds: 0.97, as sure as beams make anything
  for (const VoxelKey& key : obstacle_voxels_) {
    map_.Unpaint(key);
  }
  obstacle_voxels_.clear();
  for (const EchoCells::Cell& cell : obstacle_finder_.cells().Believed()) {
    Eigen::Vector3d at_W = cell.p_W;
    for (at_W.z() = cell.shallowest; at_W.z() <= cell.deepest; at_W.z() += map_.resolution()) {
      obstacle_voxels_.push_back(KeyOf(at_W, map_.resolution()));
      map_.Paint(obstacle_voxels_.back(), {.occupied = kOccupied});
    }
  }
}

void MapApp::TellObstacles() {
  if (!obstacle_finder_.Update()) return;
  PaintObstacles();
  const std::vector<Obstacle>& obstacles = obstacle_finder_.obstacles();
  statuses_.SetObstacles(obstacles);
  if (ground_) ground_->SetObstacles(obstacles);
  Publish(topics::kMapObstacles, Obstacles{obstacles});
  const ObstacleNotices::News news = obstacle_notices_.Of(obstacles);
  for (const std::string& alert : news.alerts) {
    Publish(topics::kObstacleAlert, alert);
  }
  for (const std::string& id : news.resolved) {
    Publish(topics::kObstacleResolved, id);
  }
  for (const std::string& found : news.found) {
    ReportEvent(events::kObstacleFound, found);
  }
}

void MapApp::OnTrackShift(const Stamped<TrackShift>& shift) {
  statuses_.MoveFrames([&shift](double t, const Pose& X_WB) { return shift.value.Apply(t, X_WB); });
  map_.beams().Shift(shift.value);
  obstacle_finder_.Shift(shift.value);
  ground_looks_.BeginAnew();
  if (ground_) {
    ground_->Shift(shift.value);
  }
}

void MapApp::OnLandmarks(const Stamped<Landmarks>& landmarks) {
  statuses_.SetLandmarks(landmarks.value.landmarks);
  landmarks_changed_ = true;
}

void MapApp::OnPrior(const Stamped<SessionPrior>& prior) {
  try {
    statuses_.SetFormerViews(FormerViewsOf(prior.value, params_));
    ClearWarning(warnings::kFormerParameters);
  } catch (const ConfigError& error) {
    statuses_.SetFormerViews({});
    Warn(warnings::kFormerParameters,
         fmt::format("where the former session looked is not used, nothing will be called new: {}",
                     error.what()));
  }
  statuses_.SetFormer(prior.value.former.objects);
}

void MapApp::OnPriorTile(const Stamped<MapTile>& tile) {
  if (const std::optional<Error> error = map_.AddFormer(tile.value)) {
    Warn(warnings::kFormerMap,
         "a tile of the former session's voxels is not taken over: " + error->text);
  }
}

DetectionModel MapApp::PlannedDetection() const {
  DetectionModel detection = params_.status.detection;
  detection.visibility = planned_visibility_;
  return detection;
}

LookModel MapApp::PlannedLook() const {
  LookModel look = params_.status.LookFrom(camera_);
  look.detection = PlannedDetection();
  return look;
}

void MapApp::TellHowItLooks() {
  if (!has_told_looks_) {
    has_told_looks_ = true;
    MapLook look = ToMapLook(PlannedLook());
    if (planned_seams_ > 0.0) look.seam_allowance = planned_seams_;
    Publish(topics::kMapLook, look);
  }
}

void MapApp::FollowSeams(double allowance) {
  constexpr double kStep = 0.1;  // [m]; below it plans would change for nothing
  if (std::abs(allowance - planned_seams_) <= kStep) return;
  planned_seams_ = kStep * std::round(allowance / kStep);
  has_told_looks_ = false;
}

void MapApp::FollowWater(const VisibilityBelief& water) {
  constexpr double kOtherWater = 0.15;  // share; below it plans would change for nothing
  const Meters visibility = MeanVisibility(params_.status.detection, water);
  if (std::abs(visibility / planned_visibility_ - 1.0) <= kOtherWater) {
    return;
  }
  planned_visibility_ = visibility;
  has_told_looks_ = false;
  ground_looks_.SetModel(PlannedLook());
  layer_.SetDetection(PlannedDetection());
  if (ground_) {
    ground_->SetReach(HalfRange(PlannedDetection()));
  }
}

void MapApp::TellWater(Seconds now) {
  constexpr Seconds kEvery(5.0);
  if (last_water_ && now - *last_water_ < kEvery) {
    return;
  }
  last_water_ = now;
  const VisibilityBelief water = statuses_.Water();
  Publish(topics::kWaterState, water.estimate());
  FollowWater(water);
  WarnOfMurk(water);
}

void MapApp::Tick(Seconds now) {
  TellHowItLooks();
  if (map_teller_.is_at_it()) TellMap(MapTeller::kPerTick);
  static_cast<void>(map_.beams().Settle());
  static_cast<void>(ground_looks_.Settle(statuses_.frames(), map_));
  if (ground_) {
    static_cast<void>(ground_->Settle());
  }
  if (last_publish_ && now - *last_publish_ < params_.publish_every) {
    return;
  }
  last_publish_ = now;
  if (ground_) {
    if (const GridDelta delta = ground_->grid().TakeDelta(); !delta.cells.empty()) {
      Publish(topics::kMapDelta, delta);
    }
    ground_->Judge();
    Publish(topics::kMapCoverage, ground_->coverage());
  }
  PublishObjects();
  TellObstacles();
  TellWater(now);
}

void MapApp::UpdateObjects() {
  // At rest every place is judged exactly where it is, so that the last word is what the saved
  // session says when it is judged again.
  if (landmarks_changed_ && !IsMappingPhase(phase_)) {
    statuses_.Rejudge();
    landmarks_changed_ = false;
  }
  objects_ = statuses_.Assess();
  WarnOfTentativeObjects();
  WarnOfDoubtedLandmarks();
  WarnOfAllGone();
  layer_.SetObjects(objects_, statuses_, map_);
}

void MapApp::PublishObjects() {
  UpdateObjects();
  OpiBeliefs beliefs{objects_};
  for (OpiBelief& belief : beliefs.opis) {
    belief.centroid_W = belief.object.p_W;
    if (const std::optional<ObjectCluster> cluster = layer_.Cluster(belief.id)) {
      belief.centroid_W = cluster->centre_W;
      belief.centroid_sd_W = cluster->deviation_W;
    }
  }
  Value encoded = TopicCodec<OpiBeliefs>::Encode(beliefs);
  if (!last_objects_ || *last_objects_ != encoded) {
    PublishRaw(topics::kMapOpis.name, encoded);
    last_objects_ = std::move(encoded);
    drawing_.Draw(beliefs);
  }
}

void MapApp::WarnOfTentativeObjects() {
  if (const int left_out = statuses_.tentative_left_out(); left_out > 0) {
    Warn(warnings::kTentativeObjectsLeftOut,
         fmt::format("{} places where boxes hint at an object are not looked at again: too many; "
                     "does the detector see ghosts?",
                     left_out));
  } else {
    ClearWarning(warnings::kTentativeObjectsLeftOut);
  }
}

LIMPET_REGISTER_APP(MapApp, "pMap", 4.0);

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "apps/pMap/map_app.hpp"

#include <array>

#include "apps/pMap/map_conversions.hpp"
#include "estimation/mapping/dvl_beams.hpp"
#include "limpet/app/registry.hpp"
#include "limpet/survey/look.hpp"

namespace limpet {

MapApp::MapApp(const AppContext& context, const Params& params)
    : App(context),
      params_(params),
      camera_(params.camera.geometry()),
      book_(params.status, camera_),
      octree_(params.voxel),
      layer_({.threshold = params.object_threshold}, params.status, camera_),
      drawing_(context.Global("Community"), [this](std::string variable, std::string text) {
        PublishRaw(std::move(variable), std::move(text));
      }) {
  Subscribe(topics::kSurveyArea, &MapApp::OnArea);
  Subscribe(topics::kSurveyPhase, &MapApp::OnPhase);
  Subscribe(topics::kNavSight, &MapApp::OnSight);
  Subscribe(topics::kNavBeams, &MapApp::OnBeams);
  Subscribe(topics::kNavTrackShift, &MapApp::OnTrackShift);
  Subscribe(topics::kNavLandmarks, &MapApp::OnLandmarks);
  Subscribe(topics::kSessionPrior, &MapApp::OnPrior);
  Subscribe(topics::kMapSnapshotRequest, &MapApp::OnSnapshotRequest);
  Subscribe(topics::kMapGridRequest, &MapApp::OnGridRequest);
}

void MapApp::OnArea(const Stamped<SurveyArea>& area) {
  if (const auto problem = ProblemOf(area.value, params_.cell.value())) {
    ClearWarning("AREA_REFUSED");  // one text per warning: the last one refused
    Warn("AREA_REFUSED", "SURVEY_AREA " + *problem);
    return;
  }
  ClearWarning("AREA_REFUSED");
  if (!area_ || EncodeRecord(*area_) != EncodeRecord(area.value)) {
    area_ = area.value;
    grid_.emplace(area.value, params_.cell.value());
  }
}

void MapApp::OnGridRequest(const Stamped<std::string>& /*cause*/) {
  has_told_looks_ = false;  // who asks has been restarted
  if (grid_) {
    Publish(topics::kMapDelta, grid_->Everything());
  }
}

void MapApp::OnPhase(const Stamped<std::string>& phase) { phase_ = phase.value; }

bool MapApp::IsMapping() const {
  // Without a mission manager (a replayed log, a bench) every frame counts.
  return phase_.empty() || phase_ == "DIVE" || phase_ == "SURVEY" || phase_ == "RETURN";
}

std::optional<double> MapApp::AltitudeOf(const Sight& sight) {
  if (sight.altitude) {
    altitude_ = Stamped<double>{sight.exposure, *sight.altitude};
  }
  const bool is_fresh = altitude_ && sight.exposure - altitude_->time <= params_.altitude_lasts;
  return is_fresh ? std::optional<double>(altitude_->value) : std::nullopt;
}

void MapApp::OnSight(const Stamped<Sight>& sight) {
  const std::optional<double> altitude = AltitudeOf(sight.value);
  if (last_sight_ && sight.value.exposure <= *last_sight_) {
    Warn("SIGHT_OUT_OF_ORDER", "a frame came late and was left out");
    return;
  }
  last_sight_ = sight.value.exposure;
  if (!IsMapping() || !altitude || *altitude > params_.highest_view.value()) {
    return;
  }
  book_.AddSight(RecordOf(sight.value));
  layer_.AddSight(book_.sights().back(), book_);
  if (grid_) {
    grid_->Observe(sight.value.pose(), *altitude, camera_);
  }
}

void MapApp::OnBeams(const Stamped<PosedBeams>& beams) {
  const PosedBeams& ping = beams.value;
  for (const BeamEnd& end : BeamEnds(ping.pose(), {ping.b1, ping.b2, ping.b3, ping.b4})) {
    octree_.InsertBeam(ping.pose().p_WB, end.p_W);
    if (grid_ && end.is_seabed) {
      grid_->SetSeabed(end.p_W.x(), end.p_W.y(), end.p_W.z());
    }
  }
}

void MapApp::OnTrackShift(const Stamped<TrackShift>& shift) {
  book_.MoveSights([&shift](double t, const Pose& X_WB) { return shift.value.Apply(t, X_WB); });
}

void MapApp::OnLandmarks(const Stamped<Landmarks>& landmarks) {
  book_.SetLandmarks(ConfirmedOf(landmarks.value));
}

void MapApp::OnPrior(const Stamped<SessionPrior>& prior) { book_.SetFormer(FormerOf(prior.value)); }

void MapApp::TellHowItLooks() {
  if (!has_told_looks_) {
    has_told_looks_ = true;
    Publish(topics::kMapLook, ToMapLook({.camera = camera_,
                                         .detection = params_.status.detection,
                                         .object_radius = params_.status.object_radius.value()}));
  }
}

void MapApp::Tick(Seconds now) {
  TellHowItLooks();
  if (last_publish_ && now - *last_publish_ < params_.publish_every) {
    return;
  }
  last_publish_ = now;
  if (grid_) {
    if (const GridDelta delta = grid_->TakeDelta(); !delta.cells.empty()) {
      Publish(topics::kMapDelta, delta);
    }
    Publish(topics::kMapCoverage, grid_->coverage());
  }
  PublishObjects();
}

void MapApp::UpdateObjects() {
  objects_ = book_.Assess();
  layer_.SetObjects(objects_, book_, octree_);
}

void MapApp::PublishObjects() {
  UpdateObjects();
  OpiBeliefs beliefs;
  for (const ObjectStatus& status : objects_) {
    OpiBelief belief = BeliefOf(status);
    if (const std::optional<ObjectCluster> cluster = layer_.Cluster(status.id)) {
      belief.centroid = {cluster->centre.x(), cluster->centre.y(), cluster->centre.z()};
      belief.centroid_sd = {cluster->deviation.x(), cluster->deviation.y(), cluster->deviation.z()};
    }
    beliefs.opis.push_back(std::move(belief));
  }
  Value encoded = TopicCodec<OpiBeliefs>::Encode(beliefs);
  if (!last_objects_ || *last_objects_ != encoded) {
    PublishRaw(topics::kMapOpis.name, encoded);
    last_objects_ = std::move(encoded);
    drawing_.Draw(beliefs);
  }
}

void MapApp::OnSnapshotRequest(const Stamped<std::string>&) {
  UpdateObjects();
  const std::string bytes = octree_.Serialize();
  const auto* first = reinterpret_cast<const std::byte*>(bytes.data());
  Publish(topics::kMapSnapshot, Binary(first, first + bytes.size()));
}

LIMPET_REGISTER_APP(MapApp, "pMap", 4.0);

}  // namespace limpet

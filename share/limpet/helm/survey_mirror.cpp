// SPDX-License-Identifier: MIT
#include "limpet/helm/survey_mirror.hpp"

#include <algorithm>
#include <utility>

#include "limpet/survey/standing_ground.hpp"

namespace limpet {
namespace {

LayerWeights WeightsOfLayers(double bottom) {
  LayerWeights weights;
  weights.fill(1.0 / (bottom + Footprint::kLayers - 1));
  weights.front() *= bottom;
  return weights;
}

Expected<SimplePolygon> PolygonOf(const Obstacle& obstacle) {
  std::vector<PlanePoint> corners;
  for (const auto& [north, east] : obstacle.outline) {
    corners.emplace_back(north, east);
  }
  return SimplePolygon::Of(std::move(corners));
}

/// What paths keep off.
std::vector<Fence> FencesAround(const std::vector<Obstacle>& obstacles, Meters clearance) {
  std::vector<Fence> fences;
  for (const Obstacle& obstacle : obstacles) {
    if (auto polygon = PolygonOf(obstacle)) {
      fences.push_back({.polygon = *std::move(polygon), .distance = clearance.value()});
    }
  }
  return fences;
}

}  // namespace

SurveyMirror::SurveyMirror(const ViewParams& params)
    : params_(params), watch_(params.survey_altitude, params.tracking_allowance) {}

bool SurveyMirror::SetArea(const SurveyArea& area) {
  if (area_ == area) {
    return false;
  }
  area_ = area;
  grid_ = std::make_unique<SurveyGrid>(area);
  LeaveOutStandingGround();
  blocks_.emplace(*grid_, FootprintNow());
  MirrorGround();
  fences_.emplace(area, params_.tracking_allowance, params_.turning_radius);
  KeepOffFences({.border = params_.tracking_allowance, .zones = params_.tracking_allowance});
  return true;
}

void SurveyMirror::KeepOffFences(const KeptOff& kept_off) {
  kept_off_ = kept_off;
  region_ = std::make_unique<Region>(*area_, kept_off,
                                     FencesAround(obstacles_, params_.obstacle_clearance));
}

bool SurveyMirror::SetObstacles(const std::vector<Obstacle>& obstacles) {
  if (obstacles_ == obstacles) return false;
  obstacles_ = obstacles;
  if (!area_) return true;
  KeepOffFences(kept_off_);
  LeaveOutStandingGround();
  return true;
}

void SurveyMirror::LeaveOutStandingGround() {
  grid_->SetStanding(
      StandingGround(obstacles_, grid_->frame(), PlanePoint(place_.north, place_.east)));
}

bool SurveyMirror::KeepsOff(const DubinsPath& path) const { return region_->Contains(path); }

int SurveyMirror::shapeless_obstacles() const {
  return static_cast<int>(std::ranges::count_if(
      obstacles_, [](const Obstacle& obstacle) { return !PolygonOf(obstacle); }));
}

void SurveyMirror::UpdateGround(double travelled) {
  ground_->Update(*grid_);
  while (blocks_->GoOn(*ground_, {place_.north, place_.east}, travelled)) {
    MirrorGround();
  }
  const Meters sight(ground_->footprint().half_across(Footprint::kTop));
  const KeptOff kept_off = fences_->For(place_, place_sigma_, kept_off_, sight);
  if (kept_off != kept_off_) KeepOffFences(kept_off);
}

// Such a plan waits at the way on to the next block: it would, for ever.
void SurveyMirror::NoteChoice(const Option& option) {
  constexpr double kWorthSeeing = 1.0;  // [m] of a lane
  gives_up_ = false;
  if (!option.is_whole() || seen()(option.path).new_area >= kWorthSeeing * ground_->swath()) return;
  gives_up_ = option.lacking_m > 0.0 && !blocks_->Onward();
  blocks_->GiveUp();
}

Footprint SurveyMirror::FootprintNow() const {
  Footprint footprint(
      {.altitude = params_.survey_altitude.value(), .object_height_max = area_->object_height_max},
      params_.camera.geometry(), reach_);
  footprint.DrawIn(seam_allowance_);
  return footprint;
}

void SurveyMirror::MirrorGround() {
  ground_ = std::make_unique<Ground>(*grid_, FootprintNow(), WeightsOfLayers(params_.bottom_weight),
                                     blocks_->now(), blocks_->cells_per_side());
  sight_ = std::make_unique<SeenAlong>(*ground_);
}

void SurveyMirror::SetLookModel(const MapLook& look) {
  watch_.SetModel(look);
  reach_ = HalfRange(look.detection);
  seam_allowance_ = look.seam_allowance.value_or(0.0);
  if (area_) {
    MirrorGround();
  }
}

bool SurveyMirror::SeesWholeBand() const {
  if (!ground_ || !ground_->footprint().is_in_reach(Footprint::kTop)) {
    return true;
  }
  return ground_->footprint().half_along(Footprint::kTop) > 0.0 &&
         ground_->footprint().half_across(Footprint::kTop) > 0.0;
}

bool SurveyMirror::SetObjects(const std::vector<OpiBelief>& objects) {
  const auto same_decision = [](const OpiBelief& a, const OpiBelief& b) {
    return a.id == b.id && a.decided == b.decided;
  };
  const bool is_same = std::ranges::equal(objects, watch_.beliefs(), same_decision);
  watch_.SetBeliefs(objects);
  return !is_same;
}

void SurveyMirror::Apply(const GridDelta& delta) {
  if (grid_) {
    static_cast<void>(grid_->Apply(delta));  // another frame is another area's late mail
  }
}

void SurveyMirror::NoteAltitude(const NavState& nav) {
  place_ = {.north = nav.north, .east = nav.east, .yaw = nav.yaw};
  place_sigma_ = Meters(std::max(nav.sd_north, nav.sd_east));
  if (nav.altitude) {
    seabed_down_ = nav.down + *nav.altitude;
  }
}

Situation SurveyMirror::Snapshot(Seconds now, const Pose2& pose, double travelled) const {
  return {.now = now,
          .pose = pose,
          .ground = ground_.get(),
          .region = region_.get(),
          .turn_radius = params_.turning_radius,
          .home = home_.value_or(HomePoint{}),
          .objects = watch_.Objects(grid_.get(), seabed_down_),
          .coverage = coverage_,
          .travelled = travelled,
          .reach = reach_of_battery_,
          .onward_W = blocks_->Onward(),
          .course_cost = course_cost_};
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "estimation/mapping/anchored_grid.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace limpet {

AnchoredGrid::AnchoredGrid(const SurveyArea& area, Meters cell, const CameraModel& camera,
                           const BeamMap& beams)
    : area_(area),
      camera_(camera),
      beams_(&beams),
      grid_(area, cell.value()),
      first_ping_(beams.pings()),
      next_ping_(first_ping_) {}

void AnchoredGrid::Observe(double t, const Pose& X_WB, double altitude) {
  TakePings();
  frames_.push_back(
      {.t = t, .X_WB = X_WB, .altitude = altitude, .pings_before = next_ping_, .moved = {}});
  grid_.Observe(X_WB, altitude, camera_);
}

void AnchoredGrid::TakePings() { LayPings(grid_, next_ping_, beams_->pings()); }

int AnchoredGrid::LayPings(SurveyGrid& grid, std::size_t& next, std::size_t end) const {
  int cells = 0;
  for (; next < end; ++next) {
    for (const Eigen::Vector3d& end_W : beams_->SeabedEnds(next)) {
      cells += grid.SetSeabed(end_W.x(), end_W.y(), end_W.z());
    }
  }
  return cells;
}

void AnchoredGrid::SetReach(double reach) {
  reach_ = reach;
  grid_.SetReach(reach);
  if (remake_) remake_->grid.SetReach(reach);
}

bool AnchoredGrid::ShowsOtherGround(const Frame& frame) const {
  constexpr double kCells = 0.5;
  const auto [north, east, down, yaw] = frame.moved;
  const double corner = frame.altitude * std::hypot(camera_.half_along(), camera_.half_across());
  const double off = std::sqrt(static_cast<double>(north * north + east * east + down * down)) +
                     std::abs(static_cast<double>(yaw)) * corner;
  return !(off <= kCells * grid_.frame().cell_m);
}

void AnchoredGrid::Shift(const TrackShift& shift) {
  for (Frame& frame : frames_) {
    const Pose moved = shift.Apply(frame.t, Pose{});
    frame.X_WB = shift.Apply(frame.t, frame.X_WB);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      frame.moved[axis] += static_cast<float>(moved.p_WB[static_cast<Eigen::Index>(axis)]);
    }
    frame.moved[3] += static_cast<float>(moved.yaw);
    is_stale_ = is_stale_ || ShowsOtherGround(frame);
  }
}

void AnchoredGrid::StartRemake() {
  is_stale_ = false;
  for (Frame& frame : frames_) {
    frame.moved = {};
  }
  remake_.emplace(Remake{
      .grid = SurveyGrid(area_, grid_.frame().cell_m), .next_frame = 0, .next_ping = first_ping_});
  if (reach_) remake_->grid.SetReach(*reach_);
}

// A shift that comes meanwhile moves frames that were taken already: then it is begun anew once it
// is done, so that it is done at last however often shifts come.
bool AnchoredGrid::Settle(int work) {
  if (!remake_ && is_stale_ && beams_->is_settled()) {
    StartRemake();
  }
  if (!remake_) return !is_stale_;
  for (; remake_->next_frame < frames_.size(); ++remake_->next_frame) {
    if (work <= 0) return false;
    const Frame& frame = frames_[remake_->next_frame];
    work -= LayPings(remake_->grid, remake_->next_ping, frame.pings_before);
    work -= remake_->grid.Observe(frame.X_WB, frame.altitude, camera_);
  }
  TakePings();
  LayPings(remake_->grid, remake_->next_ping, next_ping_);
  grid_.Become(std::move(remake_->grid));
  remake_.reset();
  return !is_stale_;
}

}  // namespace limpet

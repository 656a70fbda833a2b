// SPDX-License-Identifier: MIT
#include "estimation/mapping/anchored_grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "limpet/survey/seam_allowance.hpp"
#include "limpet/survey/standing_ground.hpp"

namespace limpet {

AnchoredGrid::AnchoredGrid(const SurveyArea& area, Meters cell, const CameraModel& camera,
                           const BeamMap& beams, Meters seam_loss)
    : area_(area),
      camera_(camera),
      beams_(&beams),
      seam_loss_(seam_loss),
      grid_(area, cell.value()),
      belief_(area, grid_),
      first_ping_(beams.pings()),
      next_ping_(first_ping_) {}

int AnchoredGrid::Lay(const PlacedView& view, SurveyGrid& grid, CoverageBelief& belief) const {
  const double allowance = SeamAllowance(Meters(view.sigma.beside), seam_loss_);
  const Shadows shadows = ShadowsOf(view);
  const int cells = grid.Observe(view.X_WB, view.altitude, camera_, allowance, shadows);
  return cells + belief.Observe(view, camera_, grid, shadows);
}

Shadows AnchoredGrid::ShadowsOf(const PlacedView& view) const {
  if (sight_obstacles_.empty()) return {};
  constexpr double kTilted = 1.5;  // an image of a vehicle that rolls reaches farther
  const double reach =
      kTilted * view.altitude * std::hypot(camera_.half_along(), camera_.half_across());
  return sight_obstacles_.From(EyeOf(camera_, view.X_WB), reach);
}

bool AnchoredGrid::HasShadows() const {
  return std::ranges::any_of(frames_,
                             [this](const Frame& frame) { return !ShadowsOf(frame.view).empty(); });
}

void AnchoredGrid::Observe(const PlacedView& view) {
  constexpr double kFrames = 240.0;  // a minute of a camera
  TakePings();
  frames_.push_back({.view = view,
                     .pings_before = next_ping_,
                     .beside_as_laid = static_cast<float>(view.sigma.beside),
                     .moved = {}});
  Lay(view, grid_, belief_);
  ++frames_since_judged_;
  if (frames_since_sight_) ++*frames_since_sight_;
  const double allowance = SeamAllowance(Meters(view.sigma.beside), seam_loss_);
  recent_allowance_ += (allowance - recent_allowance_) / kFrames;
}

void AnchoredGrid::Judge() {
  constexpr int kFrames = 8;  // two seconds
  const bool have_ceased = frames_since_judged_ == frames_at_last_call_;
  if (frames_since_judged_ >= kFrames || (frames_since_judged_ > 0 && have_ceased)) {
    expected_ = belief_.Expected(grid_);
    frames_since_judged_ = 0;
  }
  frames_at_last_call_ = frames_since_judged_;
}

Coverage AnchoredGrid::coverage() const {
  Coverage coverage = expected_;
  const Coverage done = grid_.coverage();
  coverage.done_seabed = done.seabed;
  coverage.done_band = done.band;
  coverage.done_band_top = done.band_top;
  return coverage;
}

void AnchoredGrid::TakePings() { LayPings(grid_, next_ping_, beams_->pings()); }

int AnchoredGrid::LayPings(SurveyGrid& grid, std::size_t& next, std::size_t end) const {
  int cells = 0;
  for (; next < end; ++next) {
    for (const Eigen::Vector3d& end_W : beams_->SeabedEnds(next)) {
      cells += grid.SetSeabed(end_W);
    }
  }
  return cells;
}

void AnchoredGrid::SetReach(double reach) {
  reach_ = reach;
  grid_.SetReach(reach);
  belief_.CountAnew();
  if (!remake_) return;
  remake_->grid.SetReach(reach);
  remake_->belief.CountAnew();
}

void AnchoredGrid::SetObstacles(const std::vector<Obstacle>& obstacles) {
  std::optional<PlanePoint> vehicle;
  if (!frames_.empty()) vehicle = frames_.back().view.X_WB.p_WB.head<2>();
  std::vector<std::uint32_t> standing = StandingGround(obstacles, grid_.frame(), vehicle);
  const bool had_shadows = HasShadows();
  sight_obstacles_ = SightObstacles(obstacles);
  if (had_shadows || HasShadows()) frames_since_sight_ = 0;
  if (remake_ && remake_->grid.SetStanding(standing)) remake_->belief.CountAnew();
  if (!grid_.SetStanding(std::move(standing))) return;
  belief_.CountAnew();
  frames_since_judged_ = std::max(1, frames_since_judged_);
  frames_at_last_call_ = frames_since_judged_;
}

bool AnchoredGrid::ShowsOtherGround(const Frame& frame) const {
  constexpr double kCells = 0.5;
  constexpr double kSurer = 0.1;  // [m]
  const auto [north, east, down, yaw] = frame.moved;
  const double corner =
      frame.view.altitude * std::hypot(camera_.half_along(), camera_.half_across());
  const double off = std::sqrt(static_cast<double>(north * north + east * east + down * down)) +
                     std::abs(static_cast<double>(yaw)) * corner;
  const double known_better = static_cast<double>(frame.beside_as_laid) - frame.view.sigma.beside;
  return !(off <= kCells * grid_.frame().cell_m) || std::abs(known_better) > kSurer;
}

void AnchoredGrid::Shift(const TrackShift& shift) {
  for (Frame& frame : frames_) {
    const double t = frame.view.t;
    const Pose moved = shift.Apply(t, Pose{});
    frame.view.X_WB = shift.Apply(t, frame.view.X_WB);
    frame.view.sigma = shift.SigmaAt(t).value_or(frame.view.sigma);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      frame.moved[axis] += static_cast<float>(moved.p_WB[static_cast<Eigen::Index>(axis)]);
    }
    frame.moved[3] += static_cast<float>(moved.yaw);
    is_stale_ = is_stale_ || ShowsOtherGround(frame);
  }
}

void AnchoredGrid::StartRemake() {
  is_stale_ = false;
  frames_since_sight_.reset();
  for (Frame& frame : frames_) {
    frame.moved = {};
    frame.beside_as_laid = static_cast<float>(frame.view.sigma.beside);
  }
  SurveyGrid grid = grid_.Blank();
  CoverageBelief belief(area_, grid);
  remake_.emplace(Remake{.grid = std::move(grid),
                         .belief = std::move(belief),
                         .next_frame = 0,
                         .next_ping = first_ping_});
  if (reach_) remake_->grid.SetReach(*reach_);
}

// A shift that comes meanwhile moves frames that were taken already: then it is begun anew once it
// is done, so that it is done at last however often shifts come.
bool AnchoredGrid::Settle(int work) {
  constexpr int kNoNews = 40;  // frames: ten seconds in which no more was found
  is_stale_ = is_stale_ || frames_since_sight_.value_or(0) >= kNoNews;
  if (!remake_ && is_stale_ && beams_->is_settled()) {
    StartRemake();
  }
  if (!remake_) return !is_stale_;
  for (; remake_->next_frame < frames_.size(); ++remake_->next_frame) {
    if (work <= 0) return false;
    const Frame& frame = frames_[remake_->next_frame];
    work -= LayPings(remake_->grid, remake_->next_ping, frame.pings_before);
    work -= Lay(frame.view, remake_->grid, remake_->belief);
  }
  TakePings();
  LayPings(remake_->grid, remake_->next_ping, next_ping_);
  grid_.Become(std::move(remake_->grid));
  belief_ = std::move(remake_->belief);
  frames_since_judged_ = std::max(1, frames_since_judged_);
  frames_at_last_call_ = frames_since_judged_;
  remake_.reset();
  return !is_stale_;
}

}  // namespace limpet

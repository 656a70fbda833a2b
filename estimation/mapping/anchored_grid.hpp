// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "estimation/mapping/beam_map.hpp"
#include "limpet/survey/coverage_belief.hpp"
#include "limpet/survey/survey_grid.hpp"
#include "limpet/topics/mapping.hpp"
#include "limpet/topics/navigation.hpp"

namespace limpet {

/// The survey grid with the belief in what it shows, and what they are made of: the frames' poses
/// with their sigmas, and the seabed that the pings of a BeamMap show. When the smoother has moved
/// the way behind so far that other ground was seen than was thought, or when it knows better how
/// surely, the grid is made anew beside the one in use, a bounded part per tick, and then takes its
/// place: it is then, cell for cell, what the corrected track would have made. What was not really
/// seen is unseen again.
class AnchoredGrid {
 public:
  /// Cells looked at in one tick: two to three milliseconds.
  static constexpr int kWorkPerTick = 70'000;

  /// Ground seen, and pings laid, from now on. `beams` outlives this.
  /// `seam_loss`: as SeamAllowance has it.
  AnchoredGrid(const SurveyArea& area, Meters cell, const CameraModel& camera, const BeamMap& beams,
               Meters seam_loss);

  /// A frame that counts.
  void Observe(const PlacedView& view);
  /// The pings that the beams have had since the last call.
  void TakePings();
  void SetReach(double reach);
  /// All that stands in the way, as it is known now: its ground is not to be seen, and what it
  /// hides is not. What former images showed is counted anew once no more has been found for a
  /// while.
  void SetObstacles(const std::vector<Obstacle>& obstacles);
  /// The track behind has moved; the beams are to be told, too.
  void Shift(const TrackShift& shift);
  /// Goes on making the grid anew if it must be; waits for the beams to be where they belong.
  /// True if nothing is left to do.
  bool Settle(int work = kWorkPerTick);

  [[nodiscard]] SurveyGrid& grid() { return grid_; }
  [[nodiscard]] const SurveyGrid& grid() const { return grid_; }
  /// Expected as of the last Judge, and done as the grid counts it now.
  [[nodiscard]] Coverage coverage() const;
  /// Counts what is expected anew, now and then: with every eighth frame, when frames have ceased,
  /// and when the grid has been made anew.
  void Judge();
  /// By what images are drawn in on average over the latest minute of frames [m].
  [[nodiscard]] double recent_allowance() const { return recent_allowance_; }

 private:
  struct Frame {
    PlacedView view;
    std::size_t pings_before = 0;
    float beside_as_laid = 0.0F;  ///< sigma by which the grid was last made of it [m]
    /// What it has moved since the grid was last made of it: north, east, down [m], yaw [rad].
    std::array<float, 4> moved{};
  };
  /// A grid in the making.
  struct Remake {
    SurveyGrid grid;
    CoverageBelief belief;
    std::size_t next_frame = 0, next_ping = 0;
  };

  [[nodiscard]] bool ShowsOtherGround(const Frame& frame) const;
  /// Shows a frame to a grid and the belief; returns the cells they looked at.
  int Lay(const PlacedView& view, SurveyGrid& grid, CoverageBelief& belief) const;
  void StartRemake();
  [[nodiscard]] Shadows ShadowsOf(const PlacedView& view) const;
  /// Whether there is a frame that obstacles hide something from.
  [[nodiscard]] bool HasShadows() const;
  /// Lays pings into the grid from `next` up to `end`; returns the cells it looked at.
  int LayPings(SurveyGrid& grid, std::size_t& next, std::size_t end) const;

  SurveyArea area_;
  CameraModel camera_;
  const BeamMap* beams_;
  Meters seam_loss_;
  std::optional<double> reach_;
  SurveyGrid grid_;
  CoverageBelief belief_;
  Coverage expected_;
  int frames_since_judged_ = 0, frames_at_last_call_ = 0;
  double recent_allowance_ = 0.0;
  std::deque<Frame> frames_;
  std::size_t first_ping_, next_ping_;
  SightObstacles sight_obstacles_;
  std::optional<int> frames_since_sight_;  ///< since other obstacles were known; until a remake
  bool is_stale_ = false;  ///< frames have moved since the grid, or its remake, was begun
  std::optional<Remake> remake_;
};

}  // namespace limpet

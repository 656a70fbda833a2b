// SPDX-License-Identifier: MIT
// A plan of everything that is left of a survey: passes in their order, and what it costs.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "limpet/core/units.hpp"
#include "limpet/planning/ground.hpp"
#include "limpet/planning/link_memory.hpp"
#include "limpet/planning/objective.hpp"
#include "limpet/planning/pass.hpp"
#include "limpet/planning/path_valuer.hpp"
#include "limpet/planning/region.hpp"
#include "limpet/planning/seen_planes.hpp"
#include "limpet/planning/sweep_memory.hpp"
#include "limpet/topics/energy.hpp"

namespace limpet {

/// Passes in the order in which they are flown; the shortest motions inside the region join them.
using SurveyTour = std::vector<Pass>;

/// Shares of the band's top and of the bottom that are most of it. By that of the top 95 % of all
/// the band has about been seen.
inline constexpr double kMostOfTop = 0.92;
inline constexpr double kMostOfBottom = 0.95;

/// What a tour is to achieve, and what that is worth.
struct TourGoal {
  /// The survey is over when this share of the band's top has been seen.
  double finish_share = 0.98;
  /// Metres that the way may be longer for ground to be seen a metre sooner, mean over the area.
  double early_weight = kSurveyRates.early;
  /// Metres that it may be longer for most of bottom and band's top (TourCost::most) to have been
  /// seen a metre sooner: what is left then are slivers, which may come last.
  double most_weight = kSurveyRates.most;
  /// Where the vehicle goes when it is over, or on when this block of it is, NED [m].
  PlanePoint home_W{0.0, 0.0};
  /// What is sought besides ground, over the first `target_decay_m` of the way; its rates for
  /// ground do not count.
  Objective others{};
  double others_weight = 1.0;  ///< metres of way that a unit of it is worth
  CourseCost course_cost{};    ///< in the current there is
};

/// What a tour costs, all in metres of path.
struct TourCost {
  double length = 0.0;  ///< from the start to the finish, or to the end of the tour
  /// From the start until most of bottom and top has been seen: mean of the two by the weights of
  /// their layers. Of a tour that ends before, with about what it would take on top, or none would
  /// cost as little as not to fly at all.
  double most = 0.0;
  double lateness = 0.0;  ///< mean over the area of the path at which ground is first seen
  double home = 0.0;      ///< straight way home from there
  double toll = 0.0;      ///< what the current adds to all of that: CurrentToll
  double missing = 0.0;   ///< useful track that the finish still lacks
  double lacking = 0.0;   ///< price of that: about what it takes to fetch it
  double others = 0.0;    ///< worth of what is sought besides ground
  double detours = 0.0;   ///< price of the links that leave the region
  double total = 0.0;     ///< what tours are compared by
};

/// Judges tours from one pose over one ground.
class TourJudge {
 public:
  /// `ground` and `region` must outlive this.
  TourJudge(const Ground& ground, const Region& region, Meters turn_radius);

  /// Tours start at the end of `way` from now on, which is flown before them and counts with them.
  void Reset(const DubinsPath& way, const TourGoal& goal);

  /// Of two tours that begin with the same passes, one judged after the other, these are flown
  /// once.
  [[nodiscard]] TourCost Cost(const SurveyTour& tour);

  /// The link as LinkBetween finds it, inside the region. Good until the next call.
  [[nodiscard]] const PassLink& Link(const Pose2& from, const Pose2& to) {
    return links_.Between(from, to);
  }

  /// The pose at which tours start.
  [[nodiscard]] const Pose2& start() const { return base_.end; }
  [[nodiscard]] const Region& region() const { return region_; }
  [[nodiscard]] Meters turn_radius() const { return turn_radius_; }
  [[nodiscard]] const Ground& ground() const { return ground_; }
  [[nodiscard]] const TourGoal& goal() const { return goal_; }
  /// Whether nothing is left to do at the start.
  [[nodiscard]] bool is_finished() const { return base_.is_finished; }
  /// What the tour leaves unseen that Cost judged last. REQUIRES: Cost was called.
  [[nodiscard]] const SeenPlanes& planes() const { return planes_; }
  /// After Cost: how many of the tour's passes come before the finish.
  [[nodiscard]] std::size_t passes_needed() const { return stages_.size(); }

 private:
  /// How things stand after a pass.
  struct Stage {
    Pass pass;
    Pose2 end;
    TourCost cost;
    bool is_finished = false;
    SeenPlanes::Moment seen;
    std::size_t others_mark = 0;
  };
  /// Goes back to where `tour` parts from the tour flown last.
  [[nodiscard]] Stage Rejoin(const SurveyTour& tour);
  void FlyPass(const Pass& pass, Stage& stage);
  [[nodiscard]] bool Fly(const Pose2& from, const PathSegment& segment, TourCost& cost);
  /// Counts as much of the piece as is flown before most has been seen.
  void NoteMost(const SeenPlanes::Counts& before, double piece, TourCost& cost) const;
  /// Useful track that `left` cells of a plane are [m].
  [[nodiscard]] double TrackOf(int left, std::size_t plane) const;
  /// What it would take until most has been seen, after the tour that was flown last [m].
  [[nodiscard]] double MostToCome() const;
  [[nodiscard]] bool FlyPiece(const SweptMotion& motion, std::size_t i, TourCost& cost);

  const Ground& ground_;
  const Region& region_;
  Meters turn_radius_;
  LinkMemory links_;
  SeenPlanes planes_;
  SweepMemory sweeps_;
  TourGoal goal_;
  int may_stay_ = 0;                    ///< cells of the top that may be left
  SeenPlanes::Counts most_may_stay_{};  ///< cells unseen when most of them have been seen
  double cell_m2_;
  double wanted_cells_;
  std::optional<PathValuer> others_;
  Stage base_;                 ///< before the first pass
  std::vector<Stage> stages_;  ///< of the tour flown last
};

}  // namespace limpet

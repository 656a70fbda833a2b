// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "limpet/helm/object_watch.hpp"
#include "limpet/helm/situation.hpp"
#include "limpet/helm/view_params.hpp"
#include "limpet/planning/fence_allowance.hpp"
#include "limpet/planning/survey_blocks.hpp"
#include "limpet/survey/survey_grid.hpp"

namespace limpet {

/// The helm's picture of the survey, kept up to date by mail: area, ground seen, objects, home.
/// Makes the snapshots that behaviors and generators judge by.
class SurveyMirror {
 public:
  explicit SurveyMirror(const ViewParams& params);

  /// False if that is the area already: what is known of it stays.
  bool SetArea(const SurveyArea& area);
  void SetHome(const HomePoint& home) { home_ = home; }
  void SetReach(Meters reach) { reach_of_battery_ = reach; }
  void SetCourseCost(CourseCost cost) { course_cost_ = std::move(cost); }
  [[nodiscard]] const std::optional<HomePoint>& home() const { return home_; }
  void SetCoverage(const Coverage& coverage) { coverage_ = coverage; }
  /// Takes what the map judges looks by, and how far one sees: what is left to see follows from it.
  void SetLookModel(const MapLook& look);
  /// True if an object is new, gone, or decided otherwise than before.
  bool SetObjects(const std::vector<OpiBelief>& objects);
  /// What stands in the way, all of it; false if that is known already. Outlines that are none are
  /// not kept off.
  bool SetObstacles(const std::vector<Obstacle>& obstacles);
  /// Whether a path stays in the region and off all of those. REQUIRES: has_area().
  [[nodiscard]] bool KeepsOff(const DubinsPath& path) const;
  /// How many of those have no outline that paths could keep off.
  [[nodiscard]] int shapeless_obstacles() const;
  /// Blocks of a large area that were left with more than slivers unseen.
  [[nodiscard]] std::size_t blocks_passed_over() const {
    return blocks_ ? blocks_->passed_over() : 0;
  }
  void Apply(const GridDelta& delta);
  /// Where the vehicle is, for the depth of the seabed where none has been seen, and how sure it is
  /// of that, for what paths keep off the region's border.
  void NoteAltitude(const NavState& nav);
  /// Takes the grid's present state, and the region as the place is known now; of a large area the
  /// block that is due after `travelled` metres of way. REQUIRES: has_area().
  void UpdateGround(double travelled = 0.0);

  /// What is flown next. A plan that shows nothing more gives its block of a large area up.
  /// REQUIRES: has_area().
  void NoteChoice(const Option& option);
  /// True if the plan that is flown is of all that is left, shows nothing more all the same, and
  /// ends short of the share of the bottom at which the survey is to end.
  [[nodiscard]] bool gives_up() const { return gives_up_; }

  [[nodiscard]] bool has_area() const { return area_.has_value(); }
  [[nodiscard]] const std::optional<SurveyArea>& area() const { return area_; }
  /// How the area is cut for planning. REQUIRES: has_area().
  [[nodiscard]] const SurveyBlocks& blocks() const { return *blocks_; }
  /// False if objects at the top of the area's band are never inside the image, in any water.
  [[nodiscard]] bool SeesWholeBand() const;
  /// What paths show of the present ground. REQUIRES: has_area().
  [[nodiscard]] SeenAlong& seen() { return *sight_; }
  [[nodiscard]] LookLedger& ledger() { return watch_.ledger(); }

  /// The snapshot for options that start at `pose`. REQUIRES: has_area(); it is valid until the
  /// next change of this.
  [[nodiscard]] Situation Snapshot(Seconds now, const Pose2& pose, double travelled) const;

 private:
  [[nodiscard]] Footprint FootprintNow() const;
  void MirrorGround();
  void KeepOffFences(const KeptOff& kept_off);
  /// What obstacles stand on is not to be seen.
  void LeaveOutStandingGround();

  ViewParams params_;
  double seam_allowance_ = 0.0;  ///< by which images count as smaller on every side [m]
  double reach_ = std::numeric_limits<double>::infinity();  ///< [m]
  std::optional<SurveyArea> area_;
  std::unique_ptr<SurveyGrid> grid_;
  std::optional<SurveyBlocks> blocks_;
  bool gives_up_ = false;
  std::unique_ptr<Ground> ground_;  ///< of the block that is due
  std::unique_ptr<SeenAlong> sight_;
  std::unique_ptr<Region> region_;
  std::vector<Obstacle> obstacles_;
  std::optional<FenceAllowance> fences_;  ///< of the area
  KeptOff kept_off_;                      ///< by region_
  Pose2 place_{};                         ///< of the vehicle
  Meters place_sigma_{0.0};
  std::optional<HomePoint> home_;
  std::optional<Meters> reach_of_battery_;
  CourseCost course_cost_;
  ObjectWatch watch_;
  Coverage coverage_;
  std::optional<double> seabed_down_;  ///< NED depth of the seabed last measured [m]
};

}  // namespace limpet

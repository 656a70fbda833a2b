// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "apps/pHelm/helm_params.hpp"
#include "limpet/core/random.hpp"
#include "limpet/helm/object_watch.hpp"
#include "limpet/helm/view_decision.hpp"
#include "limpet/planning/line_of_sight.hpp"
#include "limpet/planning/paper_planner.hpp"
#include "limpet/survey/survey_grid.hpp"

namespace limpet {

/// "Where next": mirrors the survey grid, tracks the path in force, and when a decision is due
/// gathers options and lets the running behaviors value them.
class ViewPlanner {
 public:
  ViewPlanner(const HelmParams& params, Random random);

  /// False if that is the area already: what is known of it stays.
  bool SetArea(const SurveyArea& area);
  void SetHome(const HomePoint& home) { home_ = home; }
  void SetOpis(const std::vector<OpiBelief>& opis);
  void SetLookModel(const MapLook& look) { watch_.SetModel(look); }
  void SetCoverage(const Coverage& coverage) { coverage_ = coverage; }
  void SetFormerSession(bool is_loaded) { has_former_session_ = is_loaded; }
  void Apply(const GridDelta& delta);

  /// False if objects at the top of the area's band are never inside the image.
  [[nodiscard]] bool SeesWholeBand() const;

  /// Where to steer for the path in force; nothing without one.
  [[nodiscard]] std::optional<Guidance> Guide(const NavState& nav);
  /// Decides if a decision is due; the chosen path is then in force.
  [[nodiscard]] std::optional<ViewDecision> DecideIfDue(std::span<const WeightedBehavior> running,
                                                        const NavState& nav, Seconds now);
  /// What `running` want of each object, the most eager where they differ; nothing if that cannot
  /// have changed since the last call.
  [[nodiscard]] std::optional<std::vector<RevisitInterest>> InterestsIfDue(
      std::span<const WeightedBehavior> running, const NavState& nav, Seconds now);
  /// Forgets the path, e.g. when nobody wants a view any more.
  void DropPath();

  [[nodiscard]] const DubinsPath& path() const { return path_; }
  [[nodiscard]] const std::optional<SurveyArea>& area() const { return area_; }

 private:
  [[nodiscard]] Situation SituationOf(const NavState& nav, Seconds now) const;
  /// What the chosen path promises to look at, for the ledger.
  void Promise(std::span<const WeightedBehavior> running, const Situation& now);
  [[nodiscard]] double Travelled() const;
  [[nodiscard]] std::string CauseToDecide(std::span<const WeightedBehavior> running,
                                          const NavState& nav) const;
  [[nodiscard]] Pose2 StartPose(const NavState& nav) const;
  [[nodiscard]] Objective ObjectiveOf(std::span<const WeightedBehavior> running,
                                      const Situation& now) const;
  /// Metres of useful track per metre of the first option, the search's best.
  [[nodiscard]] double UsefulShare(const std::vector<Option>& options);
  [[nodiscard]] std::vector<Option> SearchOptions(const Situation& now, const Objective& objective);
  [[nodiscard]] ViewDecision Decide(std::span<const WeightedBehavior> running,
                                    const Situation& now);
  [[nodiscard]] ViewDecision DecideLikeThePaper(const Situation& now);
  void Follow(const Option& option);

  HelmParams params_;
  Random random_;
  std::optional<SurveyArea> area_;
  std::unique_ptr<SurveyGrid> grid_;
  std::unique_ptr<Ground> ground_;
  std::unique_ptr<SightAlong> sight_;
  std::unique_ptr<Region> region_;
  std::unique_ptr<PaperPlanner> paper_;
  HomePoint home_;
  ObjectWatch watch_;
  Coverage coverage_;
  bool has_former_session_ = false;

  DubinsPath path_;
  std::string purpose_;  ///< of the path: the source of the option that was chosen
  bool has_path_ = false;
  bool objects_changed_ = false;
  bool are_interests_due_ = false;
  std::optional<double> seabed_down_;  ///< NED depth of the seabed last measured [m]
  std::vector<std::string>
      decided_by_;  ///< names of behaviors that were running at the last decision
  LineOfSight guidance_;
  LineOfSight::Steering steering_;
  double travelled_ = 0.0;  ///< along finished paths [m]
  int path_id_ = 0;
};

}  // namespace limpet

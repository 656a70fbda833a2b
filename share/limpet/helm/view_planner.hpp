// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "limpet/core/random.hpp"
#include "limpet/helm/option_search.hpp"
#include "limpet/helm/path_tracker.hpp"
#include "limpet/helm/planner_preset.hpp"
#include "limpet/helm/survey_mirror.hpp"
#include "limpet/helm/view_decision.hpp"
#include "limpet/helm/view_params.hpp"

namespace limpet {

/// "Where next": when a decision is due, options are gathered and the running behaviors value them;
/// the best becomes the path in force.
class ViewPlanner {
 public:
  /// With a `clock`, behaviors that take too long are not heard.
  ViewPlanner(const ViewParams& params, const Random& random, const RealClock& clock = {});

  /// What the helm knows of the survey; mail goes there.
  [[nodiscard]] SurveyMirror& survey() { return survey_; }
  [[nodiscard]] const SurveyMirror& survey() const { return survey_; }
  /// False if that is the area already: what is known of it stays.
  bool SetArea(const SurveyArea& area);
  void SetObjects(const std::vector<OpiBelief>& objects);
  void SetObstacles(const std::vector<Obstacle>& obstacles);

  /// Where to steer for the path in force; nothing without one.
  [[nodiscard]] std::optional<Guidance> Guide(const NavState& nav) { return tracker_.Guide(nav); }
  /// Decides if a decision is due; the chosen path is then in force.
  [[nodiscard]] std::optional<ViewDecision> DecideIfDue(std::span<const WeightedBehavior> running,
                                                        const NavState& nav, Seconds now);
  /// What `running` want of each object, the most eager where they differ; nothing if that cannot
  /// have changed since the last call.
  [[nodiscard]] std::optional<std::vector<RevisitInterest>> InterestsIfDue(
      std::span<const WeightedBehavior> running, const NavState& nav, Seconds now);
  /// Behaviors that failed since the last call: they had no say, or not all of it.
  [[nodiscard]] std::vector<BehaviorFailure> TakeFailures() { return std::exchange(failures_, {}); }
  /// Who was late since the last call.
  [[nodiscard]] std::vector<OwnedWarning> TakeLate();
  /// Forgets the path, e.g. when nobody wants a view any more.
  void DropPath();
  [[nodiscard]] const DubinsPath& path() const { return tracker_.path(); }

 private:
  /// What a behavior wants of each object; nothing if it throws or is late.
  [[nodiscard]] std::vector<RevisitInterest> InterestsBy(const WeightedBehavior& behavior,
                                                         const Situation& now);
  [[nodiscard]] std::vector<RevisitInterest> InterestsOf(std::span<const WeightedBehavior> running,
                                                         const Situation& now);
  /// The objects that some running behavior wants to look at.
  [[nodiscard]] std::vector<WatchedObject> OpenObjects(std::span<const WeightedBehavior> running,
                                                       const Situation& now);
  [[nodiscard]] Situation SituationOf(const NavState& nav, Seconds now) const;
  [[nodiscard]] std::string CauseToDecide(std::span<const WeightedBehavior> running) const;
  void Follow(const Option& option, std::span<const WeightedBehavior> running,
              const Situation& now);

  ViewParams params_;
  PlannerPreset preset_;
  SurveyMirror survey_;
  OptionSearch search_;
  PathTracker tracker_;
  bool objects_changed_ = false, obstacles_changed_ = false;
  bool are_interests_due_ = false;
  /// Names of behaviors that were running at the last decision.
  std::vector<std::string> decided_by_;
  std::vector<BehaviorFailure> failures_;
  AnswerWatch values_, interests_;  ///< over bids on options, and over what is wanted of objects
  std::vector<OwnedWarning> late_;
};

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/helm/view_planner.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "limpet/helm/behavior_failure_warnings.hpp"

namespace limpet {
ViewPlanner::ViewPlanner(const ViewParams& params, const Random& random, const RealClock& clock)
    : params_(params),
      preset_(PresetOf(params)),
      survey_(params),
      search_(params.of_generators, preset_.generators, random, clock),
      values_(clock),
      interests_(clock) {}

std::vector<RevisitInterest> ViewPlanner::InterestsBy(const WeightedBehavior& behavior,
                                                      const Situation& now) {
  std::vector<RevisitInterest> interests;
  const auto late = interests_.Ask(behavior.name, [&] {
    static_cast<void>(
        Heard(behavior.name, failures_, [&] { interests = behavior.behavior->Interests(now); }));
  });
  if (!late) return interests;
  late_.push_back(LatenessOf(behavior.name, *late));
  return {};
}

/// Interests of all behaviors; where several want one object, the most eager counts.
std::vector<RevisitInterest> ViewPlanner::InterestsOf(std::span<const WeightedBehavior> running,
                                                      const Situation& now) {
  std::vector<RevisitInterest> interests;
  for (const WeightedBehavior& behavior : running) {
    for (RevisitInterest& interest : InterestsBy(behavior, now)) {
      const auto known = std::ranges::find(interests, interest.id, &RevisitInterest::id);
      if (known == interests.end()) {
        interests.push_back(std::move(interest));
      } else if (interest.worth > known->worth) {
        *known = std::move(interest);
      }
    }
  }
  return interests;
}

std::vector<WatchedObject> ViewPlanner::OpenObjects(std::span<const WeightedBehavior> running,
                                                    const Situation& now) {
  std::vector<WatchedObject> open;
  for (const WeightedBehavior& behavior : running) {
    for (const RevisitInterest& interest : InterestsBy(behavior, now)) {
      const auto object =
          std::ranges::find(now.objects, interest.id, [](const auto& o) { return o.belief.id; });
      if (interest.state == "open" && object != now.objects.end()) {
        open.push_back(*object);
      }
    }
  }
  return open;
}

std::vector<OwnedWarning> ViewPlanner::TakeLate() {
  std::vector<OwnedWarning> late = search_.TakeLate();
  std::ranges::move(std::exchange(late_, {}), std::back_inserter(late));
  return late;
}

bool ViewPlanner::SetArea(const SurveyArea& area) {
  const bool is_new = survey_.SetArea(area);
  if (is_new) {
    DropPath();
  }
  return is_new;
}

void ViewPlanner::SetObjects(const std::vector<OpiBelief>& objects) {
  objects_changed_ = survey_.SetObjects(objects) || objects_changed_;
  are_interests_due_ = true;
}

void ViewPlanner::SetObstacles(const std::vector<Obstacle>& obstacles) {
  if (!survey_.SetObstacles(obstacles) || obstacles_changed_ || !survey_.has_area()) return;
  // Outlines grow with every ping where a wall comes into sight; what is flown clear of it goes on.
  const double flown = tracker_.has_path() ? tracker_.steering().progress : 0.0;
  const DubinsPath ahead = tracker_.has_path() ? tracker_.path().Rest(flown) : DubinsPath();
  obstacles_changed_ = !tracker_.has_path() || !survey_.KeepsOff(ahead);
}

void ViewPlanner::DropPath() {
  tracker_.Drop();
  decided_by_.clear();
}

std::string ViewPlanner::CauseToDecide(std::span<const WeightedBehavior> running) const {
  const auto same_name = [](const WeightedBehavior& a, const std::string& b) {
    return a.name == b;
  };
  const LineOfSight::Steering& steering = tracker_.steering();
  if (!tracker_.has_path()) {
    return "no path";
  }
  if (!std::ranges::equal(running, decided_by_, same_name)) {
    return "other behaviors are running";
  }
  // A path no longer than that is flown to its end: what is left of it would be chosen in each
  // tick.
  const bool is_long = tracker_.path().length() > params_.arrival.value();
  if (steering.has_arrived || (is_long && steering.remaining <= params_.arrival.value())) {
    return "arrived";
  }
  if (std::abs(steering.cross_track) > params_.off_track.value()) {
    return "off track";
  }
  if (obstacles_changed_) {
    return "obstacles changed";
  }
  if (preset_.decides_at_views_only) {
    return "";
  }
  if (objects_changed_) {
    return "objects changed";
  }
  return steering.progress >= params_.replan_every.value() ? "periodic" : "";
}

Situation ViewPlanner::SituationOf(const NavState& nav, Seconds now) const {
  const Pose2 start = tracker_.JoiningPose(nav, 0.5 * params_.off_track.value());
  return survey_.Snapshot(now, start, tracker_.Travelled());
}

std::optional<std::vector<RevisitInterest>> ViewPlanner::InterestsIfDue(
    std::span<const WeightedBehavior> running, const NavState& nav, Seconds now) {
  if (!are_interests_due_ || !survey_.has_area()) {
    return std::nullopt;
  }
  are_interests_due_ = false;
  return InterestsOf(running, SituationOf(nav, now));
}

void ViewPlanner::Follow(const Option& option, std::span<const WeightedBehavior> running,
                         const Situation& now) {
  search_.TellChoice(option);
  survey_.NoteChoice(option);
  tracker_.Follow(option);
  // What lies further ahead will be decided again before it is flown.
  survey_.ledger().Promise(tracker_.path().Prefix(option.own_length()), OpenObjects(running, now),
                           tracker_.Travelled());
}

std::optional<ViewDecision> ViewPlanner::DecideIfDue(std::span<const WeightedBehavior> running,
                                                     const NavState& nav, Seconds now) {
  survey_.NoteAltitude(nav);
  are_interests_due_ = survey_.ledger().Judge(tracker_.Travelled()) || are_interests_due_;
  const bool is_wanted = std::ranges::any_of(running, [this](const WeightedBehavior& b) {
    bool wants_view = false;
    return Heard(b.name, failures_, [&] { wants_view = b.behavior->WantsView(); }) && wants_view;
  });
  if (!is_wanted || !survey_.has_area()) {
    DropPath();
    return std::nullopt;
  }
  const std::string cause = CauseToDecide(running);
  if (cause.empty()) {
    return std::nullopt;
  }
  survey_.UpdateGround(tracker_.Travelled());
  const Situation situation = SituationOf(nav, now);
  ViewDecision decision =
      DecideView(running, situation, search_.Gather(running, situation, failures_), survey_.seen(),
                 preset_.order, &values_);
  std::ranges::move(decision.failures, std::back_inserter(failures_));
  std::ranges::move(decision.late, std::back_inserter(late_));
  are_interests_due_ = true;
  objects_changed_ = obstacles_changed_ = false;
  decided_by_.clear();
  std::ranges::transform(running, std::back_inserter(decided_by_), &WeightedBehavior::name);
  if (decision.chosen) {
    Follow(*decision.chosen, running, situation);
  }
  decision.bids.cause = cause;
  decision.bids.path_id = tracker_.path_id();
  return decision;
}

}  // namespace limpet

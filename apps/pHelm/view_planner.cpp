// SPDX-License-Identifier: MIT
#include "apps/pHelm/view_planner.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "limpet/planning/beam_search.hpp"
#include "limpet/planning/gap_paths.hpp"

namespace limpet {

ViewPlanner::ViewPlanner(const HelmParams& params, Random random)
    : params_(params),
      random_(std::move(random)),
      watch_(params.survey_altitude, params.tracking_allowance) {}

namespace {

LayerWeights WeightsOfLayers(double bottom) {
  LayerWeights weights;
  weights.fill(1.0 / (bottom + Footprint::kLayers - 1));
  weights.front() *= bottom;
  return weights;
}

}  // namespace

bool ViewPlanner::SetArea(const SurveyArea& area) {
  if (area_ && EncodeRecord(*area_) == EncodeRecord(area)) {
    return false;
  }
  area_ = area;
  grid_ = std::make_unique<SurveyGrid>(area);
  ground_ = std::make_unique<Ground>(
      *grid_,
      Footprint(params_.survey_altitude.value(), area.object_height_max, params_.camera.geometry()),
      WeightsOfLayers(params_.bottom_weight));
  sight_ = std::make_unique<SightAlong>(*ground_);
  region_ = std::make_unique<Region>(
      area, std::max(0.0, area.margin - params_.tracking_allowance.value()));
  DropPath();
  return true;
}

bool ViewPlanner::SeesWholeBand() const {
  constexpr int kTop = Footprint::kLayers - 1;
  return !ground_ || (ground_->footprint().half_along(kTop) > 0.0 &&
                      ground_->footprint().half_across(kTop) > 0.0);
}

void ViewPlanner::SetOpis(const std::vector<OpiBelief>& opis) {
  const auto same_decision = [](const OpiBelief& a, const OpiBelief& b) {
    return a.id == b.id && a.decided == b.decided;
  };
  objects_changed_ = objects_changed_ || !std::ranges::equal(opis, watch_.beliefs(), same_decision);
  watch_.SetBeliefs(opis);
  are_interests_due_ = true;
}

void ViewPlanner::Apply(const GridDelta& delta) {
  if (grid_) {
    static_cast<void>(grid_->Apply(delta));  // another frame is another area's late mail
  }
}

double ViewPlanner::Travelled() const {
  return travelled_ + (has_path_ ? steering_.progress : 0.0);
}

void ViewPlanner::DropPath() {
  travelled_ = Travelled();
  has_path_ = false;
  path_ = DubinsPath();
  decided_by_.clear();
}

std::optional<Guidance> ViewPlanner::Guide(const NavState& nav) {
  if (!has_path_) {
    return std::nullopt;
  }
  steering_ = guidance_.Update(nav.north, nav.east, std::hypot(nav.u, nav.v));
  return Guidance{.course = steering_.course,
                  .turn_rate = steering_.turn_rate,
                  .cross_track = steering_.cross_track,
                  .remaining = steering_.remaining,
                  .purpose = purpose_};
}

std::string ViewPlanner::CauseToDecide(std::span<const WeightedBehavior> running,
                                       const NavState&) const {
  const auto same_name = [](const WeightedBehavior& a, const std::string& b) {
    return a.name == b;
  };
  if (!has_path_) {
    return "no path";
  }
  if (!std::ranges::equal(running, decided_by_, same_name)) {
    return "other behaviors are running";
  }
  if (steering_.has_arrived || steering_.remaining <= params_.arrival.value()) {
    return "arrived";
  }
  if (std::abs(steering_.cross_track) > params_.off_track.value()) {
    return "off track";
  }
  if (params_.planner == "paper") {
    return "";  // the paper's planner decides at viewpoints alone
  }
  if (objects_changed_) {
    return "objects changed";
  }
  return steering_.progress >= params_.replan_every.value() ? "periodic" : "";
}

Pose2 ViewPlanner::StartPose(const NavState& nav) const {
  // From the path where it is being followed: a new path then joins it without a step in course.
  if (has_path_ && std::abs(steering_.cross_track) < 0.5 * params_.off_track.value()) {
    return path_.At(steering_.progress);
  }
  return {.north = nav.north, .east = nav.east, .yaw = nav.yaw};
}

Objective ViewPlanner::ObjectiveOf(std::span<const WeightedBehavior> running,
                                   const Situation& now) const {
  Objective objective{.w_cover = 0.0, .w_frontier = 0.0, .targets = {}};
  for (const WeightedBehavior& behavior : running) {
    behavior.behavior->Shape(now, behavior.weight, objective);
  }
  return objective;
}

double ViewPlanner::UsefulShare(const std::vector<Option>& options) {
  if (options.empty()) {
    return 0.0;
  }
  const DubinsPath& best = options.front().path;
  return (*sight_)(best).new_area / (ground_->swath() * best.length());
}

std::vector<Option> ViewPlanner::SearchOptions(const Situation& now, const Objective& objective) {
  BeamParams beam;
  beam.turn_radius = params_.turning_radius;
  beam.horizon = params_.horizon;
  beam.width = params_.beam_width;
  std::vector<Option> options = BeamSearch(now.pose, *ground_, *region_, objective, beam);
  if (UsefulShare(options) < params_.gap_below) {
    GapParams gaps;
    gaps.turn_radius = params_.turning_radius;
    std::ranges::move(GapPaths(now.pose, *ground_, *region_, objective, gaps),
                      std::back_inserter(options));
  }
  return options;
}

ViewDecision ViewPlanner::Decide(std::span<const WeightedBehavior> running, const Situation& now) {
  const Objective objective = ObjectiveOf(running, now);
  const bool is_covering = objective.w_cover > 0.0;
  const bool is_paper = is_covering && params_.planner == "paper";
  if (is_paper && region_->Outside(now.pose) <= 0.0) {
    return DecideLikeThePaper(now);
  }
  std::vector<Option> options;
  // The paper's planner knows no way into the region: there what behaviors offer decides.
  if (!is_paper && (is_covering || !objective.targets.empty())) {
    options = SearchOptions(now, objective);
  }
  for (const WeightedBehavior& behavior : running) {
    behavior.behavior->Offer(now, options);
  }
  return DecideView(running, now, std::move(options), *sight_);
}

ViewDecision ViewPlanner::DecideLikeThePaper(const Situation& now) {
  if (!paper_) {
    PaperParams paper;
    paper.turn_radius = params_.turning_radius;
    paper.nodes = params_.paper_nodes;
    paper.lambda = params_.paper_lambda;
    paper.gain = params_.gain == "coverage" ? PaperGain::kCoverage
                 : has_former_session_      ? PaperGain::kChange
                                            : PaperGain::kDiscovery;
    paper_ = std::make_unique<PaperPlanner>(paper, *region_, random_);
  }
  ViewDecision decision;
  decision.chosen = paper_->Next(now.pose, *ground_, watch_.beliefs(), coverage_.seabed);
  decision.bids.considered = params_.paper_nodes;
  if (decision.chosen) {
    const Pose2 end = decision.chosen->path.end();
    decision.bids.options.push_back({.source = decision.chosen->source,
                                     .length = decision.chosen->path.length(),
                                     .total = paper_->log_gain(),
                                     .end = {end.north, end.east},
                                     .bids = {{.behavior = "paper",
                                               .value = paper_->log_gain(),
                                               .weight = 1.0,
                                               .has_veto = false,
                                               .why = "ln L of the best branch [nat]"}}});
  }
  return decision;
}

void ViewPlanner::Follow(const Option& option) {
  travelled_ = Travelled();
  path_ = option.path;
  purpose_ = option.source;
  has_path_ = true;
  ++path_id_;
  const Pose2& start = path_.start();
  guidance_.SetPath({start.north, start.east, start.yaw}, path_.segments());
  steering_ = {.remaining = path_.length()};
}

Situation ViewPlanner::SituationOf(const NavState& nav, Seconds now) const {
  return {.now = now,
          .pose = StartPose(nav),
          .ground = ground_.get(),
          .region = region_.get(),
          .turn_radius = params_.turning_radius,
          .home = home_,
          .objects = watch_.Objects(grid_.get(), seabed_down_),
          .coverage = coverage_,
          .travelled = Travelled()};
}

std::optional<std::vector<RevisitInterest>> ViewPlanner::InterestsIfDue(
    std::span<const WeightedBehavior> running, const NavState& nav, Seconds now) {
  if (!are_interests_due_ || !ground_) {
    return std::nullopt;
  }
  are_interests_due_ = false;
  std::vector<RevisitInterest> interests;
  const Situation situation = SituationOf(nav, now);
  for (const WeightedBehavior& behavior : running) {
    for (RevisitInterest& interest : behavior.behavior->Interests(situation)) {
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

void ViewPlanner::Promise(std::span<const WeightedBehavior> running, const Situation& now) {
  std::vector<WatchedObject> open;
  for (const WeightedBehavior& behavior : running) {
    for (const RevisitInterest& interest : behavior.behavior->Interests(now)) {
      const auto object =
          std::ranges::find(now.objects, interest.id, [](const auto& o) { return o.belief.id; });
      if (interest.state == "open" && object != now.objects.end()) {
        open.push_back(*object);
      }
    }
  }
  watch_.ledger().Promise(path_, open, travelled_);
}

std::optional<ViewDecision> ViewPlanner::DecideIfDue(std::span<const WeightedBehavior> running,
                                                     const NavState& nav, Seconds now) {
  if (nav.altitude) {
    seabed_down_ = nav.down + *nav.altitude;
  }
  are_interests_due_ = watch_.ledger().Judge(Travelled()) || are_interests_due_;
  const bool is_wanted = std::ranges::any_of(
      running, [](const WeightedBehavior& b) { return b.behavior->WantsView(); });
  if (!is_wanted || !ground_) {
    DropPath();
    return std::nullopt;
  }
  const std::string cause = CauseToDecide(running, nav);
  if (cause.empty()) {
    return std::nullopt;
  }
  ground_->Update(*grid_);
  const Situation situation = SituationOf(nav, now);
  ViewDecision decision = Decide(running, situation);
  are_interests_due_ = true;
  objects_changed_ = false;
  decided_by_.clear();
  std::ranges::transform(running, std::back_inserter(decided_by_), &WeightedBehavior::name);
  if (decision.chosen) {
    Follow(*decision.chosen);
    Promise(running, situation);
  }
  decision.bids.cause = cause;
  decision.bids.path_id = path_id_;
  return decision;
}

}  // namespace limpet

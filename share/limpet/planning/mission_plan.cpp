// SPDX-License-Identifier: MIT
#include "limpet/planning/mission_plan.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <utility>

#include "limpet/planning/home_path.hpp"
#include "limpet/planning/on_path.hpp"
#include "limpet/planning/target_tour.hpp"

namespace limpet {
namespace {

/// A plan that lacks so much more useful track than when it was sought is sought anew [m].
constexpr double kStaleTrack = 3.0;
/// One that lacked more than that from the first may find another way by now: not at each decision,
/// for seeking anew takes ten times as long, and the longer the plan the longer, but after a way of
/// this share of it.
constexpr double kSeekAgain = 0.1;
/// Share by which the swath may change before a plan is sought anew.
constexpr double kOtherSwath = 0.03;
/// A plan whose looks are worth so much less of what they might be than the last one's is sought
/// anew [m].
constexpr double kLostLooks = 50.0;
/// Length of a plan's beginning that stands against what others offer [m].
constexpr double kOwnPart = 25.0;
/// Plans begin otherwise if they are at least so far apart at the end of that beginning.
constexpr double kApart = 6.0;  // [m]
/// How many plans that begin otherwise are offered.
constexpr std::size_t kOthers = 4;
/// How many of those that were sought beside a new plan are offered.
constexpr std::size_t kRivals = 2;
/// How many of the others' options are completed with care.
constexpr std::size_t kBest = 4;

constexpr const char* kPrevious = "previous";  ///< source of the rest of the path in force

bool IsSamePath(const DubinsPath& a, const DubinsPath& b) {
  return a.length() == b.length() && a.segments().size() == b.segments().size() &&
         Distance(a.end(), b.end()) == 0.0;
}

struct CostedTour {
  SurveyTour tour;
  double cost = 0.0;
};

/// The tour's first passes: as many as are flown, at most, before plans are compared by where they
/// lead.
SurveyTour Beginning(const SurveyTour& tour) {
  constexpr std::size_t kPasses = 4;
  return {tour.begin(), tour.begin() + static_cast<std::ptrdiff_t>(std::min(kPasses, tour.size()))};
}

/// The tour with each of its passes first, either way round.
std::vector<SurveyTour> BegunWithEachPass(const SurveyTour& tour) {
  std::vector<SurveyTour> begun;
  for (std::size_t i = 0; i < tour.size(); ++i) {
    for (const Pass& first : {tour[i], tour[i].Reversed()}) {
      SurveyTour other{first};
      std::ranges::copy_n(tour.begin(), static_cast<std::ptrdiff_t>(i), std::back_inserter(other));
      std::copy(tour.begin() + static_cast<std::ptrdiff_t>(i) + 1, tour.end(),
                std::back_inserter(other));
      begun.push_back(std::move(other));
    }
  }
  return begun;
}

/// Leaves out, one after the other, the passes without which the tour costs less.
void DropIdlePasses(TourJudge& judge, SurveyTour& tour) {
  double least = judge.Cost(tour).total;
  tour.resize(std::min(tour.size(), judge.passes_needed()));
  for (std::size_t i = tour.size(); i-- > 0;) {
    SurveyTour trial = tour;
    trial.erase(trial.begin() + static_cast<std::ptrdiff_t>(i));
    const double cost = judge.Cost(trial).total;
    if (cost < least) {
      least = cost;
      tour = std::move(trial);
    }
  }
}

}  // namespace

bool MissionPlan::IsTheSameSurvey() const {
  const GridFrame& frame = now_.ground->frame();
  return frame.north_min == frame_.north_min && frame.east_min == frame_.east_min &&
         frame.rows == frame_.rows && frame.columns == frame_.columns &&
         now_.ground->cells_of_area() == cells_of_area_;
}

bool MissionPlan::IsInTheWay() const {
  if (now_.region->obstacle_mark() == obstacle_mark_) return false;
  const auto is_inside = [this](const Pass& pass) { return IsInside(pass, *now_.region); };
  return !std::ranges::all_of(plan_, is_inside) || !std::ranges::all_of(chosen_.passes, is_inside);
}

SurveyTour MissionPlan::Rest() const {
  return chosen_.passes.empty() ? plan_ : RestAfter(chosen_, SinceChoice());
}

void MissionPlan::Offer(const Task& now, const char* source, std::vector<Option>& options) {
  now_ = now;
  source_ = source;
  completed_.clear();
  if (!IsTheSameSurvey() || IsInTheWay()) {
    plan_.clear();
    chosen_ = {};
    frame_ = now.ground->frame();
    cells_of_area_ = now.ground->cells_of_area();
  }
  obstacle_mark_ = now.region->obstacle_mark();
  TourJudge judge(*now.ground, *now.region, now.turn_radius);
  judge.Reset(DubinsPath(now.pose), now.goal);
  is_planned_ = !judge.is_finished();
  if (!is_planned_) return;
  Renew(judge);
  OfferPlan(judge, plan_, options);
  is_planned_ = !completed_.empty();
  if (!is_planned_) return;
  OfferRest(judge, options);
  OfferRivals(judge, options);
  if (params_.first_edits > 0) OfferOtherBeginnings(judge, options);
}

FlownTour MissionPlan::FromHere(const SurveyTour& tour) const {
  return Fly(DubinsPath(now_.pose), tour, *now_.region, now_.turn_radius);
}

/// Of what is flown: where passes cannot be reached, or only by a way around, the tour shows other
/// ground than its passes and the words between them do.
TourCost MissionPlan::CostOf(TourJudge& judge, const DubinsPath& path) const {
  judge.Reset(path, now_.goal);
  return judge.Cost({});
}

void MissionPlan::OfferPlan(TourJudge& judge, const SurveyTour& plan,
                            std::vector<Option>& options) {
  FlownTour flown = FromHere(plan);
  if (flown.passes.empty()) return;
  const TourCost cost = CostOf(judge, flown.path);
  const double length = flown.path.length();
  options.push_back({.source = source_,
                     .path = flown.path,
                     .estimate = -length,
                     .own_m = std::min(kOwnPart, length),
                     .lacking_m = cost.lacking,
                     .most_m = cost.most});
  completed_.push_back(std::move(flown));
}

/// Offers rivals of a new plan: those that lead elsewhere and were sought with as much care.
void MissionPlan::OfferRivals(TourJudge& judge, std::vector<Option>& options) {
  std::size_t offered = 0;
  for (SurveyTour& rival : rivals_) {
    if (offered == kRivals) break;
    if (!BeginsOtherwise(FromHere(rival))) continue;
    judge.Reset(DubinsPath(now_.pose), now_.goal);
    Improve(judge, rival, params_.first_edits / 4);
    OfferPlan(judge, rival, options);
    ++offered;
  }
  rivals_.clear();
}

/// Another pass first, and the rest of the plan behind it: what it costs to go elsewhere now.
void MissionPlan::OfferOtherBeginnings(TourJudge& judge, std::vector<Option>& options) {
  judge.Reset(DubinsPath(now_.pose), now_.goal);
  std::vector<CostedTour> begun;
  for (const SurveyTour& tour : BegunWithEachPass(plan_)) {
    begun.push_back({.tour = tour, .cost = judge.Cost(tour).total});
  }
  std::ranges::stable_sort(begun, {}, &CostedTour::cost);
  std::size_t offered = 0;
  for (const CostedTour& other : begun) {
    const SurveyTour first{other.tour.front()};
    const FlownTour way = FromHere(first);
    if (!way.is_complete || !BeginsOtherwise(FromHere(Beginning(other.tour)))) continue;
    SurveyTour rest(other.tour.begin() + 1, other.tour.end());
    judge.Reset(way.path, now_.goal);
    Improve(judge, rest, params_.rest_edits);
    rest.insert(rest.begin(), first.front());
    OfferPlan(judge, rest, options);
    if (++offered == kOthers) return;
  }
}

void MissionPlan::Improve(TourJudge& judge, SurveyTour& tour, int edits) {
  if (!tour.empty()) search_.Improve(judge, tour, edits);
}

/// True if the tour begins otherwise than all those offered so far.
bool MissionPlan::BeginsOtherwise(const FlownTour& tour) const {
  const auto place = [](const FlownTour& of) {
    return of.path.At(std::min(kOwnPart, of.path.length()));
  };
  return std::ranges::none_of(completed_, [&](const FlownTour& offered) {
    return Distance(place(offered), place(tour)) < kApart;
  });
}

void MissionPlan::Renew(TourJudge& judge) {
  plan_ = Rest();
  TourCost cost = judge.Cost(plan_);
  if (cost.detours > 0.0) {  // the region's allowance has grown, and turns no longer fit
    SurveyTour fitted = FittedInside(plan_, judge.region(), judge.turn_radius());
    const TourCost cost_fitted = judge.Cost(fitted);
    if (cost_fitted.total < cost.total) plan_ = std::move(fitted), cost = cost_fitted;
  }
  lacking_when_sought_ = std::min(lacking_when_sought_, cost.missing);
  if (plan_.empty() || IsStale(cost.missing) || SeesOtherwise()) {
    Replan(judge);
  } else if (params_.first_edits > 0) {
    search_.Improve(judge, plan_, params_.edits);
    if (LeftOutBy(plan_) > left_out_m_ + kLostLooks) Replan(judge);
  }
  left_out_m_ = LeftOutBy(plan_);
  static_cast<void>(judge.Cost(plan_));
  plan_.resize(std::min(plan_.size(), judge.passes_needed()));
}

/// Lanes, lanes behind looks at the targets, and the plan as it is and behind such looks.
std::vector<SurveyTour> MissionPlan::Seeds(TourJudge& judge) const {
  std::vector<SurveyTour> seeds = LaneTours(judge, params_.lanes);
  const SurveyTour looks =
      TargetPasses(judge.start(), judge.region(), judge.goal().others, judge.turn_radius());
  const auto count = static_cast<std::size_t>(params_.seeds);
  if (!looks.empty()) {
    seeds.resize(std::min(seeds.size(), count / 2));
    std::ranges::move(LaneTours(judge, params_.lanes, looks), std::back_inserter(seeds));
  }
  seeds.resize(std::min(seeds.size(), count));
  if (plan_.empty()) return seeds;
  seeds.push_back(plan_);
  if (!looks.empty() && params_.first_edits > 0) {
    SurveyTour behind_looks = looks;
    std::ranges::copy(plan_, std::back_inserter(behind_looks));
    DropIdlePasses(judge, behind_looks);
    seeds.push_back(std::move(behind_looks));
  }
  return seeds;
}

bool MissionPlan::IsStale(double lacking) const {
  if (lacking <= kStaleTrack) return false;
  return lacking > lacking_when_sought_ + kStaleTrack ||
         now_.travelled - sought_at_ > kSeekAgain * FromHere(plan_).path.length();
}

/// Whether the water shows so much more or less than it was planned for: lanes would lie otherwise.
bool MissionPlan::SeesOtherwise() const {
  return std::abs(now_.ground->swath() / planned_swath_ - 1.0) > kOtherSwath;
}

double MissionPlan::LeftOutBy(const SurveyTour& tour) const {
  const Objective& others = now_.goal.others;
  if (others.targets.empty()) return 0.0;
  double left_out = -TargetValueOf(FromHere(tour).path, others);
  for (const Target& target : others.targets)
    left_out += target.value;
  return now_.goal.others_weight * left_out;
}

void MissionPlan::Replan(TourJudge& judge) {
  planned_swath_ = now_.ground->swath();
  std::vector<SurveyTour> seeds = Seeds(judge);
  const int edits = params_.first_edits / 2;
  std::vector<CostedTour> found;
  for (SurveyTour& seed : seeds) {
    const int share = edits / static_cast<int>(seeds.size());
    const double cost = search_.Improve(judge, seed, share).total;
    found.push_back({.tour = std::move(seed), .cost = cost});
  }
  if (found.empty()) return;
  std::ranges::stable_sort(found, {}, &CostedTour::cost);
  plan_ = found.front().tour;
  lacking_when_sought_ = search_.Improve(judge, plan_, edits).missing;
  sought_at_ = now_.travelled;
  for (auto rival = found.begin() + 1; params_.first_edits > 0 && rival != found.end(); ++rival) {
    rivals_.push_back(std::move(rival->tour));
  }
}

void MissionPlan::OfferRest(TourJudge& judge, std::vector<Option>& options) {
  if (chosen_.passes.empty()) return;
  const double flown = SinceChoice();
  DubinsPath path = chosen_.path.Rest(flown);
  if (!IsOnPath(path, now_.pose) || path.length() <= 0.0) return;
  FlownTour rest{.path = path, .passes = RestAfter(chosen_, flown), .spans = {}};
  for (std::size_t i = chosen_.spans.size() - rest.passes.size(); i < chosen_.spans.size(); ++i) {
    rest.spans.push_back(
        {std::max(0.0, chosen_.spans[i].low - flown), chosen_.spans[i].high - flown});
  }
  const double length = path.length();
  const TourCost cost = CostOf(judge, path);
  options.push_back({.source = kPrevious,
                     .path = path,
                     .estimate = -length,
                     .own_m = std::min(kOwnPart, length),
                     .lacking_m = cost.lacking,
                     .most_m = cost.most});
  completed_.push_back(std::move(rest));
}

/// An option with what would follow it.
struct MissionPlan::Completion {
  Option* option = nullptr;
  SurveyTour tour;
  double cost = 0.0;  ///< before it is improved [m]
};

void MissionPlan::Complete(std::vector<Option>& options) {
  if (!is_planned_) return;
  TourJudge judge(*now_.ground, *now_.region, now_.turn_radius);
  std::vector<Completion> completions;
  for (Option& option : options) {
    if (!option.is_whole() && option.views.empty() && !MayEndAnywhere(option) &&
        now_.region->Contains(option.path)) {
      completions.push_back(CompletionOf(judge, option));
    }
  }
  std::ranges::stable_sort(completions, {}, &Completion::cost);
  for (std::size_t i = 0; i < completions.size(); ++i) {
    Complete(judge, completions[i], i < kBest);
  }
}

MissionPlan::Completion MissionPlan::CompletionOf(TourJudge& judge, Option& option) const {
  judge.Reset(option.path, now_.goal);
  Completion completion{.option = &option, .tour = {}};
  if (!judge.is_finished()) {
    completion.tour = plan_;
    DropIdlePasses(judge, completion.tour);
  }
  completion.cost = judge.Cost(completion.tour).total;
  return completion;
}

void MissionPlan::Complete(TourJudge& judge, Completion& completion, bool is_among_the_best) {
  Option& option = *completion.option;
  if (is_among_the_best && params_.first_edits > 0) {
    judge.Reset(option.path, now_.goal);
    Improve(judge, completion.tour, params_.rest_edits);
  }
  FlownTour flown = FlyAsPasses(option.path, completion.tour, *now_.region, now_.turn_radius);
  const TourCost cost = CostOf(judge, flown.path);
  option.own_m = option.path.length();
  option.path = flown.path;
  option.lacking_m = cost.lacking;
  option.most_m = cost.most;
  completed_.push_back(std::move(flown));
}

void MissionPlan::OnChoice(const Option& option) {
  const auto found = std::ranges::find_if(completed_, [&option](const FlownTour& completed) {
    return IsSamePath(completed.path, option.path);
  });
  chosen_ = found != completed_.end() ? *found : FlownTour{};
  chosen_at_ = now_.travelled;
  completed_.clear();
}

}  // namespace limpet

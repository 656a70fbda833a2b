// SPDX-License-Identifier: MIT
#include "limpet/planning/mission_plan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "limpet/planning/home_path.hpp"

namespace limpet {
namespace {

/// A plan that lacks more useful track than this is sought anew.
constexpr double kStaleTrack = 3.0;
/// So much of a plan stands against what others offer [m].
constexpr double kOwnPart = 25.0;
/// The vehicle is where the path has it.
constexpr double kOnPath_m = 0.05;
constexpr double kOnPath_rad = 0.02;

constexpr const char* kPrevious = "previous";  ///< source of the rest of the path in force

bool IsSamePath(const DubinsPath& a, const DubinsPath& b) {
  return a.length() == b.length() && a.segments().size() == b.segments().size() &&
         Distance(a.end(), b.end()) == 0.0;
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
         now_.ground->wanted_cells() == wanted_cells_;
}

SurveyTour MissionPlan::Rest() const {
  return chosen_.passes.empty() ? plan_ : RestAfter(chosen_, SinceChoice());
}

void MissionPlan::Offer(const Task& now, const char* source, std::vector<Option>& options) {
  now_ = now;
  source_ = source;
  completed_.clear();
  if (!IsTheSameSurvey()) {
    plan_.clear();
    chosen_ = {};
    frame_ = now.ground->frame();
    wanted_cells_ = now.ground->wanted_cells();
  }
  TourJudge judge(*now.ground, *now.region, now.turn_radius);
  judge.Reset(DubinsPath(now.pose), now.goal);
  is_planned_ = !judge.is_finished();
  if (!is_planned_) return;
  Renew(judge);
  FlownTour flown = Fly(DubinsPath(now.pose), plan_, *now.region, now.turn_radius);
  is_planned_ = !flown.passes.empty();
  if (!is_planned_) return;
  const double length = flown.path.length();
  options.push_back({.source = source,
                     .path = flown.path,
                     .estimate = -length,
                     .own_m = std::min(kOwnPart, length)});
  completed_.push_back(std::move(flown));
  OfferRest(options);
}

void MissionPlan::Renew(TourJudge& judge) {
  plan_ = Rest();
  const TourCost cost = judge.Cost(plan_);
  if (plan_.empty() || has_left_plan_ || cost.missing > kStaleTrack) {
    Replan(judge);
  } else if (params_.first_edits > 0) {
    search_.Improve(judge, plan_, params_.edits);
  }
  static_cast<void>(judge.Cost(plan_));
  plan_.resize(std::min(plan_.size(), judge.passes_needed()));
}

void MissionPlan::Replan(TourJudge& judge) {
  std::vector<SurveyTour> seeds = LaneTours(judge, params_.lanes);
  seeds.resize(std::min<std::size_t>(seeds.size(), static_cast<std::size_t>(params_.seeds)));
  if (!plan_.empty()) seeds.push_back(plan_);
  const int edits = params_.first_edits / 2;
  double least = std::numeric_limits<double>::infinity();
  for (SurveyTour& seed : seeds) {
    const int share = edits / static_cast<int>(seeds.size());
    const double cost = search_.Improve(judge, seed, share).total;
    if (cost < least) {
      least = cost;
      plan_ = seed;
    }
  }
  search_.Improve(judge, plan_, edits);
}

void MissionPlan::OfferRest(std::vector<Option>& options) {
  if (chosen_.passes.empty()) return;
  const double flown = SinceChoice();
  DubinsPath path = chosen_.path.Rest(flown);
  const bool is_on_it = Distance(path.start(), now_.pose) < kOnPath_m &&
                        std::abs(std::remainder(path.start().yaw - now_.pose.yaw,
                                                2.0 * std::numbers::pi)) < kOnPath_rad;
  if (!is_on_it || path.length() <= 0.0) return;
  FlownTour rest{.path = path, .passes = RestAfter(chosen_, flown), .spans = {}};
  for (std::size_t i = chosen_.spans.size() - rest.passes.size(); i < chosen_.spans.size(); ++i) {
    rest.spans.push_back(
        {std::max(0.0, chosen_.spans[i].low - flown), chosen_.spans[i].high - flown});
  }
  const double length = path.length();
  options.push_back({.source = kPrevious,
                     .path = path,
                     .estimate = -length,
                     .own_m = std::min(kOwnPart, length)});
  completed_.push_back(std::move(rest));
}

void MissionPlan::Complete(std::vector<Option>& options) {
  if (!is_planned_) return;
  TourJudge judge(*now_.ground, *now_.region, now_.turn_radius);
  for (Option& option : options) {
    if (!option.is_whole() && option.views.empty() && !MayEndAnywhere(option) &&
        now_.region->Contains(option.path)) {
      Complete(judge, option);
    }
  }
}

void MissionPlan::Complete(TourJudge& judge, Option& option) {
  judge.Reset(option.path, now_.goal);
  SurveyTour tour;
  if (!judge.is_finished()) {
    tour = plan_;
    DropIdlePasses(judge, tour);
  }
  FlownTour flown = Fly(option.path, tour, *now_.region, now_.turn_radius);
  option.own_m = option.path.length();
  option.path = flown.path;
  completed_.push_back(std::move(flown));
}

void MissionPlan::OnChoice(const Option& option) {
  const auto found = std::ranges::find_if(completed_, [&option](const FlownTour& completed) {
    return IsSamePath(completed.path, option.path);
  });
  chosen_ = found != completed_.end() ? *found : FlownTour{};
  chosen_at_ = now_.travelled;
  has_left_plan_ = option.source != source_ && option.source != kPrevious;
  completed_.clear();
}

}  // namespace limpet

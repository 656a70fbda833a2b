// SPDX-License-Identifier: MIT
#include "limpet/planning/tour_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace limpet {
namespace {

constexpr double kShift = 0.7;         ///< sigma of a shift to the side [m]
constexpr double kStretch = 2.0;       ///< sigma of what an end is moved by [m]
constexpr double kTurned = 0.15;       ///< sigma of what a pass is turned by [rad]
constexpr double kNewPass = 6.0;       ///< longest pass that is added [m]
constexpr double kLookAside = 0.7;     ///< share of a look's window that a pass is beside a target
constexpr double kParallelSine = 0.2;  ///< sine of the angle up to which passes are parallel
constexpr double kCoolest = 0.03;      ///< share of the warmth that is left at the end

/// Moves the begin of a pass along it by `by` [m], its end by `end_by`.
Pass Stretched(const Pass& pass, double by, double end_by) {
  const double length = pass.length - by + end_by;
  if (length < 0.0) return pass;
  return {.in = Advance(pass.in, {.curvature = 0.0, .length = by}), .length = length};
}

Pass TurnedBy(const Pass& pass, double angle) {
  Pose2 middle = Advance(pass.in, {.curvature = 0.0, .length = 0.5 * pass.length});
  middle.yaw += angle;
  return {.in = Advance(middle, {.curvature = 0.0, .length = -0.5 * pass.length}),
          .length = pass.length};
}

/// No pass leaves the region, and from the last one the vehicle can go on.
bool IsFlyable(const SurveyTour& tour, const TourJudge& judge) {
  const auto is_inside = [&judge](const Pass& pass) { return IsInside(pass, judge.region()); };
  return std::ranges::all_of(tour, is_inside) &&
         judge.region().IsRecoverable(tour.back().out(), judge.turn_radius());
}

}  // namespace

TourCost TourSearch::Improve(TourJudge& judge, SurveyTour& tour, int edits) {
  SurveyTour now = tour;
  TourCost best = judge.Cost(tour);
  double now_total = best.total;
  for (int edit = 0; edit < edits; ++edit) {
    const double heat = warmth_m_ * std::pow(kCoolest, static_cast<double>(edit) / edits);
    SurveyTour trial = Edited(judge, now);
    if (trial.empty() || !IsFlyable(trial, judge)) continue;
    const TourCost cost = judge.Cost(trial);
    const double worse = cost.total - now_total;
    if (worse > 0.0 && random_.Uniform(0.0, 1.0) >= std::exp(-worse / heat)) continue;
    trial.resize(judge.passes_needed());
    now = std::move(trial);
    now_total = cost.total;
    if (cost.total < best.total) {
      best = cost;
      tour = now;
    }
  }
  return best;
}

SurveyTour TourSearch::Edited(const TourJudge& judge, const SurveyTour& tour) {
  SurveyTour edited = tour;
  using Edit = void (TourSearch::*)(SurveyTour&);
  static constexpr std::array<Edit, 10> kEdits{&TourSearch::ShiftOne,    &TourSearch::ShiftOne,
                                               &TourSearch::ShiftBeside, &TourSearch::StretchOne,
                                               &TourSearch::StretchOne,  &TourSearch::TurnOne,
                                               &TourSearch::FlipOne,     &TourSearch::MoveOne,
                                               &TourSearch::ReverseRun,  &TourSearch::DropOne};
  // Targets move in the map, and slip out of passes that were meant for them.
  const std::size_t added = judge.goal().others.targets.empty() ? 1 : 2;
  const auto kind = static_cast<std::size_t>(random_.Index(kEdits.size() + added));
  if (kind > kEdits.size()) {
    AddLook(judge, edited);
  } else if (edited.empty() || kind == kEdits.size()) {
    AddOne(judge, edited);
  } else {
    (this->*kEdits[kind])(edited);
  }
  return edited;
}

void TourSearch::ShiftOne(SurveyTour& tour) {
  Pose2& in = tour[Any(tour)].in;
  const double by = random_.Normal(kShift);
  in.north -= by * std::sin(in.yaw);
  in.east += by * std::cos(in.yaw);
}

/// One pass and all that are about parallel to it on one side: closes a gap, or opens one.
void TourSearch::ShiftBeside(SurveyTour& tour) {
  const Pose2 at = tour[Any(tour)].in;
  const double side = random_.Chance(0.5) ? 1.0 : -1.0;
  const double by = random_.Normal(kShift);
  const double sin = std::sin(at.yaw), cos = std::cos(at.yaw);
  for (Pass& pass : tour) {
    Pose2& in = pass.in;
    const double across = -(in.north - at.north) * sin + (in.east - at.east) * cos;
    if (side * across < 0.0 || std::abs(std::sin(in.yaw - at.yaw)) > kParallelSine) continue;
    in.north -= by * sin;
    in.east += by * cos;
  }
}

void TourSearch::StretchOne(SurveyTour& tour) {
  Pass& pass = tour[Any(tour)];
  const bool is_begin = random_.Chance(0.5);
  const double by = random_.Normal(kStretch);
  pass = Stretched(pass, is_begin ? by : 0.0, is_begin ? 0.0 : by);
}

void TourSearch::TurnOne(SurveyTour& tour) {
  Pass& pass = tour[Any(tour)];
  pass = TurnedBy(pass, random_.Normal(kTurned));
}

void TourSearch::FlipOne(SurveyTour& tour) {
  Pass& pass = tour[Any(tour)];
  pass = pass.Reversed();
}

void TourSearch::MoveOne(SurveyTour& tour) {
  const std::size_t from = Any(tour);
  const Pass pass = random_.Chance(0.5) ? tour[from] : tour[from].Reversed();
  tour.erase(tour.begin() + static_cast<std::ptrdiff_t>(from));
  const auto to = static_cast<std::ptrdiff_t>(random_.Index(tour.size() + 1));
  tour.insert(tour.begin() + to, pass);
}

void TourSearch::ReverseRun(SurveyTour& tour) {
  std::size_t first = Any(tour), last = Any(tour);
  if (first > last) std::swap(first, last);
  std::reverse(tour.begin() + static_cast<std::ptrdiff_t>(first),
               tour.begin() + static_cast<std::ptrdiff_t>(last) + 1);
  for (std::size_t i = first; i <= last; ++i)
    tour[i] = tour[i].Reversed();
}

void TourSearch::DropOne(SurveyTour& tour) {
  tour.erase(tour.begin() + static_cast<std::ptrdiff_t>(Any(tour)));
}

void TourSearch::AddOne(const TourJudge& judge, SurveyTour& tour) {
  const SeenPlanes& planes = judge.planes();
  const int unseen = planes.unseen()[SeenPlanes::kTop];
  if (unseen == 0) return;
  const auto any = static_cast<int>(random_.Index(static_cast<std::uint64_t>(unseen)));
  const PlanePoint cell = planes.NthUnseen(SeenPlanes::kTop, any);
  const double yaw = random_.Uniform(-std::numbers::pi, std::numbers::pi);
  const double half = judge.ground().footprint().half_across(Footprint::kLayers - 1);
  const double aside = random_.Uniform(-half, half);
  const Pose2 at{cell.x() - aside * std::sin(yaw), cell.y() + aside * std::cos(yaw), yaw};
  const double length = random_.Uniform(0.0, kNewPass);
  const auto to = static_cast<std::ptrdiff_t>(random_.Index(tour.size() + 1));
  tour.insert(tour.begin() + to,
              {.in = Advance(at, {.curvature = 0.0, .length = -0.5 * length}), .length = length});
}

/// Straight on from the pass before it, or on any course.
void TourSearch::AddLook(const TourJudge& judge, SurveyTour& tour) {
  const std::vector<Target>& targets = judge.goal().others.targets;
  const Target& target = targets[static_cast<std::size_t>(random_.Index(targets.size()))];
  const double share = random_.Uniform(0.0, 1.0);  // looks are worth less the later they come
  const auto to = static_cast<std::size_t>(share * share * static_cast<double>(tour.size() + 1));
  const Pose2 from = to == 0 ? judge.start() : tour[to - 1].out();
  const double straight = std::atan2(target.east - from.east, target.north - from.north);
  const double any = random_.Uniform(-std::numbers::pi, std::numbers::pi);
  const double yaw = random_.Chance(0.5) ? straight : any;
  const double aside = kLookAside * target.window.half_across * random_.Uniform(-1.0, 1.0);
  const Pose2 at{target.north - aside * std::sin(yaw), target.east + aside * std::cos(yaw), yaw};
  tour.insert(tour.begin() + static_cast<std::ptrdiff_t>(to), {.in = at, .length = 0.0});
}

}  // namespace limpet

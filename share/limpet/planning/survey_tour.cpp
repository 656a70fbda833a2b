// SPDX-License-Identifier: MIT
#include "limpet/planning/survey_tour.hpp"

#include <algorithm>
#include <cmath>

#include "limpet/planning/current_toll.hpp"

namespace limpet {
namespace {

/// Way for a metre of useful track that a tour lacks: more than it takes to fetch it, so that tours
/// finish where they can.
constexpr double kFetchPrice = 12.0;
/// And for lacking any: little, or a survey goes back across the area for the last square metre.
constexpr double kUnfinishedPrice = 6.0;

/// Share of a piece after which only `left` cells are unseen, of which there are `before` at its
/// start and `after` at its end; all of it where more are.
double ShareUntil(int left, int before, int after) {
  if (after > left) return 1.0;
  return static_cast<double>(before - left) / std::max(1, before - after);
}

/// The objective without its ground, which the judge counts itself.
Objective WithoutGround(const Objective& objective) {
  Objective others = objective;
  others.ground = {};
  return others;
}

}  // namespace

TourJudge::TourJudge(const Ground& ground, const Region& region, Meters turn_radius)
    : ground_(ground),
      region_(region),
      turn_radius_(turn_radius),
      links_(region, turn_radius),
      planes_(ground),
      sweeps_(ground),
      cell_m2_(ground.frame().cell_m * ground.frame().cell_m),
      wanted_cells_(static_cast<double>(ground.wanted_cells())) {}

void TourJudge::Reset(const DubinsPath& way, const TourGoal& goal) {
  goal_ = goal;
  planes_.Reset(ground_);
  sweeps_.Reset(ground_);
  may_stay_ = static_cast<int>((1.0 - goal.finish_share) * wanted_cells_);
  most_may_stay_[SeenPlanes::kTop] = static_cast<int>((1.0 - kMostOfTop) * wanted_cells_);
  most_may_stay_[SeenPlanes::kBottom] = static_cast<int>((1.0 - kMostOfBottom) * wanted_cells_);
  others_.reset();
  if (!goal.others.targets.empty() || !goal.others.terms.empty()) {
    others_.emplace(WithoutGround(goal.others), ground_, way.start(), goal.others.target_decay_m);
  }
  stages_.clear();
  base_ = Stage{};
  base_.end = way.start();
  planes_.Look(way.start());
  base_.is_finished = planes_.unseen()[SeenPlanes::kTop] <= may_stay_;
  for (const PathSegment& segment : way.segments()) {
    if (!base_.is_finished) base_.is_finished = Fly(base_.end, segment, base_.cost);
    base_.end = Advance(base_.end, segment);
  }
  base_.seen = planes_.Mark();
  base_.others_mark = others_ ? others_->Mark() : 0;
}

TourCost TourJudge::Cost(const SurveyTour& tour) {
  Stage stage = Rejoin(tour);
  while (!stage.is_finished && stages_.size() < tour.size()) {
    FlyPass(tour[stages_.size()], stage);
    stage.seen = planes_.Mark();
    stage.others_mark = others_ ? others_->Mark() : 0;
    stages_.push_back(stage);
  }
  TourCost cost = stage.cost;
  const PlanePoint homeward(goal_.home_W.x() - stage.end.north, goal_.home_W.y() - stage.end.east);
  cost.home = std::hypot(homeward.x(), homeward.y());
  cost.toll += CurrentToll(goal_.course_cost, {.yaw = std::atan2(homeward.y(), homeward.x())},
                           {.curvature = 0.0, .length = cost.home});
  cost.missing = TrackOf(planes_.unseen()[SeenPlanes::kTop] - may_stay_, SeenPlanes::kTop);
  cost.most += MostToCome();
  cost.lacking = kFetchPrice * cost.missing + (cost.missing > 0.0 ? kUnfinishedPrice : 0.0);
  cost.total = cost.length + cost.home + cost.toll + goal_.early_weight * cost.lateness +
               goal_.most_weight * cost.most - cost.others + cost.lacking + cost.detours;
  return cost;
}

double TourJudge::TrackOf(int left, std::size_t plane) const {
  const double swath = 2.0 * ground_.footprint().half_across(SeenPlanes::kLayerOf.at(plane));
  return std::max(0, left) * cell_m2_ / std::max(0.1, swath);
}

double TourJudge::MostToCome() const {
  const auto track = [this](std::size_t plane) {
    return TrackOf(planes_.unseen()[plane] - most_may_stay_[plane], plane);
  };
  const double bottom_weight = ground_.weights()[0];
  return kFetchPrice * (bottom_weight * track(SeenPlanes::kBottom) +
                        (1.0 - bottom_weight) * track(SeenPlanes::kTop));
}

TourJudge::Stage TourJudge::Rejoin(const SurveyTour& tour) {
  std::size_t shared = 0;
  while (shared < std::min(tour.size(), stages_.size()) && tour[shared] == stages_[shared].pass) {
    ++shared;
  }
  stages_.resize(shared);
  const Stage& stage = shared > 0 ? stages_.back() : base_;
  planes_.Rewind(stage.seen);
  if (others_) others_->Rewind(stage.others_mark);
  return stage;
}

void TourJudge::FlyPass(const Pass& pass, Stage& stage) {
  stage.pass = pass;
  const PassLink& link = Link(stage.end, pass.in);
  stage.cost.detours += link.Price() - link.word.length;
  for (const PathSegment& segment : link.word.segments) {
    if (segment.length <= 0.0 || stage.is_finished) continue;
    stage.is_finished = Fly(stage.end, segment, stage.cost);
    stage.end = Advance(stage.end, segment);
  }
  if (stage.is_finished) return;
  stage.end = pass.in;
  stage.is_finished = Fly(stage.end, {.curvature = 0.0, .length = pass.length}, stage.cost);
  stage.end = pass.out();
}

bool TourJudge::Fly(const Pose2& from, const PathSegment& segment, TourCost& cost) {
  const SweptMotion& motion = sweeps_.Of(from, segment);
  for (std::size_t i = 0; i < motion.pieces.size(); ++i) {
    if (FlyPiece(motion, i, cost)) return true;
  }
  return false;
}

bool TourJudge::FlyPiece(const SweptMotion& motion, std::size_t i, TourCost& cost) {
  const auto& [from, piece, shown_end] = motion.pieces[i];
  const SeenPlanes::Counts before = planes_.unseen();
  for (std::size_t plane = 0; plane < SeenPlanes::kPlanes; ++plane) {
    planes_.See(plane, motion.ShownBy(i, plane));
  }
  const SeenPlanes::Counts& after = planes_.unseen();
  const double middle = cost.length + 0.5 * piece.length;
  const double bottom_weight = ground_.weights()[0];
  const double newly_seen =
      bottom_weight * (before[SeenPlanes::kBottom] - after[SeenPlanes::kBottom]) +
      (1.0 - bottom_weight) * (before[SeenPlanes::kTop] - after[SeenPlanes::kTop]);
  cost.lateness += newly_seen * middle / wanted_cells_;
  if (others_ && cost.length < goal_.others.target_decay_m) {
    cost.others += goal_.others_weight *
                   others_->Worth({.from = from, .motion = piece, .before = cost.length});
  }
  const std::size_t top = SeenPlanes::kTop;
  NoteMost(before, piece.length, cost);
  const bool is_finished = after[top] <= may_stay_;
  const double flown = is_finished ? ShareUntil(may_stay_, before[top], after[top]) : 1.0;
  cost.length += flown * piece.length;
  cost.toll += flown * CurrentToll(goal_.course_cost, from, piece);
  return is_finished;
}

void TourJudge::NoteMost(const SeenPlanes::Counts& before, double piece, TourCost& cost) const {
  const double bottom_weight = ground_.weights()[0];
  const auto note = [&](std::size_t plane, double weight) {
    if (before[plane] <= most_may_stay_[plane]) return;
    cost.most +=
        weight * piece * ShareUntil(most_may_stay_[plane], before[plane], planes_.unseen()[plane]);
  };
  note(SeenPlanes::kBottom, bottom_weight);
  note(SeenPlanes::kTop, 1.0 - bottom_weight);
}

}  // namespace limpet

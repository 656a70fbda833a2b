// SPDX-License-Identifier: MIT
#include "limpet/planning/path_valuer.hpp"

#include <cmath>
#include <utility>

namespace limpet {
namespace {

/// New ground and the border it leaves.
class GroundTerm final : public SearchTerm {
 public:
  GroundTerm(const GroundRates& rates, double swath) : rates_(rates), swath_(swath) {}
  [[nodiscard]] double Worth(const PathStep& step, TermEvents&) const override {
    const GroundWorth worth = rates_.Of(step.seen, swath_);
    return worth.useful - worth.ragged;
  }

 private:
  GroundRates rates_;
  double swath_;
};

/// First looks at targets, earlier ones more.
class TargetTerm final : public SearchTerm {
 public:
  TargetTerm(std::vector<Target> targets, double decay_m)
      : targets_(std::move(targets)), decay_m_(decay_m) {}
  [[nodiscard]] std::size_t event_count() const override { return targets_.size(); }
  [[nodiscard]] double Worth(const PathStep& step, TermEvents& events) const override {
    double worth = 0.0;
    for (std::size_t i = 0; i < targets_.size(); ++i) {
      if (!events.Has(i)) {
        worth += WorthOf(i, step, events);
      }
    }
    return worth;
  }

 private:
  double WorthOf(std::size_t i, const PathStep& step, TermEvents& events) const {
    double worth = 0.0;
    step.Sample([&](const Pose2& pose, double s) {
      if (!events.Has(i) && targets_[i].IsSeenFrom(pose)) {
        events.Add(i);
        worth = targets_[i].WorthAt(s, Meters(decay_m_));
      }
    });
    return worth;
  }

  std::vector<Target> targets_;
  double decay_m_;
};

std::vector<Target> InReach(const std::vector<Target>& targets, const Pose2& start, double reach) {
  std::vector<Target> near;
  for (const Target& target : targets) {
    if (std::hypot(target.north - start.north, target.east - start.east) <=
        reach + target.window.half_along + target.window.half_across) {
      near.push_back(target);
    }
  }
  return near;
}

}  // namespace

PathValuer::PathValuer(const Objective& objective, const Ground& ground, const Pose2& start,
                       double reach) {
  std::size_t count = 0;
  const auto add = [&](std::shared_ptr<const SearchTerm> term) {
    const std::size_t events = term->event_count();
    entries_.push_back({.term = std::move(term), .first_event = count});
    count += events;
  };
  add(std::make_shared<GroundTerm>(objective.ground, ground.swath()));
  add(std::make_shared<TargetTerm>(InReach(objective.targets, start, reach),
                                   objective.target_decay_m));
  for (const auto& term : objective.terms) {
    add(term);
  }
  events_ = PathEvents(count);
}

double PathValuer::Worth(const PathStep& step) {
  double worth = 0.0;
  for (const Entry& entry : entries_) {
    TermEvents events(events_, entry.first_event);
    worth += entry.term->Worth(step, events);
  }
  return worth;
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
// One additive part of what a search seeks. Behaviors add their own (Behavior::Shape).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "limpet/planning/dubins_path.hpp"
#include "limpet/planning/seen_along.hpp"

namespace limpet {

/// A motion by which a search lengthens a path.
struct PathStep {
  Pose2 from;  ///< NED
  PathSegment motion;
  double before = 0.0;  ///< length of the path up to `from` [m]
  NewlySeen seen{};     ///< what the motion shows that the path up to `from` did not

  /// Calls visit(pose, s) every SeenWorkspace::kStep along the motion and at its end, not at its
  /// start, with s the length of the whole path there [m].
  template <class Visit>
  void Sample(Visit visit) const {
    for (double s = SeenWorkspace::kStep; s < motion.length - 1e-9; s += SeenWorkspace::kStep) {
      visit(Advance(from, {.curvature = motion.curvature, .length = s}), before + s);
    }
    visit(Advance(from, motion), before + motion.length);
  }
};

/// Which of the things that count once per path have happened on the path at hand, with undo.
/// Allocates nothing after construction.
class PathEvents {
 public:
  explicit PathEvents(std::size_t count) : has_happened_(count, 0) { order_.reserve(count); }

  [[nodiscard]] bool Has(std::size_t event) const { return has_happened_[event] != 0; }
  void Add(std::size_t event) {
    has_happened_[event] = 1;
    order_.push_back(static_cast<std::uint32_t>(event));
  }
  [[nodiscard]] std::size_t Mark() const { return order_.size(); }
  /// Takes back everything since `mark`.
  void Rewind(std::size_t mark) {
    for (; order_.size() > mark; order_.pop_back()) {
      has_happened_[order_.back()] = 0;
    }
  }
  [[nodiscard]] std::span<const std::uint32_t> Since(std::size_t mark) const {
    return std::span(order_).subspan(mark);
  }

 private:
  std::vector<std::uint8_t> has_happened_;
  std::vector<std::uint32_t> order_;
};

/// The events of one term among those of all.
class TermEvents {
 public:
  TermEvents(PathEvents& all, std::size_t first) : all_(all), first_(first) {}
  [[nodiscard]] bool Has(std::size_t event) const { return all_.Has(first_ + event); }
  /// REQUIRES: !Has(event).
  void Add(std::size_t event) { all_.Add(first_ + event); }

 private:
  PathEvents& all_;
  std::size_t first_;
};

/// A part of a path's worth that is a sum over its steps, in metres of path. A search asks for it
/// thousands of times per decision: it must not allocate, and must give the same for the same step
/// and events, however a path is cut into steps.
class SearchTerm {
 public:
  virtual ~SearchTerm() = default;
  /// How many things it counts once per path, e.g. first looks at places. Their marks are kept by
  /// the search, which goes back and forth between paths.
  [[nodiscard]] virtual std::size_t event_count() const { return 0; }
  /// Worth of `step` [m of path], after the events that have happened on the path before it.
  [[nodiscard]] virtual double Worth(const PathStep& step, TermEvents& events) const = 0;
};

/// Worth of a whole path by one term that does not depend on what is seen (`step.seen` is 0): so a
/// behavior bids exactly what it made the search seek.
[[nodiscard]] double WorthAlong(const DubinsPath& path, const SearchTerm& term);

}  // namespace limpet

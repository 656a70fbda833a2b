// SPDX-License-Identifier: MIT
#include "limpet/planning/seen_along.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "limpet/core/interval.hpp"

namespace limpet {

/// Cuts the image's rectangles at `at` into runs of columns, row by row: a cell is inside when its
/// centre is.
class SeenWorkspace::RowSlicer {
 public:
  RowSlicer(const GridFrame& frame, const Footprint& footprint, const Pose2& at)
      : frame_(frame), footprint_(footprint), cos_(std::cos(at.yaw)), sin_(std::sin(at.yaw)) {
    // In cells, from the centre of cell (0, 0).
    north_ = (at.north - frame.north_min) / frame.cell_m - 0.5;
    east_ = (at.east - frame.east_min) / frame.cell_m - 0.5;
    const int widest = footprint.widest_layer();
    const double reach = (std::abs(cos_) * footprint.half_along(widest) +
                          std::abs(sin_) * footprint.half_across(widest)) /
                         frame.cell_m;
    row_begin_ = std::max(0, static_cast<int>(std::ceil(north_ - reach)));
    row_end_ = std::min(frame.rows, static_cast<int>(std::floor(north_ + reach)) + 1);
    inverse_cos_ = std::abs(cos_) > kParallel ? 1.0 / cos_ : 0.0;
    inverse_sin_ = std::abs(sin_) > kParallel ? 1.0 / sin_ : 0.0;
  }

  [[nodiscard]] int row_begin() const { return row_begin_; }
  [[nodiscard]] int row_end() const { return row_end_; }

  [[nodiscard]] Span Slice(int row, int layer) const {
    const double dn = row - north_;
    Interval east{-1e9, 1e9};  // of the vehicle
    // Forward: dn cos + de sin; starboard: -dn sin + de cos.
    const double along = footprint_.half_along(layer) / frame_.cell_m;
    const double across = footprint_.half_across(layer) / frame_.cell_m;
    if (!Clip({dn * cos_, sin_, inverse_sin_}, along, east) ||
        !Clip({-dn * sin_, cos_, inverse_cos_}, across, east)) {
      return {};
    }
    const int begin = std::max(0, static_cast<int>(std::ceil(east_ + east.low)));
    const int end = std::min(frame_.columns, static_cast<int>(std::floor(east_ + east.high)) + 1);
    return begin < end ? Span{begin, end} : Span{};
  }

 private:
  static constexpr double kParallel = 1e-9;

  struct Line {
    double offset, slope;
    double inverse;  ///< 1 / slope; 0 if there is none
  };
  /// Keeps of `kept` the x with |offset + slope x| <= half; false if none is left.
  static bool Clip(const Line& line, double half, Interval& kept) {
    if (std::abs(line.slope) <= kParallel) {
      return std::abs(line.offset) <= half;
    }
    const double a = (-half - line.offset) * line.inverse;
    const double b = (half - line.offset) * line.inverse;
    kept.Cut({std::min(a, b), std::max(a, b)});
    return !kept.is_empty();
  }

  const GridFrame& frame_;
  const Footprint& footprint_;
  double cos_, sin_, inverse_cos_ = 0.0, inverse_sin_ = 0.0;
  double north_ = 0.0, east_ = 0.0;
  int row_begin_ = 0, row_end_ = 0;
};

SeenWorkspace::SeenWorkspace(const Ground& ground)
    : frame_(ground.frame()),
      footprint_(ground.footprint()),
      stride_(static_cast<std::size_t>(ground.frame().columns) + 2) {
  levels_.assign(stride_ * (static_cast<std::size_t>(frame_.rows) + 2), Footprint::kLayers);
  changes_.reserve(levels_.size() * Footprint::kLayers);
  for (std::size_t layer = 0; layer < Footprint::kLayers; ++layer) {
    worth_[layer + 1] = worth_[layer] + ground.weights()[layer];
  }
  Reset(ground);
}

void SeenWorkspace::Reset(const Ground& ground) {
  const auto columns = static_cast<std::size_t>(frame_.columns);
  for (std::size_t row = 0; row < static_cast<std::size_t>(frame_.rows); ++row) {
    std::copy_n(ground.levels().data() + row * columns, columns,
                levels_.data() + (row + 1) * stride_ + 1);
  }
  changes_.clear();
  raised_ = 0.0;
  border_ = 0.0;
}

NewlySeen SeenWorkspace::Sweep(const Pose2& from, const PathSegment& segment) {
  NewlySeen gain;
  for (double s = kStep; s < segment.length - 1e-9; s += kStep) {
    gain += Look(Advance(from, {.curvature = segment.curvature, .length = s}));
  }
  gain += Look(Advance(from, segment));
  return gain;
}

NewlySeen SeenWorkspace::Look(const Pose2& at) {
  const RowSlicer slicer(frame_, footprint_, at);
  std::array<Span, Footprint::kLayers> spans;
  for (int row = slicer.row_begin(); row < slicer.row_end(); ++row) {
    for (int layer = 0; layer < Footprint::kLayers; ++layer) {
      spans[static_cast<std::size_t>(layer)] = slicer.Slice(row, layer);
    }
    LookRow(row, spans);
  }
  return TakeGain();
}

void SeenWorkspace::LookRow(int row, const std::array<Span, Footprint::kLayers>& spans) {
  // Higher layers' runs lie inside lower ones': each cell is visited once, at its highest layer.
  // (All cells are above the layers that are out of reach already, whose runs are empty.)
  Span inner{};
  for (int layer = Footprint::kLayers - 1; layer >= 0; --layer) {
    const Span outer = spans[static_cast<std::size_t>(layer)];
    const auto level = static_cast<std::uint8_t>(layer + 1);
    if (inner.begin == inner.end) {
      RaiseSpan(row, outer, level);
      inner = outer;
    } else {
      RaiseSpan(row, {outer.begin, inner.begin}, level);
      RaiseSpan(row, {inner.end, outer.end}, level);
      inner = outer;
    }
  }
}

void SeenWorkspace::RaiseSpan(int row, Span span, std::uint8_t level) {
  const std::size_t first = (static_cast<std::size_t>(row) + 1) * stride_ + 1;
  for (int column = span.begin; column < span.end; ++column) {
    const std::size_t cell = first + static_cast<std::size_t>(column);
    if (levels_[cell] < level) {
      Raise(cell, level);
    }
  }
}

void SeenWorkspace::Raise(std::size_t cell, std::uint8_t level) {
  const std::uint8_t before = levels_[cell];
  const double worth_before = worth_[before], worth_after = worth_[level];
  for (const std::size_t neighbour : {cell - 1, cell + 1, cell - stride_, cell + stride_}) {
    const double other = worth_[levels_[neighbour]];
    border_ += std::abs(worth_after - other) - std::abs(worth_before - other);
  }
  raised_ += worth_after - worth_before;
  changes_.push_back({.cell = static_cast<std::uint32_t>(cell), .before = before, .after = level});
  levels_[cell] = level;
}

NewlySeen SeenWorkspace::TakeGain() {
  const NewlySeen gain{.new_area = raised_ * frame_.cell_m * frame_.cell_m,
                       .frontier_growth = border_ * frame_.cell_m};
  raised_ = 0.0;
  border_ = 0.0;
  return gain;
}

void SeenWorkspace::Rewind(std::size_t mark) {
  while (changes_.size() > mark) {
    levels_[changes_.back().cell] = changes_.back().before;
    changes_.pop_back();
  }
}

void SeenWorkspace::Replay(std::span<const Change> changes) {
  for (const Change& change : changes) {
    levels_[change.cell] = change.after;
    changes_.push_back(change);
  }
}

void SeenAlong::Follow() {
  if (version_ != ground_.version()) {
    workspace_.Reset(ground_);
    version_ = ground_.version();
  }
}

NewlySeen SeenAlong::operator()(const DubinsPath& path) {
  NewlySeen gain;
  EachStep(path,
           [&gain](const Pose2&, const PathSegment& motion, double before, const NewlySeen& seen) {
             gain += seen;
             gain.delay += seen.new_area * (before + 0.5 * motion.length);
           });
  return gain;
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/planning/survey_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include <Eigen/Geometry>

namespace limpet {
namespace {

/// A block's side in swaths, and bounds for it [m]. Fewer lanes than about seven make turns dear,
/// more of them make plans dear.
constexpr double kSideInSwaths = 7.0, kShortestSide = 30.0, kLongestSide = 120.0;
/// Images this wide are planned on cells of the grid, twice as wide ones on squares of four [m].
constexpr double kSwathOfACell = 5.0;
/// Factor by which a block's side may be off the wanted one, for whole lanes to fit.
constexpr double kSlack = 1.25;
/// A block is passed over after so many times the way that it needs at least, and so much more [m].
constexpr double kPatience = 3.0, kPatienceMore = 200.0;
/// A block of which at most this share is unseen when it is left counts as done: slivers.
constexpr double kMostSlivers = 0.05;
/// Within so much of a block its way begins [m].
constexpr double kNear = 20.0;

/// Lengths that the number of blocks goes by [m].
struct BlockLengths {
  double side;  ///< about that of a block
  double lane;  ///< from a lane to the next
};
/// Blocks along an extent: the number near its side for which the fewest lanes are needed in all.
int BlocksAlong(double extent, const BlockLengths& lengths) {
  const auto [side, lane] = lengths;
  const int fewest = std::max(1, static_cast<int>(std::ceil(extent / (kSlack * side))));
  const int most = std::max(fewest, static_cast<int>(std::floor(extent * kSlack / side)));
  int best = fewest;
  double least = std::numeric_limits<double>::infinity();
  for (int count = fewest; count <= most; ++count) {
    const double lanes = count * std::ceil(extent / count / lane - 0.02);
    if (lanes < least) least = lanes, best = count;
  }
  return best;
}

/// Where the `i`-th of `count` pieces of `cells` begins.
int BeginOf(int i, int count, int cells) {
  return static_cast<int>(std::int64_t{cells} * i / count);
}

bool HasWanted(const SurveyGrid& grid, const CellBox& box) {
  for (int row = box.row_min; row <= box.row_max; ++row) {
    for (int column = box.column_min; column <= box.column_max; ++column) {
      if (grid.IsWanted(row, column)) return true;
    }
  }
  return false;
}

}  // namespace

SurveyBlocks::SurveyBlocks(const SurveyGrid& grid, const Footprint& footprint)
    : frame_(grid.frame()) {
  const double cell_m2 = frame_.cell_m * frame_.cell_m;
  const double box = static_cast<double>(frame_.rows) * frame_.columns * cell_m2;
  is_whole_ = static_cast<double>(grid.wanted_cells()) * cell_m2 <= kMostGround && box <= kMostBox;
  const double side = std::clamp(kSideInSwaths * footprint.swath(), kShortestSide, kLongestSide);
  if (!is_whole_) {
    cells_per_side_ =
        std::clamp(static_cast<int>(std::lround(footprint.swath() / kSwathOfACell)), 1, 4);
  }
  const BlockLengths lengths{.side = side,
                             .lane = std::max(1.0, 2.0 * footprint.half_across(Footprint::kTop))};
  const int rows = is_whole_ ? 1 : BlocksAlong(frame_.rows * frame_.cell_m, lengths);
  const int columns = is_whole_ ? 1 : BlocksAlong(frame_.columns * frame_.cell_m, lengths);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const CellBox block{.row_min = BeginOf(row, rows, frame_.rows),
                          .row_max = BeginOf(row + 1, rows, frame_.rows) - 1,
                          .column_min = BeginOf(column, columns, frame_.columns),
                          .column_max = BeginOf(column + 1, columns, frame_.columns) - 1};
      if (is_whole_ || HasWanted(grid, block)) blocks_.push_back(block);
    }
  }
}

PlanePoint SurveyBlocks::MiddleOf(const CellBox& block) const {
  return {frame_.north_min + 0.5 * (block.row_min + block.row_max + 1) * frame_.cell_m,
          frame_.east_min + 0.5 * (block.column_min + block.column_max + 1) * frame_.cell_m};
}

std::optional<PlanePoint> SurveyBlocks::Onward() const {
  if (now_ + 1 >= blocks_.size()) return std::nullopt;
  return MiddleOf(blocks_[now_ + 1]);
}

/// Puts the blocks in order from the corner of the box that is nearest, along its longer side
/// first, to and fro.
void SurveyBlocks::PutInOrderFrom(const PlanePoint& at) {
  is_ordered_ = true;
  const bool goes_north = at.x() < frame_.north_min + 0.5 * frame_.rows * frame_.cell_m;
  const bool goes_east = at.y() < frame_.east_min + 0.5 * frame_.columns * frame_.cell_m;
  const bool is_tall = frame_.rows > frame_.columns;
  const auto line = [&](const CellBox& block) {
    return is_tall ? (goes_east ? block.column_min : -block.column_min)
                   : (goes_north ? block.row_min : -block.row_min);
  };
  const auto along = [&](const CellBox& block) {
    return is_tall ? (goes_north ? block.row_min : -block.row_min)
                   : (goes_east ? block.column_min : -block.column_min);
  };
  std::ranges::sort(blocks_, [&](const CellBox& a, const CellBox& b) {
    return line(a) != line(b) ? line(a) < line(b) : along(a) < along(b);
  });
  bool is_back = false;
  for (auto begin = blocks_.begin(); begin != blocks_.end(); is_back = !is_back) {
    const auto end = std::find_if(
        begin, blocks_.end(), [&](const CellBox& block) { return line(block) != line(*begin); });
    if (is_back) std::reverse(begin, end);
    begin = end;
  }
}

bool SurveyBlocks::IsNear(const PlanePoint& at) const {
  const PlanePoint low{frame_.north_min + now().row_min * frame_.cell_m,
                       frame_.east_min + now().column_min * frame_.cell_m};
  const PlanePoint high{frame_.north_min + (now().row_max + 1) * frame_.cell_m,
                        frame_.east_min + (now().column_max + 1) * frame_.cell_m};
  return Eigen::AlignedBox2d(low, high).exteriorDistance(at) <= kNear;
}

bool SurveyBlocks::GoOn(const Ground& ground, const PlanePoint& at, double travelled) {
  if (is_whole_ || !ground.footprint().is_in_reach(Footprint::kTop)) return false;
  if (!is_ordered_) {
    PutInOrderFrom(at);
    return true;
  }
  if (now_ + 1 >= blocks_.size()) return false;
  const double unseen = 1.0 - ground.SeenShare(Footprint::kTop);
  if (!leave_at_ && IsNear(at)) {
    const double swath = std::max(1.0, 2.0 * ground.footprint().half_across(Footprint::kTop));
    leave_at_ = travelled + kPatience * unseen * ground.wanted_m2() / swath + kPatienceMore;
  }
  const bool is_done = unseen <= 1.0 - kDoneShare;
  const bool takes_too_long = leave_at_ && travelled > *leave_at_;
  const bool is_given_up = std::exchange(is_given_up_, false) && leave_at_;
  if (!is_done && !takes_too_long && !is_given_up) return false;
  const bool is_mostly_seen = unseen <= kMostSlivers;
  passed_over_ += is_mostly_seen ? 0 : 1;
  ++now_;
  leave_at_.reset();
  return true;
}

}  // namespace limpet

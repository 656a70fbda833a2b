// SPDX-License-Identifier: MIT
#include "limpet/survey/coverage_belief.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "limpet/core/require.hpp"

namespace limpet {
namespace {

/// Images of one pass see a place again within this [s].
constexpr double kPassGap = 8.0;
/// Beyond so many sigmas outside the image nothing counts as seen, inside all does.
constexpr double kFarthestSigmas = 3.0;
constexpr double kStepsPerBit = 12.0;
constexpr int kRim = 40;             // [cells] the map's place is not off by more than this counts
constexpr double kSigmaStep = 0.05;  // [m] of absolute sigmas, as kept
constexpr double kSharpest = 1e-3;   // [m] of a sigma that is taken for none

/// Evidence of an image that is `z` sigmas of its place inside its edge; the table's step is 1/64.
class EvidenceTable {
 public:
  EvidenceTable() {
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      const double z = static_cast<double>(i) / kPerSigma - kFarthestSigmas;
      const double unseen = 0.5 * std::erfc(z / std::numbers::sqrt2);
      steps_[i] = static_cast<std::uint8_t>(
          std::clamp(std::round(-kStepsPerBit * std::log2(unseen)), 0.0, 255.0));
    }
    steps_.back() = 255;
  }
  [[nodiscard]] std::uint8_t operator()(double z) const {
    if (!(z > -kFarthestSigmas)) return 0;
    const double step = std::min((z + kFarthestSigmas) * kPerSigma, static_cast<double>(kSize - 1));
    return steps_[static_cast<std::size_t>(step)];
  }

 private:
  static constexpr double kPerSigma = 64.0;
  static constexpr std::size_t kSize = 385;  // from -3 to 3 sigmas
  std::array<std::uint8_t, kSize> steps_{};
};

/// Share that is left unseen, by evidence.
class UnseenTable {
 public:
  UnseenTable() {
    for (std::size_t i = 0; i < share_.size(); ++i) {
      share_[i] = std::exp2(-static_cast<double>(i) / kStepsPerBit);
    }
    share_.back() = 0.0;
  }
  [[nodiscard]] double operator()(int evidence) const {
    return share_[static_cast<std::size_t>(std::min(evidence, 255))];
  }

 private:
  std::array<double, 256> share_{};
};

const EvidenceTable kEvidence;
const UnseenTable kUnseen;

GridFrame WithSkirt(GridFrame frame, int cells) {
  frame.north_min -= cells * frame.cell_m;
  frame.east_min -= cells * frame.cell_m;
  frame.rows += 2 * cells;
  frame.columns += 2 * cells;
  return frame;
}

CellBox Wider(const CellBox& box, int cells, const GridFrame& frame) {
  if (box.row_min > box.row_max || box.column_min > box.column_max) return box;
  return {.row_min = std::max(0, box.row_min - cells),
          .row_max = std::min(frame.rows - 1, box.row_max + cells),
          .column_min = std::max(0, box.column_min - cells),
          .column_max = std::min(frame.columns - 1, box.column_max + cells)};
}

/// How many cells of a box are marked, of any box within one that is given.
class MarkSums {
 public:
  template <class IsMarked>
  MarkSums(const CellBox& box, IsMarked is_marked)
      : box_(box), stride_(static_cast<std::size_t>(box.column_max - box.column_min) + 2) {
    sums_.assign(stride_ * (static_cast<std::size_t>(box.row_max - box.row_min) + 2), 0);
    for (int row = box.row_min; row <= box.row_max; ++row) {
      for (int column = box.column_min; column <= box.column_max; ++column) {
        At(row + 1, column + 1) = At(row, column + 1) + At(row + 1, column) - At(row, column) +
                                  (is_marked(row, column) ? 1 : 0);
      }
    }
  }
  [[nodiscard]] int In(const CellBox& box) {
    return At(box.row_max + 1, box.column_max + 1) - At(box.row_min, box.column_max + 1) -
           At(box.row_max + 1, box.column_min) + At(box.row_min, box.column_min);
  }

 private:
  [[nodiscard]] int& At(int row, int column) {
    return sums_[static_cast<std::size_t>(row - box_.row_min) * stride_ +
                 static_cast<std::size_t>(column - box_.column_min)];
  }
  CellBox box_;
  std::size_t stride_;
  std::vector<int> sums_;  ///< over all cells south-west of one
};

int CellsOf(const CellBox& box) {
  return (box.row_max - box.row_min + 1) * (box.column_max - box.column_min + 1);
}

}  // namespace

CoverageBelief::CoverageBelief(const SurveyArea& area, const SurveyGrid& grid)
    : skirt_(static_cast<int>(std::ceil(kSkirt / grid.frame().cell_m))),
      frame_(WithSkirt(grid.frame(), skirt_)),
      cells_(frame_.rows, frame_.columns) {
  const double top = std::max(0.0, area.object_height_max);
  const double low = std::min(SurveyGrid::kObjectRadius, top);
  heights_ = {0.0, low, 0.5 * (low + top), top};
}

bool CoverageBelief::IsInside(int row, int column) const {
  return row >= skirt_ && row < frame_.rows - skirt_ && column >= skirt_ &&
         column < frame_.columns - skirt_;
}

bool CoverageBelief::IsOfArea(int row, int column, const SurveyGrid& grid) const {
  return IsInside(row, column) && grid.IsOfArea(row - skirt_, column - skirt_);
}

bool CoverageBelief::IsStoodOn(int row, int column, const SurveyGrid& grid) const {
  return IsOfArea(row, column, grid) && !grid.IsWanted(row - skirt_, column - skirt_);
}

PlanePoint CoverageBelief::SamplePoint(int row, int column, const SurveyGrid& grid) const {
  if (IsInside(row, column)) return grid.SamplePoint(row - skirt_, column - skirt_);
  return {frame_.north_min + (row + 0.5) * frame_.cell_m,
          frame_.east_min + (column + 0.5) * frame_.cell_m};
}

/// Beyond the area as at its edge.
std::optional<double> CoverageBelief::Seabed(int row, int column, const SurveyGrid& grid) const {
  return grid.Seabed(std::clamp(row - skirt_, 0, grid.frame().rows - 1),
                     std::clamp(column - skirt_, 0, grid.frame().columns - 1));
}

int CoverageBelief::Observe(const PlacedView& view, const CameraModel& camera,
                            const SurveyGrid& grid, const Shadows& shadows) {
  if (!(view.altitude > 0.0)) return 0;
  if (!first_t_) first_t_ = view.t;
  const ViewCone cone(view.X_WB, camera, SurveyGrid::kDiscInset);
  const double guessed_down = view.X_WB.p_WB.z() + view.altitude;
  const double blur = kFarthestSigmas * view.sigma.beside / std::numbers::sqrt2;
  const CellBox box = Wider(cone.CellsBelow(frame_, guessed_down),
                            static_cast<int>(std::min(blur, kSkirt) / frame_.cell_m), frame_);
  for (int row = box.row_min; row <= box.row_max; ++row) {
    for (int column = box.column_min; column <= box.column_max; ++column) {
      const PlanePoint sample = SamplePoint(row, column, grid);
      const double down = Seabed(row, column, grid).value_or(guessed_down);
      const Eigen::Vector3d sample_W{sample.x(), sample.y(), down};
      if (!shadows.Hide(sample_W)) Add(cone, sample_W, view, {row, column});
    }
  }
  return std::max(0, box.row_max - box.row_min + 1) *
         std::max(0, box.column_max - box.column_min + 1);
}

void CoverageBelief::Add(const ViewCone& cone, const Eigen::Vector3d& sample_W,
                         const PlacedView& view, const std::array<int, 2>& at) {
  const double sigma = view.sigma.beside / std::numbers::sqrt2;
  std::array<std::uint8_t, kLevels> evidence{};
  bool is_any = false;
  for (std::size_t level = 0; level < kLevels; ++level) {
    const double inside = cone.Inside(sample_W, heights_[level], level > 0);
    const std::uint8_t exactly = inside >= 0.0 ? 255 : 0;
    evidence[level] = sigma > kSharpest ? kEvidence(inside / sigma) : exactly;
    is_any = is_any || evidence[level] > 0;
  }
  if (!is_any) return;
  Tiles::Tile& tile = cells_.TileAt(at[0], at[1]);
  tile.note.is_due = true;
  Cell& cell = Tiles::CellOf(tile, at[0], at[1]);
  const double since = view.t - *first_t_;
  const bool is_new_pass = since - static_cast<double>(cell.last) > kPassGap;
  for (std::size_t level = 0; level < kLevels; ++level) {
    if (is_new_pass) {
      cell.passes[level] =
          static_cast<std::uint8_t>(std::min(255, cell.passes[level] + cell.pass[level]));
      cell.pass[level] = 0;
    }
    cell.pass[level] = std::max(cell.pass[level], evidence[level]);
  }
  cell.last = static_cast<float>(since);
  cell.map_sigma =
      static_cast<std::uint8_t>(std::clamp(view.sigma.absolute / kSigmaStep, 0.0, 255.0));
}

void CoverageBelief::CountAnew() {
  cells_.EachTile([](Tiles::Tile& tile) { tile.note.is_due = true; });
}

CoverageBelief::Shares CoverageBelief::SeenAt(int row, int column, const Cell& cell,
                                              const SurveyGrid& grid) const {
  const double floor = grid.SeenFloor(std::clamp(row - skirt_, 0, grid.frame().rows - 1),
                                      std::clamp(column - skirt_, 0, grid.frame().columns - 1));
  Shares seen{};
  for (std::size_t level = 0; level < kLevels; ++level) {
    const int evidence = cell.passes[level] + cell.pass[level];
    seen[level] = floor <= heights_[level] ? 1.0 - kUnseen(evidence) : 0.0;
  }
  return seen;
}

double CoverageBelief::EdgeChange(int row, int column, const Cell& cell,
                                  const SurveyGrid& grid) const {
  // Three places of the map on either axis, alike to a normal error in its variance and in its mean
  // distance: off by sqrt(pi/2) sigmas to either side with a chance of 1/pi each.
  constexpr double kOff = std::numbers::inv_pi, kOn = 1.0 - 2.0 * kOff;
  const double sigma = kSigmaStep * cell.map_sigma;
  const double steps =
      std::min(std::sqrt(0.5 * std::numbers::pi) * sigma / frame_.cell_m, double{kRim});
  const int whole = static_cast<int>(steps);
  std::array<double, 2> wanted{};  // off by whole cells, and by one more
  for (int more = 0; more < 2; ++more) {
    for (int north = -1; north <= 1; ++north) {
      for (int east = -1; east <= 1; ++east) {
        const int off = whole + more;
        const double chance = (north == 0 ? kOn : kOff) * (east == 0 ? kOn : kOff);
        wanted[static_cast<std::size_t>(more)] +=
            IsOfArea(row + north * off, column + east * off, grid) ? chance : 0.0;
      }
    }
  }
  return wanted[0] + (steps - whole) * (wanted[1] - wanted[0]) - (cell.is_of_area ? 1.0 : 0.0);
}

/// Finds out which of a tile's cells are wanted, and which are so near to one that is and to one
/// that is not that the map's place may make a difference.
void CoverageBelief::Prepare(Tiles::Tile& tile, const SurveyGrid& grid) const {
  const CellBox own{.row_min = tile.row,
                    .row_max = std::min(tile.row + Tiles::kEdge, frame_.rows) - 1,
                    .column_min = tile.column,
                    .column_max = std::min(tile.column + Tiles::kEdge, frame_.columns) - 1};
  MarkSums wanted(Wider(own, kRim, frame_),
                  [&](int row, int column) { return IsOfArea(row, column, grid); });
  cells_.EachCell(tile, [&](int row, int column, Cell& cell) {
    const CellBox around = Wider(
        {.row_min = row, .row_max = row, .column_min = column, .column_max = column}, kRim, frame_);
    const int near = wanted.In(around);
    cell.is_of_area = IsOfArea(row, column, grid);
    cell.is_rim = near > 0 && near < CellsOf(around);
  });
  tile.note.is_prepared = true;
}

void CoverageBelief::Count(Tiles::Tile& tile, const SurveyGrid& grid) const {
  if (!tile.note.is_prepared) Prepare(tile, grid);
  Shares sum{};
  cells_.EachCell(tile, [&](int row, int column, const Cell& cell) {
    if (cell.last < 0.0F || IsStoodOn(row, column, grid)) return;
    const double weight =
        (cell.is_of_area ? 1.0 : 0.0) + (cell.is_rim ? EdgeChange(row, column, cell, grid) : 0.0);
    if (weight == 0.0) return;
    const Shares seen = SeenAt(row, column, cell, grid);
    for (std::size_t level = 0; level < kLevels; ++level) {
      sum[level] += weight * seen[level];
    }
  });
  tile.note.sum = sum;
  tile.note.is_due = false;
}

Coverage CoverageBelief::Expected(const SurveyGrid& grid) const {
  Shares sum{};
  cells_.EachTile([&](Tiles::Tile& tile) {
    if (tile.note.is_due) Count(tile, grid);
    for (std::size_t level = 0; level < kLevels; ++level) {
      sum[level] += tile.note.sum[level];
    }
  });
  const double wanted = std::max(1.0, static_cast<double>(grid.wanted_cells()));
  for (double& level : sum) {
    level = std::clamp(level / wanted, 0.0, 1.0);  // cells of an edge may differ in their sigmas
  }
  // The mean over the band by Simpson's rule.
  return {.seabed = sum[0], .band = (sum[1] + 4.0 * sum[2] + sum[3]) / 6.0, .band_top = sum[3]};
}

}  // namespace limpet

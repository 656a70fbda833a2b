// SPDX-License-Identifier: MIT
#include "limpet/survey/coverage_belief.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "limpet/core/probability.hpp"
#include "limpet/core/require.hpp"

namespace limpet {
namespace {

/// Images of one pass see a place again within this [s].
constexpr double kPassGap = 8.0;
/// Beyond so many sigmas outside the image nothing counts as seen, inside all does.
constexpr double kFarthestSigmas = 3.0;
constexpr double kStepsPerBit = 12.0;
constexpr int kRim = 40;             // [cells] the map's place is not off by more, as this counts
constexpr double kSigmaStep = 0.05;  // [m] of absolute sigmas, as kept
constexpr double kSharpest = 1e-3;   // [m] of a sigma that is taken for none
constexpr std::uint8_t kSure = 255;  // evidence of which there is no more

/// Evidence of an image that is `z` sigmas of its place inside its edge; the table's step is 1/64.
class EvidenceTable {
 public:
  EvidenceTable() {
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      const double z = static_cast<double>(i) / kPerSigma - kFarthestSigmas;
      const double unseen = StandardNormalShareBelow(-z);
      steps_[i] = static_cast<std::uint8_t>(
          std::clamp(std::round(-kStepsPerBit * std::log2(unseen)), 0.0, 255.0));
    }
    steps_.back() = kSure;
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
  [[nodiscard]] int In(const CellBox& box) const {
    return At(box.row_max + 1, box.column_max + 1) - At(box.row_min, box.column_max + 1) -
           At(box.row_max + 1, box.column_min) + At(box.row_min, box.column_min);
  }

 private:
  [[nodiscard]] std::size_t IndexOf(int row, int column) const {
    return static_cast<std::size_t>(row - box_.row_min) * stride_ +
           static_cast<std::size_t>(column - box_.column_min);
  }
  [[nodiscard]] int& At(int row, int column) { return sums_[IndexOf(row, column)]; }
  [[nodiscard]] int At(int row, int column) const { return sums_[IndexOf(row, column)]; }
  CellBox box_;
  std::size_t stride_;
  std::vector<int> sums_;  ///< over all cells south-west of one
};

/// By how many cells the map is off on one axis, and how likely: five places that agree with a
/// normal error in its variance, in its mean distance, and in what lies farther than half a sigma
/// and than one. Those between two cells are shared out to both.
class PlaceChances {
 public:
  explicit PlaceChances(double sigma_cells) {
    constexpr double kNear = 0.726, kByNear = 0.3164, kFar = 1.97, kByFar = 0.0859;
    Add(0.0, 1.0 - 2.0 * (kByNear + kByFar));
    for (const double side : {-1.0, 1.0}) {
      Add(side * std::min(kNear * sigma_cells, double{kRim}), kByNear);
      Add(side * std::min(kFar * sigma_cells, double{kRim}), kByFar);
    }
  }
  struct Off {
    int cells = 0;
    double chance = 0.0;
  };
  [[nodiscard]] std::span<const Off> all() const { return {offs_.data(), count_}; }
  [[nodiscard]] int farthest() const { return farthest_; }

 private:
  void Add(double cells, double chance) {
    const double whole = std::floor(cells);
    Put(static_cast<int>(whole), chance * (1.0 - (cells - whole)));
    Put(static_cast<int>(whole) + 1, chance * (cells - whole));
  }
  void Put(int cells, double chance) {
    if (chance == 0.0) return;
    offs_[count_++] = {.cells = cells, .chance = chance};
    farthest_ = std::max(farthest_, std::abs(cells));
  }
  std::array<Off, 10> offs_{};
  std::size_t count_ = 0;
  int farthest_ = 0;
};

int CellsOf(const CellBox& box) {
  return (box.row_max - box.row_min + 1) * (box.column_max - box.column_min + 1);
}

/// How far the next cell is that is marked otherwise [cells, along the farther axis]; kRim + 1 if
/// none within kRim is.
int ToRim(int row, int column, const MarkSums& marked, const GridFrame& frame) {
  const CellBox own{.row_min = row, .row_max = row, .column_min = column, .column_max = column};
  int alike = 0, off = kRim + 1;
  while (off - alike > 1) {
    const int middle = (alike + off) / 2;
    const CellBox around = Wider(own, middle, frame);
    const int count = marked.In(around);
    (count == 0 || count == CellsOf(around) ? alike : off) = middle;
  }
  return off;
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

/// Depth of the seabed at a cell [m]; beyond the area it is as at the area's edge.
std::optional<double> CoverageBelief::Seabed(int row, int column, const SurveyGrid& grid) const {
  return grid.Seabed(std::clamp(row - skirt_, 0, grid.frame().rows - 1),
                     std::clamp(column - skirt_, 0, grid.frame().columns - 1));
}

int CoverageBelief::Observe(const PlacedView& view, const CameraModel& camera,
                            const SurveyGrid& grid, const Shadows& shadows) {
  if (!(view.altitude > 0.0)) return 0;
  if (!first_t_) first_t_ = view.t;
  const Image image{.cone = ViewCone(view.X_WB, camera, SurveyGrid::kDiscInset),
                    .sigma = view.sigma.beside / std::numbers::sqrt2,
                    .since = view.t - *first_t_,
                    .map_sigma = static_cast<std::uint8_t>(
                        std::clamp(std::round(view.sigma.absolute / kSigmaStep), 0.0, 255.0))};
  const double guessed_down = view.X_WB.p_WB.z() + view.altitude;
  const double blur = kFarthestSigmas * view.sigma.beside / std::numbers::sqrt2;
  const CellBox box = Wider(image.cone.CellsBelow(frame_, guessed_down),
                            static_cast<int>(std::min(blur, kSkirt) / frame_.cell_m), frame_);
  for (int row = box.row_min; row <= box.row_max; ++row) {
    for (int column = box.column_min; column <= box.column_max; ++column) {
      const PlanePoint sample = SamplePoint(row, column, grid);
      const double down = Seabed(row, column, grid).value_or(guessed_down);
      const Eigen::Vector3d sample_W{sample.x(), sample.y(), down};
      if (!shadows.Hide(sample_W)) Add(image, sample_W, {row, column});
    }
  }
  return std::max(0, box.row_max - box.row_min + 1) *
         std::max(0, box.column_max - box.column_min + 1);
}

void CoverageBelief::Add(const Image& image, const Eigen::Vector3d& sample_W,
                         const std::array<int, 2>& at) {
  const auto evidence = [&](std::size_t level) {
    const double inside = image.cone.Inside(sample_W, heights_[level], level > 0);
    const std::uint8_t exactly = inside >= 0.0 ? kSure : 0;
    return image.sigma > kSharpest ? kEvidence(inside / image.sigma) : exactly;
  };
  // What is higher is never farther inside.
  const std::uint8_t of_bottom = evidence(0);
  if (of_bottom == 0) return;
  Tiles::Tile& tile = cells_.TileAt(at[0], at[1]);
  tile.note.is_due = true;
  Cell& cell = Tiles::CellOf(tile, at[0], at[1]);
  const bool is_new_pass = image.since - static_cast<double>(cell.last) > kPassGap;
  for (std::size_t level = 0; level < kLevels; ++level) {
    if (is_new_pass) {
      cell.passes[level] =
          static_cast<std::uint8_t>(std::min(255, cell.passes[level] + cell.pass[level]));
      cell.pass[level] = 0;
    }
    if (cell.pass[level] == kSure) continue;
    cell.pass[level] = std::max(cell.pass[level], level == 0 ? of_bottom : evidence(level));
  }
  cell.last = static_cast<float>(image.since);
  cell.map_sigma = image.map_sigma;
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
  const PlaceChances chances(kSigmaStep * cell.map_sigma / frame_.cell_m);
  if (chances.farthest() < cell.to_rim) return 0.0;
  double wanted = 0.0;
  for (const auto& [north, by_north] : chances.all()) {
    for (const auto& [east, by_east] : chances.all()) {
      if (IsOfArea(row + north, column + east, grid)) wanted += by_north * by_east;
    }
  }
  return wanted - (cell.is_of_area ? 1.0 : 0.0);
}

/// Finds out which of a tile's cells are wanted, and how far the map has to be off for each to be
/// on the other side of an edge.
void CoverageBelief::Prepare(Tiles::Tile& tile, const SurveyGrid& grid) const {
  const CellBox own{.row_min = tile.row,
                    .row_max = std::min(tile.row + Tiles::kEdge, frame_.rows) - 1,
                    .column_min = tile.column,
                    .column_max = std::min(tile.column + Tiles::kEdge, frame_.columns) - 1};
  const MarkSums wanted(Wider(own, kRim, frame_),
                        [&](int row, int column) { return IsOfArea(row, column, grid); });
  cells_.EachCell(tile, [&](int row, int column, Cell& cell) {
    cell.is_of_area = IsOfArea(row, column, grid);
    cell.to_rim = static_cast<std::uint8_t>(ToRim(row, column, wanted, frame_));
  });
  tile.note.is_prepared = true;
}

void CoverageBelief::Count(Tiles::Tile& tile, const SurveyGrid& grid) const {
  if (!tile.note.is_prepared) Prepare(tile, grid);
  Shares sum{};
  cells_.EachCell(tile, [&](int row, int column, const Cell& cell) {
    if (cell.last < 0.0F || IsStoodOn(row, column, grid)) return;
    const double weight = (cell.is_of_area ? 1.0 : 0.0) + EdgeChange(row, column, cell, grid);
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

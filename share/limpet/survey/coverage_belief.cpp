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

/// Cells of a row-major grid within `reach` cells, rows and columns, of one that is marked.
std::vector<std::uint8_t> Grown(const std::vector<std::uint8_t>& mark, const GridFrame& frame,
                                int reach) {
  std::vector<std::uint8_t> grown(mark.size(), 0), rows(mark.size(), 0);
  const auto spread = [reach](const auto& from, auto& to, int lines, int count, int line_step,
                              int step) {
    for (int line = 0; line < lines; ++line) {
      int left = 0;
      for (int i = 0; i < count + reach; ++i) {
        const auto at = [&](int k) {
          return static_cast<std::size_t>(line * line_step + k * step);
        };
        left = i < count && from[at(i)] != 0 ? 2 * reach + 1 : std::max(0, left - 1);
        if (i >= reach && left > 0) to[at(i - reach)] = 1;
      }
    }
  };
  spread(mark, rows, frame.rows, frame.columns, frame.columns, 1);
  spread(rows, grown, frame.columns, frame.rows, 1, frame.columns);
  return grown;
}

}  // namespace

CoverageBelief::CoverageBelief(const SurveyArea& area, const SurveyGrid& grid)
    : frame_(grid.frame()),
      skirt_(static_cast<int>(std::ceil(kSkirt / grid.frame().cell_m))),
      wanted_(std::max(1.0, static_cast<double>(grid.wanted_cells()))) {
  frame_ = WithSkirt(frame_, skirt_);
  const double top = std::max(0.0, area.object_height_max);
  const double low = std::min(SurveyGrid::kObjectRadius, top);
  heights_ = {0.0, low, 0.5 * (low + top), top};
  const auto count =
      static_cast<std::size_t>(frame_.rows) * static_cast<std::size_t>(frame_.columns);
  cells_.resize(count);
  is_wanted_.assign(count, 0);
  std::vector<std::uint8_t> unwanted(count, 1);
  for (int row = skirt_; row < frame_.rows - skirt_; ++row) {
    for (int column = skirt_; column < frame_.columns - skirt_; ++column) {
      if (!grid.IsWanted(InsideCell(row, column))) continue;
      const auto cell = static_cast<std::size_t>(row * frame_.columns + column);
      is_wanted_[cell] = 1;
      unwanted[cell] = 0;
    }
  }
  const auto near_wanted = Grown(is_wanted_, frame_, kRim);
  const auto near_unwanted = Grown(unwanted, frame_, kRim);
  for (std::size_t cell = 0; cell < count; ++cell) {
    if (near_wanted[cell] != 0 && near_unwanted[cell] != 0) {
      rim_.push_back(static_cast<std::uint32_t>(cell));
    }
  }
}

std::size_t CoverageBelief::InsideCell(int row, int column) const {
  const int inside_row = std::clamp(row - skirt_, 0, frame_.rows - 2 * skirt_ - 1);
  const int inside_column = std::clamp(column - skirt_, 0, frame_.columns - 2 * skirt_ - 1);
  return static_cast<std::size_t>(inside_row * (frame_.columns - 2 * skirt_) + inside_column);
}

bool CoverageBelief::IsWanted(int row, int column) const {
  return row >= 0 && row < frame_.rows && column >= 0 && column < frame_.columns &&
         is_wanted_[static_cast<std::size_t>(row * frame_.columns + column)] != 0;
}

PlanePoint CoverageBelief::SamplePoint(int row, int column, const SurveyGrid& grid) const {
  const bool is_inside = row >= skirt_ && row < frame_.rows - skirt_ && column >= skirt_ &&
                         column < frame_.columns - skirt_;
  if (is_inside) return grid.SamplePoint(InsideCell(row, column));
  return {frame_.north_min + (row + 0.5) * frame_.cell_m,
          frame_.east_min + (column + 0.5) * frame_.cell_m};
}

int CoverageBelief::Observe(const PlacedView& view, const CameraModel& camera,
                            const SurveyGrid& grid) {
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
      const double down = grid.SeabedAt(InsideCell(row, column)).value_or(guessed_down);
      Add(cone, {sample.x(), sample.y(), down}, view,
          cells_[static_cast<std::size_t>(row * frame_.columns + column)]);
    }
  }
  return std::max(0, box.row_max - box.row_min + 1) *
         std::max(0, box.column_max - box.column_min + 1);
}

void CoverageBelief::Add(const ViewCone& cone, const Eigen::Vector3d& sample_W,
                         const PlacedView& view, Cell& cell) const {
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

CoverageBelief::Shares CoverageBelief::SeenAt(std::size_t cell, const SurveyGrid& grid) const {
  const int row = static_cast<int>(cell) / frame_.columns;
  const int column = static_cast<int>(cell) % frame_.columns;
  const auto floor = static_cast<double>(grid.Floor(InsideCell(row, column)));
  Shares seen{};
  for (std::size_t level = 0; level < kLevels; ++level) {
    const int evidence = cells_[cell].passes[level] + cells_[cell].pass[level];
    seen[level] = floor <= heights_[level] ? 1.0 - kUnseen(evidence) : 0.0;
  }
  return seen;
}

double CoverageBelief::EdgeChange(std::uint32_t cell) const {
  // Three places of the map on either axis, alike to a normal error in its variance and in its mean
  // distance: off by sqrt(pi/2) sigmas to either side with a chance of 1/pi each.
  constexpr double kOff = std::numbers::inv_pi, kOn = 1.0 - 2.0 * kOff;
  const double sigma = kSigmaStep * cells_[cell].map_sigma;
  const double steps =
      std::min(std::sqrt(0.5 * std::numbers::pi) * sigma / frame_.cell_m, double{kRim});
  const int whole = static_cast<int>(steps), row = static_cast<int>(cell) / frame_.columns;
  const int column = static_cast<int>(cell) % frame_.columns;
  std::array<double, 2> wanted{};  // off by whole cells, and by one more
  for (int more = 0; more < 2; ++more) {
    for (int north = -1; north <= 1; ++north) {
      for (int east = -1; east <= 1; ++east) {
        const int off = whole + more;
        const double chance = (north == 0 ? kOn : kOff) * (east == 0 ? kOn : kOff);
        wanted[static_cast<std::size_t>(more)] +=
            IsWanted(row + north * off, column + east * off) ? chance : 0.0;
      }
    }
  }
  return wanted[0] + (steps - whole) * (wanted[1] - wanted[0]) -
         (is_wanted_[cell] != 0 ? 1.0 : 0.0);
}

Coverage CoverageBelief::Expected(const SurveyGrid& grid) const {
  Shares sum{};
  const auto add = [&](std::size_t cell, double weight) {
    const Shares seen = SeenAt(cell, grid);
    for (std::size_t level = 0; level < kLevels; ++level) {
      sum[level] += weight * seen[level];
    }
  };
  for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
    if (is_wanted_[cell] != 0 && cells_[cell].last >= 0.0F) add(cell, 1.0);
  }
  for (const std::uint32_t cell : rim_) {
    if (cells_[cell].last < 0.0F) continue;
    if (const double change = EdgeChange(cell); change != 0.0) add(cell, change);
  }
  for (double& level : sum) {
    level = std::clamp(level / wanted_, 0.0, 1.0);  // cells of an edge may differ in their sigmas
  }
  // The mean over the band by Simpson's rule.
  return {.seabed = sum[0], .band = (sum[1] + 4.0 * sum[2] + sum[3]) / 6.0, .band_top = sum[3]};
}

}  // namespace limpet

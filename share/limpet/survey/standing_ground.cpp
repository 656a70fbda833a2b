// SPDX-License-Identifier: MIT
#include "limpet/survey/standing_ground.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>

#include <Eigen/Geometry>

#include "limpet/survey/view_cone.hpp"

namespace limpet {
namespace {

/// Half of the widest gap between outlines that shuts in what is behind them all the same [m].
constexpr double kHalfGap = 0.5;
/// Outlines are looked at together, for what they enclose, within at most so many cells: memory.
constexpr double kMostWindow = 4e6;

struct Outlined {
  SimplePolygon polygon;
  Eigen::AlignedBox2d box;  ///< with half a gap around
};

std::vector<Outlined> PolygonsOf(const std::vector<Obstacle>& obstacles) {
  std::vector<Outlined> outlined;
  for (const Obstacle& obstacle : obstacles) {
    std::vector<PlanePoint> corners;
    for (const auto& [north, east] : obstacle.outline)
      corners.emplace_back(north, east);
    Expected<SimplePolygon> polygon = SimplePolygon::Of(std::move(corners));
    if (!polygon) continue;
    const PlanePoint around = PlanePoint::Constant(kHalfGap);
    const Eigen::AlignedBox2d box(polygon->low() - around, polygon->high() + around);
    outlined.push_back({.polygon = *std::move(polygon), .box = box});
  }
  return outlined;
}

/// Those that are near each other, together: piles far apart need no grid between them.
std::vector<std::vector<Outlined>> Clustered(std::vector<Outlined> outlined) {
  std::vector<std::vector<Outlined>> clusters;
  while (!outlined.empty()) {
    std::vector<Outlined> cluster{std::move(outlined.back())};
    outlined.pop_back();
    for (std::size_t i = 0; i < cluster.size(); ++i) {
      const auto near = std::partition(
          outlined.begin(), outlined.end(),
          [&, box = cluster[i].box](const Outlined& one) { return !box.intersects(one.box); });
      std::move(near, outlined.end(), std::back_inserter(cluster));
      outlined.erase(near, outlined.end());
    }
    clusters.push_back(std::move(cluster));
  }
  return clusters;
}

/// Ground around a cluster, cell by cell as the grid has them; it may reach beyond the grid.
class Surroundings {
 public:
  [[nodiscard]] static double CellsAround(const std::vector<Outlined>& cluster,
                                          const GridFrame& frame) {
    const CellBox box = BoxAround(cluster, frame);
    return (box.row_max - box.row_min + 1.0) * (box.column_max - box.column_min + 1.0);
  }

  Surroundings(const std::vector<Outlined>& cluster, const GridFrame& frame)
      : frame_(frame), box_(BoxAround(cluster, frame)) {
    cells_.resize(static_cast<std::size_t>(rows()) * static_cast<std::size_t>(columns()));
    for (const Outlined& one : cluster)
      Draw(one);
  }

  /// Whatever can be come to from outside, or from where the vehicle is.
  void Flood(const std::optional<PlanePoint>& vehicle) {
    FloodFrom({box_.row_min, box_.column_min});  // the border is free all around
    if (const auto at = vehicle ? CellAt(*vehicle) : std::nullopt) FloodFrom(*at);
    for (int row = box_.row_min; row <= box_.row_max; ++row) {
      for (int column = box_.column_min; column <= box_.column_max; ++column) {
        if (IsOpen({row, column})) JudgeEnclosed({row, column});
      }
    }
  }

  /// Adds the cells of the grid that are stood on.
  void Collect(std::vector<std::uint32_t>& standing) const {
    for (int row = std::max(0, box_.row_min); row <= std::min(frame_.rows - 1, box_.row_max);
         ++row) {
      for (int column = std::max(0, box_.column_min);
           column <= std::min(frame_.columns - 1, box_.column_max); ++column) {
        if (!IsStoodOn({row, column})) continue;
        standing.push_back(static_cast<std::uint32_t>(row) *
                               static_cast<std::uint32_t>(frame_.columns) +
                           static_cast<std::uint32_t>(column));
      }
    }
  }

 private:
  using At = std::array<int, 2>;  ///< row and column, of the grid
  struct Cell {
    bool is_outlined = false, is_near = false;  ///< in an outline; within half a gap of one
    bool is_reached = false, is_enclosed = false;
  };

  static CellBox BoxAround(const std::vector<Outlined>& cluster, const GridFrame& frame) {
    Eigen::AlignedBox2d all;
    for (const Outlined& one : cluster)
      all.extend(one.box);
    const auto cell = [&frame](double offset) {
      return static_cast<int>(std::floor(offset / frame.cell_m));
    };
    return {.row_min = cell(all.min().x() - frame.north_min) - 2,
            .row_max = cell(all.max().x() - frame.north_min) + 2,
            .column_min = cell(all.min().y() - frame.east_min) - 2,
            .column_max = cell(all.max().y() - frame.east_min) + 2};
  }
  [[nodiscard]] int rows() const { return box_.row_max - box_.row_min + 1; }
  [[nodiscard]] int columns() const { return box_.column_max - box_.column_min + 1; }
  [[nodiscard]] bool Holds(const At& at) const {
    return at[0] >= box_.row_min && at[0] <= box_.row_max && at[1] >= box_.column_min &&
           at[1] <= box_.column_max;
  }
  [[nodiscard]] std::size_t Slot(const At& at) const {
    return static_cast<std::size_t>(at[0] - box_.row_min) * static_cast<std::size_t>(columns()) +
           static_cast<std::size_t>(at[1] - box_.column_min);
  }
  [[nodiscard]] PlanePoint CenterOf(const At& at) const {
    return {frame_.north_min + (at[0] + 0.5) * frame_.cell_m,
            frame_.east_min + (at[1] + 0.5) * frame_.cell_m};
  }
  [[nodiscard]] std::optional<At> CellAt(const PlanePoint& place) const {
    const auto cell = [this](double offset) { return std::floor(offset / frame_.cell_m); };
    const double row = cell(place.x() - frame_.north_min);
    const double column = cell(place.y() - frame_.east_min);
    const bool is_inside = row >= box_.row_min && row <= box_.row_max &&
                           column >= box_.column_min && column <= box_.column_max;
    if (!is_inside) return std::nullopt;
    return At{static_cast<int>(row), static_cast<int>(column)};
  }

  void Draw(const Outlined& one) {
    const CellBox box = BoxAround({one}, frame_);
    for (int row = box.row_min; row <= box.row_max; ++row) {
      for (int column = box.column_min; column <= box.column_max; ++column) {
        const double depth = one.polygon.Depth(CenterOf({row, column}));
        Cell& cell = cells_[Slot({row, column})];
        cell.is_outlined = cell.is_outlined || depth >= 0.0;
        cell.is_near = cell.is_near || depth >= -kHalfGap;
      }
    }
  }

  /// Neither near an outline nor dealt with.
  [[nodiscard]] bool IsOpen(const At& at) const {
    if (!Holds(at)) return false;
    const Cell& cell = cells_[Slot(at)];
    return !cell.is_near && !cell.is_reached && !cell.is_enclosed;
  }
  /// All open cells that lie together with this one; `mark` is called once for each.
  template <class Mark>
  std::vector<At> Together(const At& first, Mark mark) {
    std::vector<At> found;
    if (!IsOpen(first)) return found;
    mark(cells_[Slot(first)]);
    found.push_back(first);
    for (std::size_t i = 0; i < found.size(); ++i) {
      const At at = found[i];
      for (const At& next : {At{at[0] - 1, at[1]}, At{at[0] + 1, at[1]}, At{at[0], at[1] - 1},
                             At{at[0], at[1] + 1}}) {
        if (!IsOpen(next)) continue;
        mark(cells_[Slot(next)]);
        found.push_back(next);
      }
    }
    return found;
  }
  void FloodFrom(const At& first) {
    Together(first, [](Cell& cell) { cell.is_reached = true; });
  }
  void JudgeEnclosed(const At& first) {
    const std::vector<At> enclosed = Together(first, [](Cell& cell) { cell.is_enclosed = true; });
    const double m2 = static_cast<double>(enclosed.size()) * frame_.cell_m * frame_.cell_m;
    if (m2 <= kMostEnclosed) return;
    for (const At& at : enclosed)
      cells_[Slot(at)].is_reached = true;
  }

  /// True for ground in an outline; or shut in, up to the walls: what lies along them outside is
  /// near cells that were reached.
  [[nodiscard]] bool IsStoodOn(const At& at) const {
    const Cell& cell = cells_[Slot(at)];
    if (cell.is_outlined || cell.is_reached) return cell.is_outlined;
    if (cell.is_enclosed) return true;
    const int reach = static_cast<int>(std::ceil(kHalfGap / frame_.cell_m)) + 1;
    const double farthest = kHalfGap / frame_.cell_m + 0.5;
    for (int row = -reach; row <= reach; ++row) {
      for (int column = -reach; column <= reach; ++column) {
        const At near{at[0] + row, at[1] + column};
        if (std::hypot(row, column) <= farthest && Holds(near) && cells_[Slot(near)].is_reached)
          return false;
      }
    }
    return true;
  }

  GridFrame frame_;
  CellBox box_;
  std::vector<Cell> cells_;
};

/// A coast of outlines encloses no obstacle, but stands all the same: each for itself.
std::vector<std::vector<Outlined>> Apart(std::vector<Outlined> cluster) {
  std::vector<std::vector<Outlined>> apart;
  for (Outlined& one : cluster)
    apart.push_back({std::move(one)});
  return apart;
}

/// Clusters that there is memory to look at.
std::vector<std::vector<Outlined>> LookedAtTogether(std::vector<std::vector<Outlined>> clusters,
                                                    const GridFrame& frame) {
  std::vector<std::vector<Outlined>> together;
  for (std::vector<Outlined>& cluster : clusters) {
    if (Surroundings::CellsAround(cluster, frame) <= kMostWindow) {
      together.push_back(std::move(cluster));
    } else {
      std::ranges::move(Apart(std::move(cluster)), std::back_inserter(together));
    }
  }
  return together;
}

}  // namespace

std::vector<std::uint32_t> StandingGround(const std::vector<Obstacle>& obstacles,
                                          const GridFrame& frame,
                                          const std::optional<PlanePoint>& vehicle) {
  std::vector<std::uint32_t> standing;
  for (const std::vector<Outlined>& cluster :
       LookedAtTogether(Clustered(PolygonsOf(obstacles)), frame)) {
    Surroundings around(cluster, frame);
    around.Flood(vehicle);
    around.Collect(standing);
  }
  std::ranges::sort(standing);
  standing.erase(std::unique(standing.begin(), standing.end()), standing.end());
  return standing;
}

}  // namespace limpet

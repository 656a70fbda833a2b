// SPDX-License-Identifier: MIT
#include "estimation/mapping/obstacle_outline.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

namespace limpet {
namespace {

using OutlinePoint = std::array<double, 2>;

double Cross(const OutlinePoint& o, const OutlinePoint& a, const OutlinePoint& b) {
  return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
}

/// Andrew's monotone chain: one side of the hull of sorted points, without its last corner.
template <class Iterator>
void AddHullSide(Iterator first, Iterator last, std::vector<OutlinePoint>& hull) {
  const std::size_t begin = hull.size();
  for (Iterator at = first; at != last; ++at) {
    while (hull.size() >= begin + 2 && Cross(hull[hull.size() - 2], hull.back(), *at) <= 0.0) {
      hull.pop_back();
    }
    hull.push_back(*at);
  }
  hull.pop_back();
}

std::vector<OutlinePoint> HullOf(std::vector<OutlinePoint> points) {
  std::ranges::sort(points);
  std::vector<OutlinePoint> hull;
  AddHullSide(points.begin(), points.end(), hull);
  AddHullSide(points.rbegin(), points.rend(), hull);
  return hull;
}

double DistanceToSide(const OutlinePoint& a, const OutlinePoint& b, const OutlinePoint& at) {
  const double along_n = b[0] - a[0], along_e = b[1] - a[1];
  const double length_sq = along_n * along_n + along_e * along_e;
  const double off_n = at[0] - a[0], off_e = at[1] - a[1];
  const double share =
      length_sq > 0.0 ? std::clamp((off_n * along_n + off_e * along_e) / length_sq, 0.0, 1.0) : 0.0;
  return std::hypot(off_n - share * along_n, off_e - share * along_e);
}

/// Leaves out corners that hardly stick out, the least first: whoever keeps off pays for each.
void Simplify(std::vector<OutlinePoint>& outline) {
  constexpr double kHardly = 0.1;  // [m]
  constexpr std::size_t kFewest = 4;
  while (outline.size() > kFewest) {
    const std::size_t count = outline.size();
    const auto sticks_out = [&](std::size_t i) {
      return DistanceToSide(outline[(i + count - 1) % count], outline[(i + 1) % count], outline[i]);
    };
    std::size_t least = 0;
    for (std::size_t i = 1; i < count; ++i) {
      if (sticks_out(i) < sticks_out(least)) least = i;
    }
    if (sticks_out(least) > kHardly) return;
    outline.erase(outline.begin() + static_cast<std::ptrdiff_t>(least));
  }
}

using Cells = std::vector<EchoCells::Cell>;

/// Cells that gaps as beams leave them between echoes do not part.
std::vector<Cells> Connected(const Cells& cells, double reach) {
  std::vector<Cells> groups;
  std::vector<bool> is_taken(cells.size(), false);
  for (std::size_t seed = 0; seed < cells.size(); ++seed) {
    if (is_taken[seed]) continue;
    is_taken[seed] = true;
    Cells group{cells[seed]};
    for (std::size_t done = 0; done < group.size(); ++done) {
      for (std::size_t i = 0; i < cells.size(); ++i) {
        if (is_taken[i] || (cells[i].p_W - group[done].p_W).head<2>().norm() > reach) continue;
        is_taken[i] = true;
        group.push_back(cells[i]);
      }
    }
    groups.push_back(std::move(group));
  }
  return groups;
}

bool IsLong(const Cells& group) {
  Eigen::Vector2d low = group.front().p_W.head<2>(), high = low;
  for (const EchoCells::Cell& cell : group) {
    low = low.cwiseMin(cell.p_W.head<2>());
    high = high.cwiseMax(cell.p_W.head<2>());
  }
  return (high - low).maxCoeff() > kLongestGroup;
}

/// By the squares of half that length that they lie in: fixed, so that pieces stay what they are as
/// more of a wall comes into sight.
std::vector<Cells> BySquares(const Cells& group) {
  std::map<std::pair<double, double>, Cells> squares;
  const auto square = [](double at) { return std::floor(2.0 * at / kLongestGroup); };
  for (const EchoCells::Cell& cell : group) {
    squares[{square(cell.p_W.x()), square(cell.p_W.y())}].push_back(cell);
  }
  std::vector<Cells> pieces;
  for (auto& [key, piece] : squares) {
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

}  // namespace

std::vector<std::vector<EchoCells::Cell>> GroupsOf(const std::vector<EchoCells::Cell>& cells,
                                                   double cell_m) {
  constexpr double kGap = 3.0;  // cells
  std::vector<Cells> groups;
  for (Cells& group : Connected(cells, kGap * cell_m)) {
    if (!IsLong(group)) {
      groups.push_back(std::move(group));
    } else {
      std::ranges::move(BySquares(group), std::back_inserter(groups));
    }
  }
  return groups;
}

std::vector<OutlinePoint> OutlineOf(const std::vector<EchoCells::Cell>& group, double around) {
  std::vector<OutlinePoint> corners;
  for (const EchoCells::Cell& cell : group) {
    for (const double to_north : {-around, around}) {
      for (const double to_east : {-around, around}) {
        corners.push_back({cell.p_W.x() + to_north, cell.p_W.y() + to_east});
      }
    }
  }
  std::vector<OutlinePoint> outline = HullOf(std::move(corners));
  Simplify(outline);
  return outline;
}

double Outside(const std::vector<OutlinePoint>& outline, double north, double east) {
  const OutlinePoint at{north, east};
  double nearest = std::numeric_limits<double>::infinity();
  bool is_inside = true;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const OutlinePoint& from = outline[i];
    const OutlinePoint& to = outline[(i + 1) % outline.size()];
    nearest = std::min(nearest, DistanceToSide(from, to, at));
    is_inside = is_inside && Cross(from, to, at) >= 0.0;
  }
  return is_inside ? 0.0 : nearest;
}

}  // namespace limpet

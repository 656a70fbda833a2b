// SPDX-License-Identifier: MIT
#include "limpet/planning/room.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>
#include <queue>
#include <utility>

namespace limpet {
namespace {

constexpr std::size_t kNowhere = std::numeric_limits<std::size_t>::max();

/// Calls visit(cell, distance in cells) for the up to eight cells around one.
template <class Visit>
void EachNeighbour(const FreeSpace::Raster& raster, std::size_t cell, Visit visit) {
  const auto columns = static_cast<std::size_t>(raster.columns);
  const int row = static_cast<int>(cell / columns), column = static_cast<int>(cell % columns);
  for (int dr = -1; dr <= 1; ++dr) {
    for (int dc = -1; dc <= 1; ++dc) {
      const int r = row + dr, c = column + dc;
      const bool is_inside = r >= 0 && r < raster.rows && c >= 0 && c < raster.columns;
      if (is_inside && (dr != 0 || dc != 0)) {
        visit(static_cast<std::size_t>(r) * columns + static_cast<std::size_t>(c),
              dr != 0 && dc != 0 ? std::numbers::sqrt2 : 1.0);
      }
    }
  }
}

/// The cells that hang together with `seed` and are marked `1`; they become `2`.
std::vector<std::size_t> TakePiece(const FreeSpace::Raster& raster, std::size_t seed,
                                   std::vector<std::uint8_t>& mark) {
  std::vector<std::size_t> piece{seed};
  mark[seed] = 2;
  for (std::size_t i = 0; i < piece.size(); ++i) {
    EachNeighbour(raster, piece[i], [&](std::size_t next, double) {
      if (mark[next] == 1) {
        mark[next] = 2;
        piece.push_back(next);
      }
    });
  }
  return piece;
}

/// The shortest chain of free cells from one place to another.
class WaysTo {
 public:
  /// Whose middles are at least `off` [m] from all fences.
  WaysTo(const FreeSpace& space, const PlanePoint& from, const PlanePoint& to, double off)
      : raster_(space.raster()), start_(raster_.At(from)), off_(off) {
    next_.assign(raster_.clearance.size(), kNowhere);
    const auto goal = raster_.At(to);
    if (start_ && goal) Spread(*goal);
  }

  /// The cells between the two; empty if there is no way.
  [[nodiscard]] std::vector<PlanePoint> Chain() const {
    std::vector<PlanePoint> chain;
    if (!start_ || next_[*start_] == kNowhere) return chain;
    for (std::size_t cell = next_[*start_]; next_[cell] != cell; cell = next_[cell]) {
      chain.push_back(raster_.Center(cell));
    }
    return chain;
  }

 private:
  void Spread(std::size_t goal) {
    using Entry = std::pair<double, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    std::vector<double> cost(next_.size(), std::numeric_limits<double>::infinity());
    cost[goal] = 0.0;
    next_[goal] = goal;
    open.emplace(0.0, goal);
    while (!open.empty()) {
      const double so_far = open.top().first;
      const std::size_t cell = open.top().second;
      open.pop();
      if (so_far > cost[cell]) continue;
      EachNeighbour(raster_, cell, [&](std::size_t near, double cells) {
        // The middle of the start's own cell may lie beyond a fence.
        const bool is_free =
            static_cast<double>(raster_.clearance[near]) >= off_ || near == *start_;
        const double through = so_far + cells * raster_.cell_m;
        if (is_free && through < cost[near]) {
          cost[near] = through;
          next_[near] = cell;
          open.emplace(through, near);
        }
      });
    }
  }

  const FreeSpace::Raster& raster_;
  std::optional<std::size_t> start_;
  double off_;
  std::vector<std::size_t> next_;
};

bool IsStraightWayFree(const FreeSpace& space, const PlanePoint& from, const PlanePoint& to) {
  const PlanePoint way = to - from;
  return space.Contains(Pose2{from.x(), from.y(), std::atan2(way.y(), way.x())},
                        {.curvature = 0.0, .length = way.norm()});
}

/// 1 where there is room for a turn, in whatever piece.
std::vector<std::uint8_t> MarkRoom(const FreeSpace::Raster& raster, double radius) {
  std::vector<std::uint8_t> mark(raster.clearance.size());
  // A cell stands for all of its places: some of it may just have room.
  for (std::size_t cell = 0; cell < mark.size(); ++cell) {
    mark[cell] = static_cast<double>(raster.clearance[cell]) >= radius ? 1 : 0;
  }
  return mark;
}

/// Cells of the room that are met first from `start` through free cells, and those that are farther
/// by no more than `more` [m].
std::vector<std::size_t> RoomMetFrom(const FreeSpace::Raster& raster, std::size_t start,
                                     const std::vector<std::uint8_t>& room, double more) {
  constexpr int kUnknown = std::numeric_limits<int>::max();
  std::vector<int> steps(room.size(), kUnknown);
  std::vector<std::size_t> met, open{start};
  steps[start] = 0;
  double most = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < open.size() && steps[open[i]] <= most; ++i) {
    const int here = steps[open[i]];
    if (room[open[i]] != 0) {
      if (met.empty()) most = here + more / raster.cell_m;
      met.push_back(open[i]);
      continue;
    }
    EachNeighbour(raster, open[i], [&](std::size_t next, double) {
      if (steps[next] != kUnknown || raster.clearance[next] < 0.0F) return;
      steps[next] = here + 1;
      open.push_back(next);
    });
  }
  return met;
}

/// The largest of the pieces of `mark` that hold one of the `seeds`: 1 there, 0 elsewhere.
std::vector<std::uint8_t> LargestPiece(const FreeSpace::Raster& raster,
                                       const std::vector<std::size_t>& seeds,
                                       std::vector<std::uint8_t> mark) {
  std::vector<std::size_t> largest;
  for (const std::size_t seed : seeds) {
    if (mark[seed] != 1) continue;
    std::vector<std::size_t> piece = TakePiece(raster, seed, mark);
    if (piece.size() > largest.size()) largest = std::move(piece);
  }
  std::ranges::fill(mark, std::uint8_t{0});
  for (const std::size_t cell : largest)
    mark[cell] = 1;
  return mark;
}

/// Marks what is no farther than `cells` from a mark, along columns if `stride` is a row's length.
std::vector<std::uint8_t> Spread(const std::vector<std::uint8_t>& mark, std::size_t stride,
                                 std::size_t line, int cells) {
  std::vector<std::uint8_t> spread(mark.size(), 0);
  for (std::size_t cell = 0; cell < mark.size(); ++cell) {
    if (mark[cell] == 0) continue;
    const auto at = static_cast<int>(cell / stride % line);
    const int low = std::max(-cells, -at), high = std::min(cells, static_cast<int>(line) - 1 - at);
    for (int off = low; off <= high; ++off) {
      spread[cell + static_cast<std::size_t>(off) * stride] = 1;
    }
  }
  return spread;
}

}  // namespace

double RoomInReach(const FreeSpace& space, const FreeSpace& smaller, Meters radius, Meters reach) {
  const FreeSpace::Raster& raster = smaller.raster();
  const auto columns = static_cast<std::size_t>(raster.columns);
  const auto rows = static_cast<std::size_t>(raster.rows);
  const int cells = static_cast<int>(reach.value() / raster.cell_m) + 1;
  std::vector<std::uint8_t> near = RoomToTurn(smaller, radius.value());
  near = Spread(Spread(near, 1, columns, cells), columns, rows, cells);
  const std::vector<std::uint8_t> all = RoomToTurn(space, radius.value());
  double count = 0.0, reached = 0.0;
  for (std::size_t cell = 0; cell < all.size(); ++cell) {
    if (all[cell] == 0) continue;
    count += 1.0;
    const auto at = raster.At(space.raster().Center(cell));
    reached += at && near[*at] != 0 ? 1.0 : 0.0;
  }
  return count > 0.0 ? reached / count : 0.0;
}

std::vector<std::uint8_t> RoomToTurn(const FreeSpace& space, double radius) {
  std::vector<std::size_t> all(space.raster().clearance.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return LargestPiece(space.raster(), all, MarkRoom(space.raster(), radius));
}

std::vector<std::uint8_t> RoomToTurnFrom(const FreeSpace& space, const PlanePoint& from,
                                         double radius) {
  const FreeSpace::Raster& raster = space.raster();
  std::vector<std::uint8_t> room = MarkRoom(raster, radius);
  const auto start = raster.At(from);
  if (!start) return LargestPiece(raster, {}, std::move(room));
  const std::vector<std::size_t> met = RoomMetFrom(raster, *start, room, radius);
  return LargestPiece(raster, met, std::move(room));
}

std::optional<PlanePoint> NearestRoom(const FreeSpace& space, const PlanePoint& from,
                                      double radius) {
  const std::vector<std::uint8_t> room = RoomToTurn(space, radius);
  std::optional<PlanePoint> nearest;
  for (std::size_t cell = 0; cell < room.size(); ++cell) {
    const PlanePoint place = space.raster().Center(cell);
    if (room[cell] != 0 && (!nearest || (place - from).norm() < (*nearest - from).norm())) {
      nearest = place;
    }
  }
  return nearest;
}

std::optional<std::vector<PlanePoint>> LegsThrough(const FreeSpace& space, const PlanePoint& from,
                                                   const PlanePoint& to) {
  if (!space.Contains(from) || !space.Contains(to)) return std::nullopt;
  if (IsStraightWayFree(space, from, to)) return std::vector<PlanePoint>{to};
  constexpr double kClearance = 1.0;  // [m]
  std::vector<PlanePoint> chain = WaysTo(space, from, to, kClearance).Chain();
  if (chain.empty()) chain = WaysTo(space, from, to, 0.0).Chain();
  if (chain.empty()) return std::nullopt;
  chain.push_back(to);
  // Pulled tight: from each place the farthest of the chain that is in sight.
  std::vector<PlanePoint> legs;
  PlanePoint here = from;
  for (std::size_t at = 0; at < chain.size();) {
    std::size_t farthest = at;
    for (std::size_t next = chain.size(); next-- > at + 1;) {
      if (IsStraightWayFree(space, here, chain[next])) {
        farthest = next;
        break;
      }
    }
    here = chain[farthest];
    legs.push_back(here);
    at = farthest + 1;
  }
  return legs;
}

}  // namespace limpet

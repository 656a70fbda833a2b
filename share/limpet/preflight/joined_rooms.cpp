// SPDX-License-Identifier: MIT
#include "limpet/preflight/joined_rooms.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace limpet {
namespace {

constexpr int kCourses = 180;
/// Straight ways tested exactly: beyond it no more passages are looked for.
constexpr int kMostTested = 20'000;

class RoomJoiner {
 public:
  RoomJoiner(const FreeSpace& space, double radius)
      : space_(space), raster_(space.raster()), radius_(radius) {
    Label();
  }

  JoinedRooms JoinedTo(const std::vector<std::uint8_t>& room) {
    passage_.assign(piece_of_.size(), 0);
    is_reached_.assign(static_cast<std::size_t>(pieces_) + 1, 0);
    for (std::size_t cell = 0; cell < room.size(); ++cell) {
      if (room[cell] != 0) Reach(piece_of_[cell]);
    }
    for (std::size_t i = 0; i < reached_.size() && pieces_ > 1; ++i)
      LeaveFrom(reached_[i]);
    JoinedRooms joined{.room = room, .passage = std::move(passage_)};
    for (std::size_t cell = 0; cell < joined.room.size(); ++cell) {
      if (piece_of_[cell] != 0 && is_reached_[piece_of_[cell]] != 0) joined.room[cell] = 1;
    }
    return joined;
  }

 private:
  using Piece = std::uint32_t;  ///< 0: no room to turn

  [[nodiscard]] bool HasRoom(std::size_t cell) const {
    return static_cast<double>(raster_.clearance[cell]) >= radius_;
  }

  template <class Visit>
  void EachNeighbour(std::size_t cell, Visit visit) const {
    const auto columns = static_cast<std::size_t>(raster_.columns);
    const std::size_t row = cell / columns, column = cell % columns;
    for (std::size_t r = row > 0 ? row - 1 : 0; r <= row + 1; ++r) {
      for (std::size_t c = column > 0 ? column - 1 : 0; c <= column + 1 && c < columns; ++c) {
        const std::size_t next = r * columns + c;
        if (next < piece_of_.size() && next != cell) visit(next);
      }
    }
  }

  void Label() {
    piece_of_.assign(raster_.clearance.size(), 0);
    std::vector<std::size_t> open;
    for (std::size_t seed = 0; seed < piece_of_.size(); ++seed) {
      if (piece_of_[seed] != 0 || !HasRoom(seed)) continue;
      piece_of_[seed] = ++pieces_;
      open.assign(1, seed);
      while (!open.empty()) {
        const std::size_t cell = open.back();
        open.pop_back();
        EachNeighbour(cell, [&](std::size_t next) {
          if (piece_of_[next] != 0 || !HasRoom(next)) return;
          piece_of_[next] = pieces_;
          open.push_back(next);
        });
      }
    }
  }

  void Reach(Piece piece) {
    if (piece == 0 || is_reached_[piece] != 0) return;
    is_reached_[piece] = 1;
    reached_.push_back(piece);
  }

  [[nodiscard]] Piece PieceAt(const PlanePoint& at) const {
    const auto cell = raster_.At(at);
    return cell ? piece_of_[*cell] : 0;
  }

  /// Tries every tangent off the turns around the piece's rim that leads out of it.
  void LeaveFrom(Piece piece) {
    for (std::size_t cell = 0; cell < piece_of_.size() && tested_ < kMostTested; ++cell) {
      if (piece_of_[cell] != piece) continue;
      bool is_rim = false;
      EachNeighbour(cell, [&](std::size_t next) { is_rim = is_rim || piece_of_[next] != piece; });
      if (!is_rim) continue;
      for (int i = 0; i < kCourses; ++i) {
        const double course = 2.0 * std::numbers::pi * i / kCourses;
        const PlanePoint along(std::cos(course), std::sin(course));
        const PlanePoint centre = raster_.Center(cell);
        // A course that stays in the piece is tried where it leaves it.
        if (PieceAt(centre + raster_.cell_m * along) == piece) continue;
        const PlanePoint aside(-along.y(), along.x());
        for (const double side : {-radius_, radius_}) {
          Follow({.piece = piece, .from = centre + side * aside, .along = along, .course = course});
        }
      }
    }
  }

  struct Tangent {
    Piece piece;
    PlanePoint from, along;
    double course;
  };

  /// Straight on until a turn of another piece can be taken, or a fence is in the way.
  void Follow(const Tangent& tangent) {
    const PlanePoint aside(-tangent.along.y(), tangent.along.x());
    for (double way = 0.0;; way += raster_.cell_m) {
      const PlanePoint at = tangent.from + way * tangent.along;
      const auto cell = raster_.At(at);
      if (!cell || static_cast<double>(raster_.clearance[*cell]) < -raster_.slack()) return;
      for (const double side : {-radius_, radius_}) {
        const Piece next = PieceAt(at + side * aside);
        if (next == 0 || next == tangent.piece) continue;
        Join(tangent, next, way);
        return;
      }
    }
  }

  void Join(const Tangent& tangent, Piece next, double way) {
    ++tested_;
    const Pose2 from{tangent.from.x(), tangent.from.y(), tangent.course};
    if (!space_.Contains(from, {.curvature = 0.0, .length = way})) return;
    for (double s = 0.0; s <= way; s += raster_.cell_m) {
      if (const auto cell = raster_.At(tangent.from + s * tangent.along)) passage_[*cell] = 1;
    }
    Reach(next);
  }

  const FreeSpace& space_;
  const FreeSpace::Raster& raster_;
  double radius_;
  Piece pieces_ = 0;
  std::vector<Piece> piece_of_;  ///< of each cell
  std::vector<std::uint8_t> is_reached_, passage_;
  std::vector<Piece> reached_;  ///< in the order in which they were
  int tested_ = 0;
};

}  // namespace

JoinedRooms JoinRooms(const FreeSpace& space, const std::vector<std::uint8_t>& room,
                      double radius) {
  return RoomJoiner(space, radius).JoinedTo(room);
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "limpet/planning/ground.hpp"
#include "limpet/planning/pose2.hpp"
#include "limpet/survey/simple_polygon.hpp"
#include "limpet/topics/mission.hpp"

namespace limpet {

/// What of the seabed and of the band's top a sequence of motions has seen: one bit per cell and
/// plane, with undo. Made for searches over whole missions, which sweep the area thousands of
/// times: a straight motion is one rectangle, cells are counted 64 at a time, and nothing is
/// allocated after construction but for the undo log's growth.
class SeenPlanes {
 public:
  static constexpr std::size_t kBottom = 0, kTop = 1, kPlanes = 2;
  using Counts = std::array<int, kPlanes>;
  /// Layer of the band that each plane is.
  static constexpr std::array<int, kPlanes> kLayerOf{0, Footprint::kTop};

  /// Cells of a plane: bits of one of its words.
  struct Bits {
    std::size_t word = 0;
    std::uint64_t bits = 0;
  };
  /// A moment to go back to.
  struct Moment {
    std::array<std::size_t, kPlanes> noted{};  ///< cells of each plane's log
    Counts unseen{};
  };

  explicit SeenPlanes(const Ground& ground);
  /// Takes over the ground's present state and forgets all motions. REQUIRES: the same ground.
  void Reset(const Ground& ground);

  /// Cells not yet seen, of each plane.
  [[nodiscard]] const Counts& unseen() const { return unseen_; }
  /// Sees what the image at `at` shows.
  void Look(const Pose2& at);
  /// Sees what the images of `segment` show, from its start to its end, beside what the one at
  /// `from` does: that has been looked at before.
  void Sweep(const Pose2& from, const PathSegment& segment);

  /// Sees these cells of `plane`.
  void See(std::size_t plane, std::span<const Bits> cells);

  [[nodiscard]] Moment Mark() const { return {.noted = noted_, .unseen = unseen_}; }
  /// What of `plane` has newly been seen since `noted`, as Moment counts. Good until more is seen.
  [[nodiscard]] std::span<const Bits> Since(std::size_t plane, std::size_t noted) const {
    return std::span(logs_[plane]).subspan(noted, noted_[plane] - noted);
  }
  /// Takes back everything since then.
  void Rewind(const Moment& then);

  /// Centre of the cell of `plane` that is the `n`-th that is not seen, row by row.
  /// REQUIRES: n < unseen()[plane].
  [[nodiscard]] PlanePoint NthUnseen(std::size_t plane, int n) const;
  /// Calls visit(north, east) at the centre of each cell of `plane` that is not seen.
  template <class Visit>
  void EachUnseen(std::size_t plane, Visit visit) const {
    for (int row = 0; row < frame_.rows; ++row) {
      for (int column = 0; column < frame_.columns; ++column) {
        const std::uint64_t word = planes_[plane][Word(row, column)];
        if ((word >> (static_cast<unsigned>(column) % 64U) & 1U) == 0) {
          visit(frame_.north_min + (row + 0.5) * frame_.cell_m,
                frame_.east_min + (column + 0.5) * frame_.cell_m);
        }
      }
    }
  }

 private:
  struct Image {
    double half_along = 0.0, half_across = 0.0;  ///< [cells]
  };
  /// A place in the grid and the direction of flight there.
  struct Place {
    double row = 0.0, column = 0.0;  ///< [cells], from the centre of cell (0, 0)
    double cos = 1.0, sin = 0.0;
  };
  [[nodiscard]] std::size_t Word(int row, int column) const {
    return static_cast<std::size_t>(row) * words_per_row_ + static_cast<std::size_t>(column) / 64;
  }
  [[nodiscard]] Place PlaceOf(const Pose2& pose) const;
  void SweepStraight(const Place& from, double length);
  void SweepTurn(const Pose2& from, const PathSegment& segment);
  /// The images on a stretch of the way; lengths in cells.
  struct Stretch {
    double lead = 0.0;    ///< from this far behind the first one's front
    double length = 0.0;  ///< of the stretch
  };
  /// Marks what the images on a stretch that begins at `at` show.
  void LookAhead(std::size_t plane, const Place& at, const Stretch& stretch);
  void Show(std::size_t plane, const Place& middle, const Image& image);
  void SetRun(std::size_t plane, int row, int begin, int end);
  /// Makes room in the log for `more`.
  void Reserve(std::size_t plane, std::size_t more);
  void SetBits(std::size_t plane, std::size_t word, std::uint64_t bits);
  void Copy(const Ground& ground);

  GridFrame frame_;
  std::array<Image, kPlanes> images_;
  std::size_t words_per_row_;
  std::array<std::vector<std::uint64_t>, kPlanes> planes_;  ///< 1: seen, or not wanted
  Counts unseen_{};
  /// The ground's state, as it was copied last, and its version then.
  std::array<std::vector<std::uint64_t>, kPlanes> copied_;
  Counts unseen_as_copied_{};
  std::optional<std::uint64_t> version_;
  /// What has newly been seen, in order, and room for more.
  std::array<std::vector<Bits>, kPlanes> logs_;
  std::array<std::size_t, kPlanes> noted_{};  ///< how much of each log is taken
};

}  // namespace limpet

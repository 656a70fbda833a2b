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
#include "limpet/planning/seen_planes.hpp"

namespace limpet {

/// A motion in pieces that are short enough to count by their middles.
struct SweptMotion {
  struct Piece {
    Pose2 from;
    PathSegment motion;
    std::array<std::size_t, SeenPlanes::kPlanes> shown_end{};  ///< in `shown` of each plane
  };
  std::vector<Piece> pieces;
  /// Cells that the images of the motion show and the ground's state lacks, each once, piece by
  /// piece; of each plane.
  std::array<std::vector<SeenPlanes::Bits>, SeenPlanes::kPlanes> shown;

  /// The cells of `plane` that the i-th piece shows and those before it do not.
  [[nodiscard]] std::span<const SeenPlanes::Bits> ShownBy(std::size_t i, std::size_t plane) const {
    const std::size_t begin = i == 0 ? 0 : pieces[i - 1].shown_end[plane];
    return std::span(shown[plane]).subspan(begin, pieces[i].shown_end[plane] - begin);
  }
};

/// What motions over a ground show. Tours that are compared differ in a motion or two, and to find
/// the cells in a motion's images takes much longer than to count which of them are new: they are
/// found once. Of motions that fall into the same place the newest stays, so that its size does not
/// grow.
class SweepMemory {
 public:
  explicit SweepMemory(const Ground& ground) : blank_(ground), known_(kPlaces) { Reset(ground); }
  /// Forgets all motions if the ground has changed. REQUIRES: the same ground.
  void Reset(const Ground& ground);

  /// The motion from `from` along `segment`. Good until the next call.
  [[nodiscard]] const SweptMotion& Of(const Pose2& from, const PathSegment& segment);

 private:
  static constexpr std::size_t kPlaces = 4096;
  struct Known {
    Pose2 from;
    PathSegment segment;
    SweptMotion motion;
    bool is_known = false;
  };
  void Trace(const Pose2& from, const PathSegment& segment, SweptMotion& motion);

  SeenPlanes blank_;  ///< the ground's state, before and after each call
  std::optional<std::uint64_t> version_;
  std::vector<Known> known_;
};

}  // namespace limpet

// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "limpet/planning/dubins_path.hpp"
#include "limpet/planning/ground.hpp"

namespace limpet {

/// What a motion would newly show, each cell once, weighted means over the layers of the band.
struct NewlySeen {
  double new_area = 0.0;         ///< [m^2]
  double frontier_growth = 0.0;  ///< of the border between seen and unseen [m]; the area's edge
                                 ///< counts as seen
  double delay = 0.0;            ///< of each m^2 the path before it is seen, summed [m^3]

  NewlySeen& operator+=(const NewlySeen& other) {
    new_area += other.new_area;
    frontier_growth += other.frontier_growth;
    delay += other.delay;
    return *this;
  }
};

/// Levels of the cells that motions raise one after another, with undo. Works on its own copy of a
/// ground's levels and allocates nothing after construction.
class SeenWorkspace {
 public:
  explicit SeenWorkspace(const Ground& ground);
  /// Takes over the ground's levels again and forgets all motions.
  void Reset(const Ground& ground);

  /// Spacing of the images that stand for the swept motion [m].
  static constexpr double kStep = 0.5;

  /// Sweeps from `from` along `segment`: images every kStep and at the end, not at the start.
  NewlySeen Sweep(const Pose2& from, const PathSegment& segment);
  /// One image.
  NewlySeen Look(const Pose2& at);
  /// A mark for Rewind.
  [[nodiscard]] std::size_t Mark() const { return changes_.size(); }
  /// Takes back everything since `mark`.
  void Rewind(std::size_t mark);
  /// Cells raised so far and their level before, oldest first.
  struct Change {
    std::uint32_t cell = 0;
    std::uint8_t before = 0;
    std::uint8_t after = 0;
  };
  [[nodiscard]] std::span<const Change> changes() const { return changes_; }
  /// Raises cells as another workspace of the same ground did; no gain is counted.
  void Replay(std::span<const Change> changes);

 private:
  struct Span {
    int begin = 0, end = 0;
  };
  class RowSlicer;
  void LookRow(int row, const std::array<Span, Footprint::kLayers>& spans);
  void RaiseSpan(int row, Span span, std::uint8_t level);
  void Raise(std::size_t cell, std::uint8_t level);
  [[nodiscard]] NewlySeen TakeGain();

  GridFrame frame_;
  Footprint footprint_;
  std::size_t stride_;                ///< of the padded levels
  std::vector<std::uint8_t> levels_;  ///< padded by a ring of fully seen cells
  std::vector<Change> changes_;
  std::array<double, Footprint::kLayers + 1> worth_{};  ///< weight of a cell's lowest layers
  double raised_ = 0.0;                                 ///< weight gained since the last call
  double border_ = 0.0;                                 ///< weight of the edges between cells
};

/// What a path would newly show. The workspace is reused from call to call: one per user.
class SeenAlong {
 public:
  /// `ground` must outlive this; its updates are followed.
  explicit SeenAlong(const Ground& ground)
      : ground_(ground), workspace_(ground), version_(ground.version()) {}
  [[nodiscard]] NewlySeen operator()(const DubinsPath& path);

  /// Calls visit(from, segment, length before it, what it newly shows) for each segment of `path`.
  template <class Visit>
  void EachStep(const DubinsPath& path, Visit visit) {
    Follow();
    Pose2 from = path.start();
    double before = 0.0;
    for (const PathSegment& segment : path.segments()) {
      visit(from, segment, before, workspace_.Sweep(from, segment));
      from = Advance(from, segment);
      before += segment.length;
    }
    workspace_.Rewind(0);
  }

 private:
  /// Takes over the ground if it has changed.
  void Follow();

  const Ground& ground_;
  SeenWorkspace workspace_;
  std::uint64_t version_;
};

}  // namespace limpet

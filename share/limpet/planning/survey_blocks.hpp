// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "limpet/planning/ground.hpp"
#include "limpet/survey/simple_polygon.hpp"
#include "limpet/survey/survey_grid.hpp"
#include "limpet/survey/view_cone.hpp"

namespace limpet {

/// A survey too large to be planned at once, cut into blocks that are planned one after the other:
/// rows of about square blocks, flown to and fro from the corner where the vehicle comes in. So
/// time and memory of a decision go with a block, however large the area is.
class SurveyBlocks {
 public:
  /// Areas with more ground, or whose box is larger, are cut [m^2].
  static constexpr double kMostGround = 12'000.0, kMostBox = 100'000.0;
  /// A block is done when so much of the band's top has been seen: what is left are slivers.
  static constexpr double kDoneShare = 0.975;

  /// `footprint` says how wide lanes are: blocks hold whole numbers of them.
  SurveyBlocks(const SurveyGrid& grid, const Footprint& footprint);

  /// One block, the area.
  [[nodiscard]] bool is_whole() const { return is_whole_; }
  [[nodiscard]] std::size_t count() const { return blocks_.size(); }
  /// The block to be planned.
  [[nodiscard]] const CellBox& now() const { return blocks_[now_]; }
  /// Of the grid's cells, along the side of those that plans are made on: images are then about
  /// as many of these wide as in a survey from low above the bottom.
  [[nodiscard]] int cells_per_side() const { return cells_per_side_; }
  /// Counted from 0, in the order in which they are flown.
  [[nodiscard]] std::size_t index() const { return now_; }
  /// Blocks left with more than slivers unseen: they took far too long, or the plan gave them up.
  [[nodiscard]] std::size_t passed_over() const { return passed_over_; }
  /// Middle of the next block, NED [m]; nothing at the last one.
  [[nodiscard]] std::optional<PlanePoint> Onward() const;

  /// What of this block is unseen is not worth its way, by the plan of it. Counts once the vehicle
  /// has been there: else one that finds no way at all would give up all of them.
  void GiveUp() { is_given_up_ = true; }
  /// Goes on to the next block if this one, of which `ground` is a copy, is done, given up, or has
  /// taken several times the way that it should; true if so. `at` is the vehicle, `travelled` its
  /// way since some fixed moment [m].
  bool GoOn(const Ground& ground, const PlanePoint& at, double travelled);

 private:
  void PutInOrderFrom(const PlanePoint& at);
  [[nodiscard]] PlanePoint MiddleOf(const CellBox& block) const;
  [[nodiscard]] bool IsNear(const PlanePoint& at) const;

  GridFrame frame_;
  int cells_per_side_ = 1;
  bool is_whole_ = true, is_ordered_ = false, is_given_up_ = false;
  std::vector<CellBox> blocks_;  ///< row by row from the south-west, then in order
  std::size_t now_ = 0, passed_over_ = 0;
  std::optional<double> leave_at_;  ///< travelled; known once the block is reached [m]
};

}  // namespace limpet

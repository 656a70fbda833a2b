// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "limpet/core/camera_model.hpp"

namespace limpet {

/// What varies slowly over an image: layers of numbers at the corners of blocks of kBlock pixels,
/// and for each corner a place on the seabed. A row of the image is drawn from the layers at its
/// height.
class CornerGrid {
 public:
  static constexpr int kBlock = 8;
  /// Middles of a block's pixels, as shares of the way from its corner to the next one.
  static constexpr std::array<float, kBlock> kShare{0.0625F, 0.1875F, 0.3125F, 0.4375F,
                                                    0.5625F, 0.6875F, 0.8125F, 0.9375F};

  /// A grid over the image of `camera`.
  CornerGrid(const CameraModel& camera, std::size_t layers);

  [[nodiscard]] std::size_t columns() const { return columns_; }
  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] float& node(int layer, int column, int row) {
    return nodes_[(static_cast<std::size_t>(row) * layers_ + static_cast<std::size_t>(layer)) *
                      columns_ +
                  static_cast<std::size_t>(column)];
  }
  /// Two coordinates on the seabed [m]; which ones, its user says.
  [[nodiscard]] Eigen::Vector2f& place(int column, int row) {
    return places_[static_cast<std::size_t>(row) * columns_ + static_cast<std::size_t>(column)];
  }

  /// Calls look(column, row, distance) for every corner. It starts from the distance that its
  /// neighbour ended with; the first one from some metres.
  template <class Look>
  void EachCorner(const Look& look) {
    double first = 4.0;
    for (int row = 0; row < static_cast<int>(rows_); ++row) {
      double distance = first;
      for (int column = 0; column < static_cast<int>(columns_); ++column) {
        look(column, row, distance);
        first = column == 0 ? distance : first;
      }
    }
  }
  /// Multiplies three layers from `first` on by left_over(squared distance of a corner's place from
  /// `middle`); 1 leaves a corner as it is.
  template <class LeftOver>
  void Dim(int first, const Eigen::Vector2f& middle, const LeftOver& left_over) {
    for (int row = 0; row < static_cast<int>(rows_); ++row) {
      for (int column = 0; column < static_cast<int>(columns_); ++column) {
        const float share = left_over((place(column, row) - middle).squaredNorm());
        if (share == 1.0F) continue;
        for (int c = 0; c < 3; ++c)
          node(first + c, column, row) *= share;
      }
    }
  }

  /// The layers at the height of an image row, for what follows.
  void TakeRow(int row);
  /// A layer's numbers there, one per column of corners.
  [[nodiscard]] const float* at_row(std::size_t layer) const { return &row_[layer * columns_]; }
  /// Two layers as whole numbers at the first pixel of a block, and from one pixel to the next.
  struct Steps {
    std::int32_t u, v, step_u, step_v;
  };
  /// Steps along a block, in units of 1/`finer` of the layers' own.
  [[nodiscard]] Steps StepsIn(std::size_t block, const float* u, const float* v,
                              float finer = 1.0F) const {
    const float per_pixel = finer / kBlock;
    const auto step_u = static_cast<std::int32_t>((u[block + 1] - u[block]) * per_pixel);
    const auto step_v = static_cast<std::int32_t>((v[block + 1] - v[block]) * per_pixel);
    return {static_cast<std::int32_t>(u[block] * finer) + step_u / 2,
            static_cast<std::int32_t>(v[block] * finer) + step_v / 2, step_u, step_v};
  }

 private:
  std::size_t columns_, rows_, layers_;
  std::vector<float> nodes_;  ///< layers by row of corners
  std::vector<Eigen::Vector2f> places_;
  std::vector<float> row_;  ///< layers at the height of one image row
};

}  // namespace limpet

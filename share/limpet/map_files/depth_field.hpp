// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "limpet/map_files/depth_grid.hpp"

namespace limpet {

/// How much depths some way apart have in common: as rough ground, exponential, or as smooth
/// ground, Matern of order 3/2.
struct DepthCovariance {
  double variance_m2 = 0.0, range_m = 1.0;
  bool is_smooth = false;
  [[nodiscard]] double At(double distance_m) const;
};

/// Depth of the seabed where a session knows it, and close beside that: by ordinary kriging
/// [Matheron 1963] of the columns around, less the plane through all of them. How much depth
/// varies over a distance is learnt from the grid itself, so that smooth ground tells more of what
/// lies beside it than rough ground does.
class DepthField {
 public:
  /// Columns farther away tell nothing [m].
  static constexpr double kReach = 0.6;

  /// `grid` must outlive this.
  explicit DepthField(const DepthGrid& grid);

  struct Depth {
    double down_m = 0.0;
    double sigma_m = 0.0;  ///< beside what the whole session is off by
  };
  /// The column's own depth where beams ended in it; else of those within kReach, if there are two
  /// or more of them.
  [[nodiscard]] std::optional<Depth> At(const Eigen::Vector2d& p_W) const;

 private:
  struct Neighbour {
    Eigen::Vector2d p_W;
    double off_m = 0.0;  ///< from the plane
    double sigma_m = 0.0;
    double distance_m = 0.0;
  };

  [[nodiscard]] Eigen::Vector2d MiddleOf(int row, int column) const;
  [[nodiscard]] double PlaneAt(const Eigen::Vector2d& p_W) const;
  void FitPlane();
  void FitVariogram();
  [[nodiscard]] std::vector<Neighbour> NeighboursOf(const Eigen::Vector2d& p_W) const;
  [[nodiscard]] Depth Krige(const std::vector<Neighbour>& neighbours,
                            const Eigen::Vector2d& p_W) const;

  const DepthGrid& grid_;
  Eigen::Vector3d plane_ = Eigen::Vector3d::Zero();  ///< per metre north and east, at the origin
  DepthCovariance covariance_{};                     ///< of what is left
};

}  // namespace limpet

// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <Eigen/Core>

namespace limpet {

/// What stands on the seabed with upright walls and a level top, and that a vehicle must not meet:
/// a column or a box whose sides run north and east.
class UprightBody {
 public:
  /// A column's radius and the NED depth of its top [m].
  struct Round {
    double radius = 0.5, top = 0.0;
  };
  /// `top` is the NED depth of its top [m]; downwards it has no end.
  [[nodiscard]] static UprightBody Column(const Eigen::Vector2d& center_W, const Round& column) {
    return {center_W, Eigen::Vector2d::Constant(column.radius), column.top, true};
  }
  [[nodiscard]] static UprightBody Box(const Eigen::Vector2d& center_W,
                                       const Eigen::Vector2d& half_size_W, double top) {
    return {center_W, half_size_W, top, false};
  }

  /// Distance [m] along a ray (`direction_W` of unit length) to where it first meets wall or top;
  /// 0 from within, nothing if it meets neither.
  [[nodiscard]] std::optional<double> Range(const Eigen::Vector3d& origin_W,
                                            const Eigen::Vector3d& direction_W) const;
  /// Whether it stands between two places.
  [[nodiscard]] bool IsBetween(const Eigen::Vector3d& from_W, const Eigen::Vector3d& to_W) const;
  /// How far a place is from it [m]; 0 within.
  [[nodiscard]] double Distance(const Eigen::Vector3d& at_W) const;
  /// Whether it stands on this ground.
  [[nodiscard]] bool Covers(const Eigen::Vector2d& p_W) const { return Aside(p_W) <= 0.0; }
  [[nodiscard]] const Eigen::Vector2d& center_W() const { return center_W_; }
  /// Half of what it measures northwards and eastwards [m]; a column has its radius twice.
  [[nodiscard]] const Eigen::Vector2d& half_size() const { return half_size_; }
  [[nodiscard]] bool is_column() const { return is_column_; }
  [[nodiscard]] double top() const { return top_; }

 private:
  /// A piece of a ray, in its own lengths.
  struct Piece {
    double first, last;
  };
  UprightBody(const Eigen::Vector2d& center_W, const Eigen::Vector2d& half_size_W, double top,
              bool is_column)
      : center_W_(center_W), half_size_(half_size_W), top_(top), is_column_(is_column) {}

  /// How far a place is from the ground that it stands on [m]; 0 on it.
  [[nodiscard]] double Aside(const Eigen::Vector2d& at_W) const;
  /// What of a line lies over that ground.
  [[nodiscard]] std::optional<Piece> Over(const Eigen::Vector2d& from_center_W,
                                          const Eigen::Vector2d& direction_W) const;

  Eigen::Vector2d center_W_;
  Eigen::Vector2d half_size_;
  double top_;
  bool is_column_;
};

}  // namespace limpet

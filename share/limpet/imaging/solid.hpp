// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace limpet {

/// Kinds of objects. Each is a form around the z axis of its own frame S, its middle at the origin.
enum class SolidKind { kSphere, kCylinder, kCone, kBox, kTyre };

/// "sphere", "cylinder", "cone", "box", "tyre"; nothing for any other word.
[[nodiscard]] std::optional<SolidKind> SolidKindOf(std::string_view name);
[[nodiscard]] std::vector<std::string> SolidKindNames();

/// A painted object in the water.
struct Solid {
  SolidKind kind = SolidKind::kSphere;
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();       ///< middle, NED [m]
  Eigen::Matrix3d R_WS = Eigen::Matrix3d::Identity();  ///< its z axis points down if upright
  double radius =
      0.5;  ///< of the foot of a cone, the outside of a tyre; half the side of a box [m]
  double height = 1.0;       ///< along z; of a tyre its width; spheres have none [m]
  double top_share = 0.5;    ///< radius of a cone's top over that of its foot
  std::string color{};       ///< a name of `color_table.hpp`
  std::string band_color{};  ///< of the middle third along z; "": no band

  /// Distance of `p_S` from the surface [m]: below 0 inside, 0 on it; outside exact for spheres
  /// and tyres, else at most exact, so that steps of this length never jump over the surface.
  [[nodiscard]] double DistanceTo(const Eigen::Vector3d& p_S) const;
  /// Unit vector along which that distance grows, outwards.
  [[nodiscard]] Eigen::Vector3d NormalAt(const Eigen::Vector3d& p_S) const;
  /// The farthest that the form reaches along `n_S`: its support function [m].
  [[nodiscard]] double ReachAlong(const Eigen::Vector3d& n_S) const;
  /// Radius of the smallest sphere around its middle that holds it [m].
  [[nodiscard]] double BoundingRadius() const;
  /// Half of its height as it stands [m]: how far its lowest point is below its middle.
  [[nodiscard]] double ReachDown() const { return ReachAlong(R_WS.transpose().col(2)); }
};

}  // namespace limpet

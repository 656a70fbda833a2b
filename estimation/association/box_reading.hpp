// SPDX-License-Identifier: MIT
// What a box says about the sphere it shows.
#pragma once

#include <array>
#include <optional>

#include <Eigen/Core>

#include "estimation/smoothing/factors/cut_axis_factor.hpp"
#include "limpet/objects/box.hpp"

namespace limpet {

struct BoxNoise {
  double floor_px = 2.0;        ///< 1-sigma of a sure box's centre [px]
  double share_of_size = 0.02;  ///< further share of the box's size
  double doubt = 2.0;           ///< times (1 + doubt (1 - confidence))
  double edge_share = 0.05;     ///< of the size: 1-sigma of one edge, on top of the centre's
  /// Where less than half of a sphere may show, that share times (1 + cap_doubt (sure_cap -
  /// confidence)) below that confidence: of a mere cap a detector may take a part for it, and is
  /// then not sure.
  double cap_doubt = 20.0, sure_cap = 0.75;
  double range_floor_m = 0.05;  ///< 1-sigma of the range from size [m]
  double range_share = 0.12;    ///< further share of the range
};

/// Direction and, where an axis shows a whole diameter, distance of a sphere's centre.
struct BoxReading {
  /// Pixel of the mid-angle between the box's edges, per axis: where a sphere's centre projects,
  /// whatever its radius; the centre of its box is not that place.
  Eigen::Vector2d centre_px = Eigen::Vector2d::Zero();
  Eigen::Vector2d sigma_px = Eigen::Vector2d::Zero();  ///< infinite along an axis that is cut
  Eigen::Vector2d half_angle = Eigen::Vector2d::Zero();
  bool is_cut_u = false, is_cut_v = false;
  /// Measurements along the axes (u, v) on which the image's border cuts the box.
  std::array<std::optional<CutAxisFactor::Measurement>, 2> cut_axes;

  /// Planes (xz, yz) of the camera that tell the sphere's size: both of a whole box; of one cut at
  /// one end only, the free axis' if more than half of the sphere shows; else none.
  Eigen::Vector2d size_planes_C = Eigen::Vector2d::Zero();

  [[nodiscard]] bool tells_size() const { return size_planes_C.sum() > 0.0; }
  [[nodiscard]] bool is_whole() const { return !is_cut_u && !is_cut_v; }
  /// True if the box tells the place of a sphere of `radius` (0: unknown): it shows on one axis its
  /// centre, or on both an edge.
  [[nodiscard]] bool TellsPlace(double radius) const {
    if (!is_cut_u || !is_cut_v) return true;
    return radius > 0.0 && cut_axes[0]->box.is_half_cut() && cut_axes[1]->box.is_half_cut();
  }
  /// Distance in those planes [m] of a sphere of `radius`, their mean if both tell.
  [[nodiscard]] std::optional<double> Range(double radius) const;
};

[[nodiscard]] BoxReading ReadBox(const Box& box, const CameraModel& camera, const BoxNoise& noise);

}  // namespace limpet

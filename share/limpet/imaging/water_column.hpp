// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "limpet/core/units.hpp"
#include "limpet/simulation/image_params.hpp"

namespace limpet {

/// What water does to light on its way from the surface to things, from things to the lens, and
/// what it adds, for blue, green and red (450, 530, 610 nm). The image of a thing is
///   I = J exp(-c r) + B (1 - exp(-(c + K w) r)),
/// direct light and backscatter with coefficients of their own [Akkaynak 2018]: c = a + b of
/// absorption and scattering dims what comes straight; the veil is lit by daylight that itself
/// fades by K per metre of depth, so along a ray that goes down by w per metre it gathers
/// exp(-K w s) exp(-c s) ds. The sum of both is the image model of [Jaffe 1990] without its glow.
class WaterColumn {
 public:
  /// `visibility`: where the clearest channel keeps 5 % of a contrast.
  /// REQUIRES: visibility > 0, dissolved >= 0, backscatter >= 0.
  WaterColumn(Meters visibility, const ImageParams::Water& water);

  [[nodiscard]] Eigen::Array3f scattering() const { return scattering_.head<3>(); }  ///< b [1/m]

  /// Share of a thing's light that reaches the lens from `range` [m].
  [[nodiscard]] Eigen::Array3f Direct(double range) const {
    return (-static_cast<float>(range) * beam_).exp().head<3>();
  }
  /// Share of the surface's daylight that is left at `depth` [m].
  [[nodiscard]] Eigen::Array3f Daylight(double depth) const {
    return (-static_cast<float>(depth > 0.0 ? depth : 0.0) * diffuse_).exp().head<3>();
  }
  /// Daylight that the water before a thing at `range` [m] sends into a lens, along a ray of unit
  /// length, over what a white surface beside the lens would return.
  [[nodiscard]] Eigen::Array3f Veil(double range, const Eigen::Vector3d& ray_W) const {
    // A ray that goes up meets more and more daylight; c still ends what the eye sees of it.
    const Four gathering = (beam_ + static_cast<float>(ray_W.z()) * diffuse_).max(0.25F * beam_);
    const Four gathered = 1.0F - (-static_cast<float>(range) * gathering).exp();
    return (backscatter_ * gathered / gathering).head<3>();
  }
  /// Light scattered back per metre of ray under irradiance 1, as Veil counts it [1/m].
  [[nodiscard]] Eigen::Array3f BackscatterPerMeter() const { return backscatter_.head<3>(); }

 private:
  using Four = Eigen::Array4f;  ///< blue, green, red and one that counts for nothing: one register
  Four scattering_, beam_, diffuse_, backscatter_;
};

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/imaging/water_column.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "limpet/core/require.hpp"
#include "limpet/vision/water_optics.hpp"

namespace limpet {
namespace {

constexpr std::array<double, 3> kWavelength_nm{450.0, 530.0, 610.0};
/// Absorption by pure water at those [1/m], after [Pope 1997].
const Eigen::Array3d kPureWater(0.0092, 0.0434, 0.2644);
/// Slope of the absorption by dissolved matter [1/nm], after [Bricaud 1981].
constexpr double kDissolvedSlope_per_nm = 0.014;
/// Upward share of scattered light, several times scattered light included: makes deep water of
/// visibility 8 m look as bright from above as a surface that returns 3 to 4 %.
constexpr double kUpwardShare = 0.05;
/// Mean cosine of daylight under water: it goes down at a slant, [Kirk 1994].
constexpr double kMeanCosine = 0.8;

}  // namespace

WaterColumn::WaterColumn(Meters visibility, const ImageParams::Water& water) {
  LIMPET_REQUIRE(visibility.value() > 0.0, "visibility must be positive");
  LIMPET_REQUIRE(water.dissolved >= 0.0 && water.backscatter >= 0.0,
                 "water takes light, it makes none");
  // c = pure water + s (dissolved matter's shape + 1) with the s at which the least c fits.
  const double wanted = -std::log(kContrastAtVisibility) / visibility.value();
  Eigen::Array3d dissolved_shape;
  double scattering = 0.0;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const double beyond = kWavelength_nm[static_cast<std::size_t>(i)] - 440.0;
    dissolved_shape(i) = water.dissolved * std::exp(-kDissolvedSlope_per_nm * beyond);
    scattering = std::max(scattering, (wanted - kPureWater(i)) / (dissolved_shape(i) + 1.0));
  }
  const Eigen::Array3d absorption = kPureWater + scattering * dissolved_shape;
  const auto padded = [](const Eigen::Array3d& value) {
    return Four(static_cast<float>(value(0)), static_cast<float>(value(1)),
                static_cast<float>(value(2)), 1.0F);
  };
  scattering_.setConstant(static_cast<float>(scattering));
  beam_ = padded(absorption + scattering);
  diffuse_ = padded((absorption + kUpwardShare * scattering) / kMeanCosine);
  backscatter_ = static_cast<float>(water.backscatter * kUpwardShare) * scattering_;
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
// The smoother's results as MRPT types, for whoever composes, serialises or compares them.
#pragma once

#include <mrpt/poses/CPose3DPDFGaussian.h>

#include "estimation/smoothing/nav_vector.hpp"

namespace limpet {

/// MRPT's yaw-pitch-roll is ours: R = Rz Ry Rx; covariances keep NavVector's order.
[[nodiscard]] mrpt::poses::CPose3DPDFGaussian MrptPosePdf(const NavVector& x,
                                                          const NavCovariance& covariance);
[[nodiscard]] NavCovariance CovarianceOf(const mrpt::poses::CPose3DPDFGaussian& pdf);

}  // namespace limpet

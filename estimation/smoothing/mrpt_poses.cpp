// SPDX-License-Identifier: MIT
#include "estimation/smoothing/mrpt_poses.hpp"

namespace limpet {

mrpt::poses::CPose3DPDFGaussian MrptPosePdf(const NavVector& x, const NavCovariance& covariance) {
  return {{x(kNavX), x(kNavY), x(kNavZ), x(kNavYaw), x(kNavPitch), x(kNavRoll)},
          mrpt::math::CMatrixDouble66(covariance)};
}

NavCovariance CovarianceOf(const mrpt::poses::CPose3DPDFGaussian& pdf) { return pdf.cov.asEigen(); }

}  // namespace limpet

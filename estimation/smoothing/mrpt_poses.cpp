// SPDX-License-Identifier: MIT
#include "estimation/smoothing/mrpt_poses.hpp"

namespace limpet {

mrpt::poses::CPose3D MrptPose(const NavVector& x) {
  return {x(kNavX), x(kNavY), x(kNavZ), x(kNavYaw), x(kNavPitch), x(kNavRoll)};
}

mrpt::poses::CPose3DPDFGaussian MrptPosePdf(const NavVector& x, const NavCovariance& covariance) {
  return {MrptPose(x), mrpt::math::CMatrixDouble66(covariance)};
}

NavVector NavVectorOf(const mrpt::poses::CPose3D& pose) {
  NavVector x;
  x << pose.x(), pose.y(), pose.z(), pose.yaw(), pose.pitch(), pose.roll();
  return x;
}

NavCovariance CovarianceOf(const mrpt::poses::CPose3DPDFGaussian& pdf) { return pdf.cov.asEigen(); }

}  // namespace limpet

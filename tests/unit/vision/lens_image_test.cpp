// SPDX-License-Identifier: MIT
#include "limpet/vision/lens_image.hpp"

#include <cmath>
#include <cstdint>
#include <cstdlib>

#include <gtest/gtest.h>
#include <mrpt/img/CImage.h>
#include <mrpt/img/TCamera.h>

namespace limpet {
namespace {

LensModel Barrel() {
  return {CameraModel(), {.k1 = -0.18, .k2 = 0.03, .p1 = 0.002, .p2 = -0.003, .k3 = -0.002}};
}

/// Smooth waves over the plane that a pinhole camera looks at: the same wherever its image begins.
std::uint8_t WavesAt(const CameraModel& camera, int column, int row) {
  const double x = (column + 0.5 - camera.cx) / camera.fx, y = (row + 0.5 - camera.cy) / camera.fy;
  return static_cast<std::uint8_t>(
      std::lround(128.0 + 60.0 * std::sin(20.0 * x) + 60.0 * std::cos(17.0 * y)));
}

Image WavesSeenBy(const CameraModel& camera) {
  Image image{camera.width_px, camera.height_px, {}};
  for (int row = 0; row < camera.height_px; ++row) {
    for (int column = 0; column < camera.width_px; ++column)
      image.bgr.insert(image.bgr.end(), 3, WavesAt(camera, column, row));
  }
  return image;
}

TEST(LensImage, IsUndistortedByMrptToWhatThePinholeSaw) {
  const LensModel lens = Barrel();
  const Image seen = LensImage(lens).Distorted(WavesSeenBy(lens.enclosing()));
  ASSERT_EQ(seen.width_px, lens.image().width_px);
  mrpt::img::TCamera camera;
  camera.ncols = static_cast<std::uint32_t>(seen.width_px);
  camera.nrows = static_cast<std::uint32_t>(seen.height_px);
  const CameraModel& image = lens.image();
  // MRPT, as OpenCV, counts from the middle of the first pixel.
  camera.setIntrinsicParamsFromValues(image.fx, image.fy, image.cx - 0.5, image.cy - 0.5);
  const LensDistortion& d = lens.distortion();
  camera.setDistortionPlumbBob(d.k1, d.k2, d.p1, d.p2, d.k3);
  mrpt::img::CImage distorted, straight;
  distorted.resize(camera.ncols, camera.nrows, mrpt::img::CH_RGB);
  for (int row = 0; row < seen.height_px; ++row) {
    for (int column = 0; column < seen.width_px; ++column) {
      for (unsigned c = 0; c < 3; ++c) {
        *distorted.ptr<std::uint8_t>(static_cast<unsigned>(column), static_cast<unsigned>(row), c) =
            seen.view().pixel(column, row)[c];
      }
    }
  }
  distorted.undistort(straight, camera);
  constexpr int kBorder = 4;  // of pixels that MRPT makes of nothing
  int worst = 0;
  for (int row = kBorder; row < seen.height_px - kBorder; ++row) {
    for (int column = kBorder; column < seen.width_px - kBorder; ++column) {
      const int got =
          *straight.ptr<std::uint8_t>(static_cast<unsigned>(column), static_cast<unsigned>(row));
      worst = std::max(worst, std::abs(got - WavesAt(image, column, row)));
    }
  }
  EXPECT_LE(worst, 5) << "of 120 levels; half a pixel off would be 7";
}

}  // namespace
}  // namespace limpet

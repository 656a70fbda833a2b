// SPDX-License-Identifier: MIT
#include "limpet/core/camera_params.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(CameraParams, DefaultIsTheDefaultCamera) {
  const CameraGeometry camera = CameraParams().geometry();
  const CameraGeometry plain;
  EXPECT_EQ(camera.width_px, plain.width_px);
  EXPECT_EQ(camera.height_px, plain.height_px);
  EXPECT_DOUBLE_EQ(camera.fx(), plain.fx());
  EXPECT_DOUBLE_EQ(camera.fy(), plain.fy());
}

TEST(CameraParams, ReadsDegreesAndPixels) {
  ConfigBlock block;
  block.entries.push_back({.key = "camera_fov_across_deg", .value = "60", .where = {}});
  block.entries.push_back({.key = "camera_height_px", .value = "240", .where = {}});
  const CameraGeometry camera = ReadParams<CameraParams>(block).geometry();
  EXPECT_NEAR(camera.fov_across, RadiansFromDegrees(60.0), 1e-12);
  EXPECT_EQ(camera.height_px, 240);
}

TEST(CameraParams, RefusesAnAngleThatNoPinholeHas) {
  ConfigBlock block;
  block.entries.push_back({.key = "camera_fov_along_deg", .value = "180", .where = {}});
  EXPECT_THROW(static_cast<void>(ReadParams<CameraParams>(block)), ConfigError);
}

}  // namespace
}  // namespace limpet

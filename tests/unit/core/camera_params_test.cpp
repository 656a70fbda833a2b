// SPDX-License-Identifier: MIT
#include "limpet/core/camera_params.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(CameraParams, DefaultIsTheDefaultCamera) {
  const CameraModel camera = CameraParams().geometry();
  const CameraModel plain;
  EXPECT_EQ(camera.width_px, plain.width_px);
  EXPECT_EQ(camera.height_px, plain.height_px);
  EXPECT_DOUBLE_EQ(camera.fx, plain.fx);
  EXPECT_DOUBLE_EQ(camera.fy, plain.fy);
}

TEST(CameraParams, ReadsDegreesAndPixels) {
  ConfigBlock block;
  block.entries = {{"camera_fov_across_deg", "60", {}},
                   {"camera_fov_along_deg", "45", {}},
                   {"camera_width_px", "320", {}},
                   {"camera_height_px", "240", {}}};
  const CameraModel camera = ReadParams<CameraParams>(block).geometry();
  EXPECT_NEAR(camera.fov_across(), RadiansFromDegrees(60.0), 1e-12);
  EXPECT_EQ(camera.height_px, 240);
}

TEST(CameraParams, HasNoDefault) {
  const ConfigBlock block{.name = "pMap", .where = {"m.moos", 3}, .entries = {}};
  try {
    static_cast<void>(ReadParams<CameraParams>(block));
    FAIL() << "took a camera that nobody gave";
  } catch (const ConfigError& error) {
    EXPECT_EQ(error.problems().size(), 4U);
  }
}

TEST(CameraParams, RefusesAnAngleThatNoPinholeHas) {
  ConfigBlock block;
  block.entries.push_back({.key = "camera_fov_along_deg", .value = "180", .where = {}});
  EXPECT_THROW(static_cast<void>(ReadParams<CameraParams>(block)), ConfigError);
}

}  // namespace
}  // namespace limpet

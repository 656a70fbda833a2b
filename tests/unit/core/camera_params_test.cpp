// SPDX-License-Identifier: MIT
#include "limpet/core/camera_params.hpp"

#include <cmath>

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

TEST(CameraParams, ZeroLeavesTheLensToTheFieldOfView) {
  ConfigBlock block;
  block.entries = {{"camera_fov_across_deg", "60", {}}, {"camera_fov_along_deg", "45", {}},
                   {"camera_width_px", "320", {}},      {"camera_height_px", "240", {}},
                   {"camera_fx_px", "0", {}},           {"camera_fy_px", "310.5", {}},
                   {"camera_cx_px", "150", {}},         {"camera_cy_px", "0", {}}};
  const auto params = ReadParams<CameraParams>(block);
  EXPECT_EQ(params.fx_px, std::nullopt);
  const CameraModel camera = params.pinhole();
  EXPECT_EQ(camera.fx,
            CameraModel::FromFieldOfView(
                320, 240, {.across = params.fov_across.value(), .along = params.fov_along.value()})
                .fx);
  EXPECT_EQ(camera.fy, 310.5);
  EXPECT_EQ(camera.cx, 150.0);
  EXPECT_EQ(camera.cy, 120.0);
}

TEST(CameraParams, ATiltedCameraLooksAheadFromItsPlace) {
  CameraParams params;
  params.tilt = Radians::FromTextUnit(30.0);
  params.p_BC = {0.2, 0.0, 0.1};
  const CameraModel camera = params.geometry();
  EXPECT_TRUE((camera.R_BC * Eigen::Vector3d::UnitZ())
                  .isApprox(Eigen::Vector3d(0.5, 0.0, std::sqrt(0.75))));
  const Eigen::Vector3d ahead(0.2 + 2.0 * std::tan(params.tilt.value()), 0.0, 2.1);
  const auto pixel = camera.Project(camera.InCamera(Pose{}, ahead));
  ASSERT_TRUE(pixel);
  EXPECT_NEAR(pixel->x(), 320.0, 1e-9);
  EXPECT_NEAR(pixel->y(), 240.0, 1e-9);
}

}  // namespace
}  // namespace limpet

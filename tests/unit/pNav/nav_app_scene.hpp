// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "apps/pNav/nav_app.hpp"
#include "tests/support/sphere_box.hpp"
#include "tests/support/test_link.hpp"

namespace limpet {

/// A vehicle with ideal sensors that runs east at 0.5 m/s, level, at 1 m depth.
class NavAppTest : public ::testing::Test {
 protected:
  NavAppTest() { Launch(MakeContext()); }

  /// With the sensors that dead reckoning usually stands on.
  void Launch(const AppContext& context, const NavApp::Params& params = {}) {
    app_.emplace(context, params);
    for (auto& sensor : UsualSensors())
      app_->Hear("usual", std::move(sensor));
  }
  AppContext MakeContext() {
    AppContext context;
    context.name = "pNav";
    context.link = &link_;
    context.globals = {{"VehicleFile", "feelhippo.yaml", {}}};
    return context;
  }
  void RunFor(double seconds, double speed = 0.5) {
    for (int i = 0; i < static_cast<int>(std::lround(seconds * 50.0)); ++i, ++step_) {
      link_.time = Seconds(1767225600.0 + 0.02 * step_);
      link_.Send(*app_, topics::kFogYawRate, 0.0);
      link_.Send(*app_, topics::kImuData, ImuSample{.fz = -9.81, .heading = 0.5 * M_PI});
      east_ += speed * 0.02;
      if (step_ % 10 == 0) {
        link_.Send(*app_, topics::kDvlData,
                   DvlSample{.has_lock = true,
                             .u = speed,
                             .v = 0.0,
                             .w = 0.0,
                             .altitude = 4.0,
                             .b1 = 4.4,
                             .b2 = 4.4,
                             .b3 = 4.4,
                             .b4 = 4.4});
        link_.Send(*app_, topics::kDepthSensor, depth_);
      }
      if (has_gps_ && step_ % 50 == 0) {
        link_.Send(*app_, topics::kGpsData,
                   GpsFix{.north = 10.0 + gps_off_, .east = east_, .sd = 0.4});
      }
      if (step_ % 5 == 0) {
        app_->Tick(link_.time);
      }
    }
  }

  /// Runs on with boxes of what the camera sees of objects of 0.5 m radius, four images a second.
  void RunOver(const std::vector<Eigen::Vector3d>& objects, double seconds) {
    const CameraModel camera = NavApp::Params{}.camera.geometry();
    for (int frame = 0; frame < static_cast<int>(4.0 * seconds); ++frame) {
      RunFor(0.26);
      const Pose X_WB{{10.0, east_ - 0.01, 1.0}, 0.0, 0.0, 0.5 * M_PI};
      Detections seen{.frame = frame, .exposure = link_.time, .boxes = {}};
      for (const Eigen::Vector3d& p_W : objects) {
        auto box = BoxOfSphere(camera.InCamera(X_WB, p_W), 0.5, camera);
        if (!box || box->w < 20.0 || box->h < 20.0) continue;
        box->confidence = 0.9, box->color = "yellow";
        if (is_camera_upside_down_) {
          box->u = camera.width_px - box->u;
          box->v = camera.height_px - box->v;
        }
        seen.boxes.push_back(*box);
      }
      link_.Send(*app_, topics::kDetections, seen);
    }
  }

  /// Time passes; only pNav's own clock says so.
  void StayDeaf(double seconds) {
    for (int i = 0; i < static_cast<int>(std::lround(seconds * 10.0)); ++i, step_ += 5) {
      link_.time = Seconds(1767225600.0 + 0.02 * step_);
      app_->Tick(link_.time);
    }
  }
  std::size_t CountOf(const std::string& name) const {
    return static_cast<std::size_t>(std::ranges::count_if(
        link_.published, [&name](const MessagePtr& message) { return message->name == name; }));
  }

  TestLink link_;
  std::optional<NavApp> app_;
  int step_ = 0;
  double east_ = 20.0;
  bool has_gps_ = true;
  double gps_off_ = 0.0;  ///< of fixes, north [m]
  double depth_ = 1.0;    ///< as the sensor reads it [m]
  bool is_camera_upside_down_ = false;
};

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/mission/vehicle_settings.hpp"

namespace limpet {
namespace {

std::vector<FactTaker> VehicleTakers() {
  std::vector<FactTaker> takers;
  for (const char* owner : {"pHelm", "pMap", "pNav", "uSimCamera"}) {
    takers.push_back({owner, "camera_fov_across_deg", "camera.fov_across_deg"});
    takers.push_back({owner, "camera_fov_along_deg", "camera.fov_along_deg"});
    takers.push_back({owner, "camera_width_px", "camera.width_px"});
    takers.push_back({owner, "camera_height_px", "camera.height_px"});
    takers.push_back({owner, "camera_at_m", "camera.at_m"});
    takers.push_back({owner, "camera_tilt_deg", "camera.tilt_deg"});
    takers.push_back({owner, "camera_fx_px", "camera.fx_px"});
    takers.push_back({owner, "camera_fy_px", "camera.fy_px"});
    takers.push_back({owner, "camera_cx_px", "camera.cx_px"});
    takers.push_back({owner, "camera_cy_px", "camera.cy_px"});
    takers.push_back({owner, "camera_distortion", "camera.distortion"});
  }
  takers.push_back({"uSimCamera", "rate_hz", "camera.rate_hz"});
  takers.push_back({"uSimCamera", "latency_s", "camera.latency_s"});
  takers.push_back({"pMap", "dvl_yaw_deg", "dvl.yaw_deg"});
  takers.push_back({"pMap", "dvl_beam_angle_deg", "dvl.beam_angle_deg"});
  const auto former = [&takers](const char* key, const char* vehicle_key,
                                std::optional<std::size_t> part = {}) {
    takers.push_back({"pNav", key, vehicle_key, part, true});
  };
  former("heading_sigma_deg", "imu.heading_sigma_deg");
  former("dvl_x_m", "dvl.at_m", 0);
  former("dvl_y_m", "dvl.at_m", 1);
  former("dvl_z_m", "dvl.at_m", 2);
  former("top_speed_mps", "hull.top_speed_mps");
  takers.push_back({"pNodeReporter", "platform_length", "hull.length_m"});
  takers.push_back({"pNodeReporter", "vessel_length", "hull.length_m"});
  return takers;
}

}  // namespace

const FactFile& VehicleFacts() {
  static const FactFile kind{.global = kVehicleFileGlobal,
                             .folder = "vehicles",
                             .of = "vehicle",
                             .takers = VehicleTakers(),
                             .has_reader = true};
  return kind;
}

}  // namespace limpet

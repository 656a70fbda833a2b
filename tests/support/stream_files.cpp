// SPDX-License-Identifier: MIT
#include "tests/support/stream_files.hpp"

#include <fstream>
#include <string>
#include <variant>

#include <fmt/format.h>

namespace limpet {
namespace {

std::string LineOf(const AttitudeEstimate& a) {
  return fmt::format("ATT,{},{},{},{},{},{},{}\n", a.t, a.roll, a.pitch, a.yaw, a.sd_roll,
                     a.sd_pitch, a.sd_yaw);
}

std::string LineOf(const DvlRow& row) {
  const std::string altitude = row.altitude ? fmt::format("{}", *row.altitude) : "";
  if (!row.v_WD_B) {
    return fmt::format("DVL,{},0,,,,,,{},,,,\n", row.t, altitude);
  }
  const Eigen::Vector3d& v = *row.v_WD_B;
  return fmt::format("DVL,{},1,{},{},{},0.01,0.005,{},,,,\n", row.t, v.x(), v.y(), v.z(), altitude);
}

std::string LineOf(const DepthReading& row) {
  return fmt::format("DEP,{},{},0.02\n", row.t, row.depth);
}

std::string LineOf(const PositionFix& row) {
  return fmt::format("GPS,{},{},{},{}\n", row.t, row.p_W.x(), row.p_W.y(), row.sd);
}

std::string LineOf(const FrameRow& row) {
  const Detections& frame = row.frame;
  std::string text = fmt::format("FRM,{},{},{},{}\n", frame.exposure.value(), row.arrival,
                                 frame.frame, frame.boxes.size());
  for (std::size_t i = 0; i < frame.boxes.size(); ++i) {
    const Box& box = frame.boxes[i];
    text += fmt::format("DET,{},{},{},{},{},{},{},{},{},{}\n", frame.exposure.value(), row.arrival,
                        frame.frame, i, box.u, box.v, box.w, box.h, box.confidence, box.color);
  }
  return text;
}

/// A stream's folder holds attitudes, not what they are made of.
std::string LineOf(const InertialInput& /*row*/) { return {}; }
std::string LineOf(const YawRate& /*row*/) { return {}; }
std::string LineOf(const ThrusterShares& /*row*/) { return {}; }

std::string MetaOf(const StreamMeta& meta) {
  const CameraModel& camera = meta.camera;
  std::string rotation;
  for (int i = 0; i < 9; ++i) {
    rotation += fmt::format(",{}", camera.R_BC(i / 3, i % 3));
  }
  return fmt::format(
      "key,v1,v2\nimage_size,{},{}\nintrinsics_fx_fy_cx_cy,{},{},{},{}\n"
      "cam_pos_body,{},{},{}\ncam_R_body_from_cam{}\ndvl_pos_body,{},{},{}\n"
      "yaw_arw_rad_per_sqrt_s,{}\nyaw_bias_sigma_rad_per_s,{}\ndvl_scale_sigma,{}\n"
      "dvl_bias_sigma,{}\ndvl_misalign_sigma,{}\nopi_radius,{}\n",
      camera.width_px, camera.height_px, camera.fx, camera.fy, camera.cx, camera.cy,
      camera.p_BC.x(), camera.p_BC.y(), camera.p_BC.z(), rotation, meta.dvl_B.x(), meta.dvl_B.y(),
      meta.dvl_B.z(), meta.yaw_random_walk, meta.yaw_bias_sigma, meta.dvl_scale_sigma,
      meta.dvl_bias_sigma, meta.dvl_misalign_sigma, meta.opi_radius);
}

}  // namespace

void WriteStreamFolder(const SimulatedStream& session, const std::filesystem::path& folder) {
  std::ofstream(folder / "meta.csv") << MetaOf(session.stream.meta);
  std::ofstream rows(folder / "stream.csv.gz");
  for (const StreamRow& row : session.stream.rows) {
    rows << std::visit([](const auto& r) { return LineOf(r); }, row);
  }
  std::ofstream track(folder / "truth_traj.csv.gz");
  track << "t,x,y,z\n";
  for (std::size_t i = 0; i < session.truth.t.size(); ++i) {
    const Eigen::Vector3d& p = session.truth.p[i];
    track << fmt::format("{},{},{},{}\n", session.truth.t[i], p.x(), p.y(), p.z());
  }
  std::ofstream objects(folder / "truth_landmarks.csv");
  objects << "id,x,y,z\n";
  for (const TrueLandmark& landmark : session.truth.landmarks) {
    objects << fmt::format("{},{},{},{}\n", landmark.id, landmark.p.x(), landmark.p.y(),
                           landmark.p.z());
  }
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/obs/CObservationComment.h>
#include <mrpt/obs/CObservationIMU.h>
#include <mrpt/obs/CObservationRawDAQ.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/serialization/CArchive.h>

#include "estimation/replay/rawlog.hpp"
#include "estimation/replay/rawlog_form.hpp"
#include "limpet/packing/gzip_bytes.hpp"

namespace limpet {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

std::string MetaLines(const StreamMeta& meta) {
  const CameraModel& camera = meta.camera;
  const Eigen::Vector3d &p = camera.p_BC, &d = meta.dvl_B;
  std::string text = rawlog::kMetaBegin;
  if (meta.has_image_size) {
    text += fmt::format("image_size,{},{}\n", camera.width_px, camera.height_px);
  }
  if (meta.has_intrinsics) {
    text += fmt::format("intrinsics_fx_fy_cx_cy,{},{},{},{}\n", camera.fx, camera.fy, camera.cx,
                        camera.cy);
  }
  if (const LensDistortion& lens = meta.distortion; !lens.is_none()) {
    text += fmt::format("distortion_k1_k2_p1_p2_k3,{},{},{},{},{}\n", lens.k1, lens.k2, lens.p1,
                        lens.p2, lens.k3);
  }
  text += fmt::format("cam_pos_body,{},{},{}\ncam_R_body_from_cam", p.x(), p.y(), p.z());
  for (int i = 0; i < 9; ++i)
    text += fmt::format(",{}", camera.R_BC(i / 3, i % 3));
  text += fmt::format("\ndvl_pos_body,{},{},{}\n", d.x(), d.y(), d.z());
  text += fmt::format("yaw_arw_rad_per_sqrt_s,{}\nyaw_bias_sigma_rad_per_s,{}\n",
                      meta.yaw_random_walk, meta.yaw_bias_sigma);
  text += fmt::format("dvl_scale_sigma,{}\ndvl_bias_sigma,{}\ndvl_misalign_sigma,{}\n",
                      meta.dvl_scale_sigma, meta.dvl_bias_sigma, meta.dvl_misalign_sigma);
  text += fmt::format("opi_radius,{}\nstated_noise_velocity_depth_tilt,{},{},{}\n", meta.opi_radius,
                      meta.noise.velocity, meta.noise.depth, meta.noise.tilt);
  return text;
}

/// Turns rows into observations.
class RawlogWriter {
 public:
  explicit RawlogWriter(mrpt::serialization::CArchive& out) : out_(out) {}

  void Say(const StreamMeta& meta) {
    mrpt::obs::CObservationComment comment;
    comment.text = MetaLines(meta);
    Write(0.0, "meta", comment);
  }
  void operator()(const AttitudeEstimate& row) {
    const std::tuple sigmas(row.sd_roll, row.sd_pitch, row.sd_yaw);
    if (sigmas != sigmas_) {
      WriteNumbers(row.t, rawlog::kAttitudeSigma, {row.sd_roll, row.sd_pitch, row.sd_yaw});
      sigmas_ = sigmas;
    }
    mrpt::obs::CObservationIMU imu;
    imu.set(mrpt::obs::IMU_ROLL, row.roll);
    imu.set(mrpt::obs::IMU_PITCH, row.pitch);
    imu.set(mrpt::obs::IMU_YAW, row.yaw);
    Write(row.t, rawlog::kAttitude, imu);
  }
  void operator()(const InertialInput& row) {
    mrpt::obs::CObservationIMU imu;
    imu.set(mrpt::obs::IMU_X_ACC, row.force_B.x());
    imu.set(mrpt::obs::IMU_Y_ACC, row.force_B.y());
    imu.set(mrpt::obs::IMU_Z_ACC, row.force_B.z());
    imu.set(mrpt::obs::IMU_WX, row.rate_B.x());
    imu.set(mrpt::obs::IMU_WY, row.rate_B.y());
    imu.set(mrpt::obs::IMU_WZ, row.rate_B.z());
    imu.set(mrpt::obs::IMU_YAW, row.heading);
    Write(row.t, rawlog::kImu, imu);
  }
  void operator()(const FogRow& row) {
    mrpt::obs::CObservationIMU imu;
    imu.set(mrpt::obs::IMU_WZ, row.rate);
    Write(row.t, rawlog::kFog, imu);
  }
  void operator()(const DvlRow& row) {
    mrpt::obs::CObservationIMU ping;
    if (row.v_WD_B) {
      ping.set(mrpt::obs::IMU_X_VEL, row.v_WD_B->x());
      ping.set(mrpt::obs::IMU_Y_VEL, row.v_WD_B->y());
      ping.set(mrpt::obs::IMU_Z_VEL, row.v_WD_B->z());
    }
    if (row.altitude) ping.set(mrpt::obs::IMU_ALTITUDE, *row.altitude);
    Write(row.t, rawlog::kDvl, ping);
    if (std::ranges::any_of(row.beams, [](const auto& beam) { return beam.has_value(); })) {
      std::vector<double> ranges;
      for (const std::optional<double>& beam : row.beams)
        ranges.push_back(beam.value_or(kNone));
      WriteNumbers(row.t, rawlog::kBeams, std::move(ranges));
    }
  }
  void operator()(const DepthRow& row) {
    mrpt::obs::CObservationIMU depth;
    depth.set(mrpt::obs::IMU_Z, row.depth);
    Write(row.t, rawlog::kDepth, depth);
  }
  void operator()(const PositionFix& row) {
    constexpr double kUnknown = 1e6;  // variance of what a fix does not tell
    mrpt::obs::CObservationRobotPose fix;
    fix.pose.mean = mrpt::poses::CPose3D(row.p_W.x(), row.p_W.y(), 0.0, 0.0, 0.0, 0.0);
    fix.pose.cov.setZero();
    for (int i = 0; i < 6; ++i)
      fix.pose.cov(i, i) = i < 2 ? row.sd * row.sd : kUnknown;
    Write(row.t, rawlog::kGps, fix);
  }
  void operator()(const FrameRow& row) {
    mrpt::obs::CObservationRawDAQ seen;
    seen.AIN_double = {static_cast<double>(row.frame.frame), row.frame.exposure.value(),
                       row.arrival};
    for (const Box& box : row.frame.boxes) {
      for (const double number : {box.u, box.v, box.w, box.h, box.confidence})
        seen.AIN_double.push_back(number);
      for (const char letter : box.color)
        seen.AIN_8bits.push_back(static_cast<std::uint8_t>(letter == '\n' ? ' ' : letter));
      seen.AIN_8bits.push_back('\n');
    }
    Write(row.frame.exposure.value(), rawlog::kBoxes, seen);
  }

  [[nodiscard]] int untimely_rows() const { return untimely_rows_; }

 private:
  void WriteNumbers(double t, const char* label, std::vector<double> numbers) {
    mrpt::obs::CObservationRawDAQ some;
    some.AIN_double = std::move(numbers);
    Write(t, label, some);
  }
  void Write(double t, const char* label, mrpt::obs::CObservation& seen) {
    const auto time = rawlog::TimeOf(t);
    if (!time) {
      ++untimely_rows_;
      return;
    }
    seen.timestamp = *time;
    seen.sensorLabel = label;
    out_ << seen;
  }
  mrpt::serialization::CArchive& out_;
  std::tuple<double, double, double> sigmas_{kNone, kNone, kNone};
  int untimely_rows_ = 0;
};

}  // namespace

PackedRawlog ToRawlog(const SensorStream& stream) {
  mrpt::io::CMemoryStream memory;
  auto archive = mrpt::serialization::archiveFrom(memory);
  RawlogWriter writer(archive);
  writer.Say(stream.meta);
  for (const StreamRow& row : stream.rows)
    std::visit(writer, row);
  const auto* bytes = static_cast<const char*>(memory.getRawBufferData());
  return {.bytes = Gzip({bytes, memory.getTotalBytesCount()}),
          .untimely_rows = writer.untimely_rows()};
}

}  // namespace limpet

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
#include <mrpt/serialization/CArchive.h>

#include "estimation/navigation/observation_forms.hpp"
#include "estimation/replay/rawlog.hpp"
#include "limpet/packing/gzip_bytes.hpp"

namespace limpet {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

std::string MetaLines(const StreamMeta& meta) {
  const CameraModel& camera = meta.camera;
  const Eigen::Vector3d &p = camera.p_BC, &d = meta.dvl_B;
  std::string text = kRawlogMetaBegin;
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
      mrpt::obs::CObservationRawDAQ some;
      some.AIN_double = {row.sd_roll, row.sd_pitch, row.sd_yaw};
      Write(row.t, observation_labels::kAttitudeSigma, some);
      sigmas_ = sigmas;
    }
    mrpt::obs::CObservationIMU imu;
    imu.set(mrpt::obs::IMU_ROLL, row.roll);
    imu.set(mrpt::obs::IMU_PITCH, row.pitch);
    imu.set(mrpt::obs::IMU_YAW, row.yaw);
    Write(row.t, observation_labels::kAttitude, imu);
  }
  void operator()(const InertialInput& row) { Write(ObservationOf(row)); }
  void operator()(const YawRate& row) { Write(ObservationOf(row)); }
  void operator()(const DvlRow& row) {
    Write(ObservationOf(BottomTrack{.t = row.t, .v_WD_D = row.v_WD_B, .altitude = row.altitude}));
    if (std::ranges::any_of(row.beams, [](const auto& beam) { return beam.has_value(); }))
      Write(ObservationOf(SlantRanges{.t = row.t, .beams = row.beams}));
  }
  void operator()(const DepthReading& row) { Write(ObservationOf(row)); }
  void operator()(const PositionFix& row) { Write(ObservationOf(row)); }
  void operator()(const ThrusterShares& row) { Write(ObservationOf(row)); }
  void operator()(const FrameRow& row) { Write(ObservationOf(row.frame, row.arrival)); }

  [[nodiscard]] int untimely_rows() const { return untimely_rows_; }

 private:
  /// Nothing: of a time that MRPT cannot say.
  void Write(const ObservationPtr& seen) {
    if (seen == nullptr) {
      ++untimely_rows_;
    } else {
      out_ << *seen;
    }
  }
  void Write(double t, const char* label, mrpt::obs::CObservation& seen) {
    if (Stamp(t, label, seen)) {
      out_ << seen;
    } else {
      ++untimely_rows_;
    }
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

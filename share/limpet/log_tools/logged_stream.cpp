// SPDX-License-Identifier: MIT
#include "limpet/log_tools/logged_stream.hpp"

#include <cmath>
#include <string>
#include <utility>
#include <variant>

#include "estimation/navigation/measurement_source.hpp"
#include "limpet/core/frames.hpp"

namespace limpet {
namespace {

StreamMeta MetaOf(const VehicleFile& vehicle) {
  const SensorSheets& sheets = vehicle.sensors;
  StreamMeta meta;
  meta.camera = vehicle.camera.pinhole();
  meta.distortion = vehicle.camera.lens_distortion();
  meta.has_image_size = meta.has_intrinsics = true;
  meta.dvl_B = sheets.dvl.p_BD;
  meta.yaw_random_walk = sheets.fog.random_walk;
  meta.yaw_bias_sigma = RadiansFromDegrees(sheets.fog.bias_deg_per_h) / 3600.0;
  meta.dvl_scale_sigma = sheets.dvl.scale_sigma;
  meta.dvl_bias_sigma = sheets.dvl.bias_mps;
  meta.dvl_misalign_sigma = sheets.dvl.misalignment_sigma.value();
  meta.noise.velocity = sheets.dvl.noise_mps;
  meta.noise.depth = sheets.depth.noise_m;
  return meta;
}

/// Makes rows of readings; slant ranges go into that of their ping.
class RowKeeper {
 public:
  RowKeeper(SensorStream& stream, const Eigen::Matrix3d& R_BD, double arrival)
      : stream_(stream), R_BD_(R_BD), arrival_(arrival) {}

  template <class Reading>
  void operator()(const Reading& reading) {
    stream_.rows.emplace_back(reading);
  }
  void operator()(const Detections& frame) {
    stream_.rows.emplace_back(FrameRow{.arrival = arrival_, .frame = frame});
  }
  void operator()(const BottomTrack& ping) {
    DvlRow row{.t = ping.t, .v_WD_B = {}, .altitude = ping.altitude};
    if (ping.v_WD_D) row.v_WD_B = R_BD_ * *ping.v_WD_D;
    stream_.rows.emplace_back(row);
  }
  void operator()(const SlantRanges& ping) {
    auto* row = stream_.rows.empty() ? nullptr : std::get_if<DvlRow>(&stream_.rows.back());
    if (row != nullptr) row->beams = ping.beams;
  }

 private:
  SensorStream& stream_;
  const Eigen::Matrix3d& R_BD_;
  double arrival_;
};

}  // namespace

LoggedStream::LoggedStream(const std::optional<VehicleFile>& vehicle, double object_radius_m) {
  if (vehicle) {
    R_BD_ = RotationFromRollPitchYaw(0.0, 0.0, vehicle->sensors.dvl.yaw.value());
    stream_.meta = MetaOf(*vehicle);
  }
  stream_.meta.opi_radius = object_radius_m;
}

bool LoggedStream::Take(const AlogEntry& entry, double start) {
  const double t = start + entry.time;
  const Value value = entry.number ? Value(*entry.number) : Value(std::string(entry.value));
  bool is_heard = false;
  for (const std::unique_ptr<MotionSensor>& sensor : sensors_) {
    if (sensor->variable() != entry.name) continue;
    if (const auto reading = sensor->Read(t, value)) {
      std::visit(RowKeeper(stream_, R_BD_, t), *reading);
    } else if (!is_heard) {
      ++bad_entries_;  // once, however many sensors hear it
    }
    is_heard = true;
  }
  return is_heard;
}

}  // namespace limpet

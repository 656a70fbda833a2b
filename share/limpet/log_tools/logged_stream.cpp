// SPDX-License-Identifier: MIT
#include "limpet/log_tools/logged_stream.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "limpet/core/frames.hpp"
#include "limpet/topics/sensors.hpp"

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

std::optional<StreamRow> RowOf(double t, const ImuSample& s) {
  return InertialInput{
      .t = t, .force_B = {s.fx, s.fy, s.fz}, .rate_B = {s.p, s.q, s.r}, .heading = s.heading};
}

std::optional<StreamRow> RowOf(double t, const DvlSample& s, const Eigen::Matrix3d& R_BD) {
  DvlRow row{.t = t, .v_WD_B = {}, .altitude = s.altitude, .beams = s.beams()};
  if (s.has_lock && s.u && s.v && s.w) row.v_WD_B = R_BD * Eigen::Vector3d(*s.u, *s.v, *s.w);
  return row;
}

std::optional<StreamRow> RowOf(double t, const GpsFix& s) {
  return PositionFix{.t = t, .p_W = {s.north, s.east}, .sd = s.sd};
}

std::optional<StreamRow> RowOf(double t, Detections frame) {
  return FrameRow{.arrival = t, .frame = std::move(frame)};
}

/// The row of an entry's value as this topic, or nothing if it is none.
template <class T, class... More>
std::optional<StreamRow> RowAs(double t, const Value& value, const More&... more) {
  auto sample = TopicCodec<T>::Decode(value);
  return sample ? RowOf(t, *std::move(sample), more...) : std::nullopt;
}

}  // namespace

LoggedStream::LoggedStream(const std::optional<VehicleFile>& vehicle, double object_radius_m) {
  if (vehicle) {
    R_BD_ = RotationFromRollPitchYaw(0.0, 0.0, vehicle->sensors.dvl.yaw.value());
    stream_.meta = MetaOf(*vehicle);
  }
  stream_.meta.opi_radius = object_radius_m;
}

void LoggedStream::Keep(std::optional<StreamRow> row) {
  if (row) {
    stream_.rows.push_back(*std::move(row));
  } else {
    ++bad_entries_;
  }
}

bool LoggedStream::Take(const AlogEntry& entry, double start) {
  const double t = start + entry.time;
  const Value value = entry.number ? Value(*entry.number) : Value(std::string(entry.value));
  if (entry.name == topics::kImuData.name) {
    Keep(RowAs<ImuSample>(t, value));
  } else if (entry.name == topics::kDvlData.name) {
    Keep(RowAs<DvlSample>(t, value, R_BD_));
  } else if (entry.name == topics::kGpsData.name) {
    Keep(RowAs<GpsFix>(t, value));
  } else if (entry.name == topics::kDetections.name) {
    Keep(RowAs<Detections>(t, value));
  } else if (entry.name == topics::kFogYawRate.name) {
    Keep(entry.number ? std::optional<StreamRow>(FogRow{t, *entry.number}) : std::nullopt);
  } else if (entry.name == topics::kDepthSensor.name) {
    Keep(entry.number ? std::optional<StreamRow>(DepthRow{t, *entry.number}) : std::nullopt);
  } else {
    return false;
  }
  return true;
}

}  // namespace limpet

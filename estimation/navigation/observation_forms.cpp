// SPDX-License-Identifier: MIT
#include "estimation/navigation/observation_forms.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <mrpt/core/Clock.h>
#include <mrpt/obs/CObservationIMU.h>
#include <mrpt/obs/CObservationRawDAQ.h>
#include <mrpt/obs/CObservationRobotPose.h>

#include "limpet/core/config.hpp"

namespace limpet {
namespace {

using mrpt::obs::CObservationIMU;
using mrpt::obs::CObservationRawDAQ;
using mrpt::obs::CObservationRobotPose;
using mrpt::obs::TIMUDataIndex;

/// MRPT counts ticks of 0.1 us since 1601.
constexpr std::int64_t kTicksTo1970 = 116'444'736'000'000'000;
constexpr std::size_t kNumbersOfAFrame = 3;
constexpr std::size_t kNumbersOfABox = 5;  // u, v, w, h, confidence
constexpr std::array kVelocity{mrpt::obs::IMU_X_VEL, mrpt::obs::IMU_Y_VEL, mrpt::obs::IMU_Z_VEL};
constexpr std::array kInertial{mrpt::obs::IMU_X_ACC, mrpt::obs::IMU_Y_ACC, mrpt::obs::IMU_Z_ACC,
                               mrpt::obs::IMU_WX,    mrpt::obs::IMU_WY,    mrpt::obs::IMU_WZ,
                               mrpt::obs::IMU_YAW};

bool HasAll(const CObservationIMU& imu, std::span<const TIMUDataIndex> fields) {
  return std::ranges::all_of(fields, [&imu](TIMUDataIndex field) { return imu.has(field); });
}

Eigen::Vector3d Three(const CObservationIMU& imu, std::span<const TIMUDataIndex> fields) {
  return {imu.get(fields[0]), imu.get(fields[1]), imu.get(fields[2])};
}

template <class T>
ObservationPtr WithStamp(double t, const char* label, std::shared_ptr<T> seen) {
  return Stamp(t, label, *seen) ? ObservationPtr(std::move(seen)) : nullptr;
}

}  // namespace

double SecondsOf(const mrpt::obs::CObservation& seen) {
  const std::int64_t ticks = seen.timestamp.time_since_epoch().count();
  return static_cast<double>((static_cast<long double>(ticks) - kTicksTo1970) / 1e7L);
}

bool Stamp(double t, const char* label, mrpt::obs::CObservation& seen) {
  if (!(t > -1e10 && t < 8e11)) return false;
  const auto ticks = static_cast<std::int64_t>(std::llround(static_cast<long double>(t) * 1e7L));
  seen.timestamp = mrpt::Clock::time_point(mrpt::Clock::duration(ticks + kTicksTo1970));
  seen.sensorLabel = label;
  return true;
}

ObservationPtr ObservationOf(const InertialInput& sample) {
  auto imu = CObservationIMU::Create();
  const std::array numbers{sample.force_B.x(), sample.force_B.y(), sample.force_B.z(),
                           sample.rate_B.x(),  sample.rate_B.y(),  sample.rate_B.z(),
                           sample.heading};
  for (std::size_t i = 0; i < kInertial.size(); ++i)
    imu->set(kInertial.at(i), numbers.at(i));
  return WithStamp(sample.t, observation_labels::kImu, std::move(imu));
}

ObservationPtr ObservationOf(const YawRate& turning) {
  auto imu = CObservationIMU::Create();
  imu->set(mrpt::obs::IMU_WZ, turning.rate);
  return WithStamp(turning.t, observation_labels::kFog, std::move(imu));
}

ObservationPtr ObservationOf(const BottomTrack& ping) {
  auto imu = CObservationIMU::Create();
  for (std::size_t i = 0; ping.v_WD_D && i < kVelocity.size(); ++i)
    imu->set(kVelocity.at(i), (*ping.v_WD_D)(static_cast<Eigen::Index>(i)));
  if (ping.altitude) imu->set(mrpt::obs::IMU_ALTITUDE, *ping.altitude);
  return WithStamp(ping.t, observation_labels::kDvl, std::move(imu));
}

ObservationPtr ObservationOf(const SlantRanges& ping) {
  auto some = CObservationRawDAQ::Create();
  for (const std::optional<double>& beam : ping.beams)
    some->AIN_double.push_back(beam.value_or(std::numeric_limits<double>::quiet_NaN()));
  return WithStamp(ping.t, observation_labels::kBeams, std::move(some));
}

ObservationPtr ObservationOf(const DepthReading& reading) {
  auto imu = CObservationIMU::Create();
  imu->set(mrpt::obs::IMU_Z, reading.depth);
  return WithStamp(reading.t, observation_labels::kDepth, std::move(imu));
}

ObservationPtr ObservationOf(const PositionFix& fix) {
  constexpr double kUnknown = 1e6;  // variance of what a fix does not tell
  auto pose = CObservationRobotPose::Create();
  pose->pose.mean = mrpt::poses::CPose3D(fix.p_W.x(), fix.p_W.y(), 0.0, 0.0, 0.0, 0.0);
  pose->pose.cov.setZero();
  for (int i = 0; i < 6; ++i)
    pose->pose.cov(i, i) = i < 2 ? fix.sd * fix.sd : kUnknown;
  return WithStamp(fix.t, observation_labels::kGps, std::move(pose));
}

ObservationPtr ObservationOf(const ThrusterShares& command) {
  auto some = CObservationRawDAQ::Create();
  some->AIN_double.assign(command.shares.begin(), command.shares.end());
  return WithStamp(command.t, observation_labels::kThrusters, std::move(some));
}

ObservationPtr ObservationOf(const Detections& frame, double arrival) {
  auto some = CObservationRawDAQ::Create();
  some->AIN_double = {static_cast<double>(frame.frame), frame.exposure.value(), arrival};
  for (const Box& box : frame.boxes) {
    for (const double number : {box.u, box.v, box.w, box.h, box.confidence})
      some->AIN_double.push_back(number);
    for (const char letter : box.color)
      some->AIN_8bits.push_back(static_cast<std::uint8_t>(letter == '\n' ? ' ' : letter));
    some->AIN_8bits.push_back('\n');
  }
  return WithStamp(frame.exposure.value(), observation_labels::kBoxes, std::move(some));
}

std::optional<InertialInput> InertialOf(const mrpt::obs::CObservation& seen) {
  const auto* imu = dynamic_cast<const CObservationIMU*>(&seen);
  if (imu == nullptr || !HasAll(*imu, kInertial)) return std::nullopt;
  const std::span fields(kInertial);
  return InertialInput{.t = SecondsOf(seen),
                       .force_B = Three(*imu, fields.first(3)),
                       .rate_B = Three(*imu, fields.subspan(3, 3)),
                       .heading = imu->get(mrpt::obs::IMU_YAW)};
}

std::optional<YawRate> YawRateOf(const mrpt::obs::CObservation& seen) {
  const auto* imu = dynamic_cast<const CObservationIMU*>(&seen);
  if (imu == nullptr || !imu->has(mrpt::obs::IMU_WZ)) return std::nullopt;
  return YawRate{.t = SecondsOf(seen), .rate = imu->get(mrpt::obs::IMU_WZ)};
}

std::optional<BottomTrack> BottomTrackOf(const mrpt::obs::CObservation& seen) {
  const auto* imu = dynamic_cast<const CObservationIMU*>(&seen);
  if (imu == nullptr) return std::nullopt;
  BottomTrack ping{.t = SecondsOf(seen), .v_WD_D = {}, .altitude = {}};
  if (HasAll(*imu, kVelocity)) ping.v_WD_D = Three(*imu, kVelocity);
  if (imu->has(mrpt::obs::IMU_ALTITUDE)) ping.altitude = imu->get(mrpt::obs::IMU_ALTITUDE);
  return ping;
}

std::optional<SlantRanges> SlantRangesOf(const mrpt::obs::CObservation& seen) {
  const auto* some = dynamic_cast<const CObservationRawDAQ*>(&seen);
  SlantRanges ping{.t = SecondsOf(seen)};
  if (some == nullptr || some->AIN_double.size() != ping.beams.size()) return std::nullopt;
  for (std::size_t i = 0; i < ping.beams.size(); ++i)
    if (std::isfinite(some->AIN_double[i])) ping.beams.at(i) = some->AIN_double[i];
  return ping;
}

std::optional<DepthReading> DepthOf(const mrpt::obs::CObservation& seen) {
  const auto* imu = dynamic_cast<const CObservationIMU*>(&seen);
  if (imu == nullptr || !imu->has(mrpt::obs::IMU_Z)) return std::nullopt;
  return DepthReading{.t = SecondsOf(seen), .depth = imu->get(mrpt::obs::IMU_Z)};
}

std::optional<PositionFix> FixOf(const mrpt::obs::CObservation& seen) {
  const auto* fix = dynamic_cast<const CObservationRobotPose*>(&seen);
  if (fix == nullptr) return std::nullopt;
  const auto& cov = fix->pose.cov;
  return PositionFix{.t = SecondsOf(seen),
                     .p_W = {fix->pose.mean.x(), fix->pose.mean.y()},
                     .sd = std::sqrt(std::max(cov(0, 0), cov(1, 1)))};
}

std::optional<ThrusterShares> ThrusterSharesOf(const mrpt::obs::CObservation& seen) {
  const auto* some = dynamic_cast<const CObservationRawDAQ*>(&seen);
  ThrusterShares command{.t = SecondsOf(seen)};
  if (some == nullptr || some->AIN_double.size() != command.shares.size() ||
      !std::ranges::all_of(some->AIN_double, [](double share) { return std::isfinite(share); })) {
    return std::nullopt;
  }
  std::ranges::copy(some->AIN_double, command.shares.begin());
  return command;
}

std::optional<SeenFrame> FrameOf(const mrpt::obs::CObservation& seen) {
  const auto* some = dynamic_cast<const CObservationRawDAQ*>(&seen);
  if (some == nullptr || some->AIN_double.size() < kNumbersOfAFrame) return std::nullopt;
  const std::vector<double>& numbers = some->AIN_double;
  const std::size_t count = (numbers.size() - kNumbersOfAFrame) / kNumbersOfABox;
  const std::vector<std::string> classes =
      Split({reinterpret_cast<const char*>(some->AIN_8bits.data()), some->AIN_8bits.size()}, '\n');
  if (numbers.size() != kNumbersOfAFrame + count * kNumbersOfABox || classes.size() < count ||
      !(std::abs(numbers[0]) < 2e9)) {
    return std::nullopt;
  }
  SeenFrame result{.frame = {.frame = static_cast<int>(numbers[0]),
                             .exposure = Seconds(numbers[1]),
                             .boxes = {}},
                   .arrival = numbers[2]};
  for (std::size_t i = 0; i < count; ++i) {
    const double* n = &numbers[kNumbersOfAFrame + i * kNumbersOfABox];
    if (!std::isfinite(n[0] + n[1] + n[2] + n[3] + n[4])) {
      ++result.refused_boxes;
      result.frame.boxes.emplace_back();  // its confidence is 0
      continue;
    }
    result.frame.boxes.push_back(
        {.u = n[0], .v = n[1], .w = n[2], .h = n[3], .confidence = n[4], .color = classes[i]});
  }
  return result;
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/recordings/own_track.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "limpet/recordings/depth_rates.hpp"

namespace limpet {
namespace {

/// 1-sigma of roll and pitch that nobody tells [rad]: 3 deg.
constexpr double kTiltSigma = 0.05;

void AddHeadings(const std::vector<TimedNumber>& headings, Radians sigma, SensorStream& stream) {
  for (std::size_t i = 0; i < headings.size(); ++i) {
    const double step = i > 0 ? headings[i].t - headings[i - 1].t : 0.0;
    const double turned =
        i > 0 ? std::remainder(headings[i].value - headings[i - 1].value, 2.0 * std::numbers::pi)
              : 0.0;
    stream.rows.emplace_back(
        AttitudeEstimate{.t = headings[i].t,
                         .roll = 0.0,
                         .pitch = 0.0,
                         .yaw = std::remainder(headings[i].value, 2.0 * std::numbers::pi),
                         .yaw_rate = step > 0.0 ? turned / step : 0.0,
                         .sd_roll = kTiltSigma,
                         .sd_pitch = kTiltSigma,
                         .sd_yaw = sigma.value()});
  }
}

double TimeOf(const StreamRow& row) {
  return std::visit(
      [](const auto& measured) {
        if constexpr (requires { measured.t; }) {
          return measured.t;
        } else {
          return measured.arrival;
        }
      },
      row);
}

}  // namespace

Expected<SensorStream> StreamOf(const Recording& recording, Radians heading_sigma) {
  if (recording.own.headings.empty() || recording.own.speeds.empty()) {
    return Error{fmt::format("{}: no track can be reckoned from it", recording.name)};
  }
  SensorStream stream;
  AddHeadings(recording.own.headings, heading_sigma, stream);
  DepthRates rates(recording.depths);
  for (const TimedNumber& speed : recording.own.speeds) {
    stream.rows.emplace_back(
        DvlRow{.t = speed.t,
               .v_WD_B = Eigen::Vector3d(speed.value, 0.0, rates.At(speed.t).value_or(0.0)),
               .altitude = {},
               .beams = {}});
  }
  for (const DepthReading& depth : recording.depths)
    stream.rows.emplace_back(depth);
  std::ranges::stable_sort(stream.rows, {}, TimeOf);
  return stream;
}

TrackDifference CompareTracks(const std::vector<SmoothedPose>& track,
                              const std::vector<TimedPlace>& own) {
  TrackDifference difference;
  if (track.empty() || own.empty()) return difference;
  std::optional<Eigen::Vector2d> offset;
  std::size_t i = 0;
  for (const SmoothedPose& pose : track) {
    while (i + 1 < own.size() && own[i + 1].t <= pose.t) {
      difference.path += (own[i + 1].p_W - own[i].p_W).norm();
      ++i;
    }
    if (own[i].t > pose.t || i + 1 == own.size()) continue;
    const double span = own[i + 1].t - own[i].t;
    const double share = span > 0.0 ? (pose.t - own[i].t) / span : 0.0;
    const Eigen::Vector2d there = own[i].p_W + share * (own[i + 1].p_W - own[i].p_W);
    const Eigen::Vector2d here = pose.X_WB.p_WB.head<2>();
    if (!offset) offset = here - there;
    difference.at_end = (here - there - *offset).norm();
    difference.greatest = std::max(difference.greatest, difference.at_end);
  }
  return difference;
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "estimation/navigation/sensor_agreement.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "limpet/core/frames.hpp"

namespace limpet {
namespace {

constexpr double kLeastTurn = 0.2;     // [rad] of a stretch: a dozen times a heading's noise
constexpr double kLeastDive = 0.3;     // [m] of a stretch
constexpr double kDepthSigmas = 14.0;  // and so many of a second's depth
constexpr double kLeastWay = 12.0;     // [m] of a stretch
constexpr double kWorstFix = 1.5;      // [m] 1-sigma of fixes that tell of it
constexpr double kLeastDriven = 2.0;   // [m] of a stretch
constexpr double kLeastRatio = 0.5, kMostRatio = 2.0;  // times as far: still the same motion
constexpr double kAside = 0.5;                         // times as far across it: some 30 degrees
// Thrust may be half or twice of what the hull's sheet says, and the water may go half as fast as
// the vehicle, so along and across the thrust these are still possible.
constexpr double kBackwards = -0.25, kTooFast = 6.0, kAcross = 0.8;

}  // namespace

SensorAgreement::SensorAgreement(Meters depth_sigma)
    : turn_({.stretch = Seconds(2.0), .least = kLeastTurn}),
      // A dive is over soon, and a vehicle that drives the wrong way is gone soon.
      dive_({.stretch = Seconds(2.0),
             .least = std::max(kLeastDive, kDepthSigmas * depth_sigma.value()),
             .stretches = 5}),
      way_({.stretch = Seconds(30.0), .least = kLeastWay, .longest_pause = Seconds(5.0)}),
      drive_({.stretch = Seconds(10.0), .least = kLeastDriven, .stretches = 5}) {}

void SensorAgreement::AddHeadings(double t, const Headings& headings) {
  const Headings before = last_headings_.value_or(headings);
  last_headings_ = headings;
  turn_.Add(t, {WrapAngle(headings.gyro - before.gyro), 0.0},
            {WrapAngle(headings.compass - before.compass), 0.0});
}

void SensorAgreement::AddDive(double t, const Dive& dive) {
  const auto [before_t, before] = last_dive_.value_or(std::pair(t, dive));
  last_dive_ = {t, dive};
  const double sunk = 0.5 * (dive.v_down + before.v_down) * (t - before_t);
  dive_.Add(t, {sunk, 0.0}, {dive.depth - before.depth, 0.0});
}

void SensorAgreement::AddFix(double t, const Eigen::Vector2d& p_W, double sd,
                             const Eigen::Vector2d& track_D) {
  if (sd > kWorstFix) return;
  const FixSample now{.p_W = p_W, .track_D = track_D};
  const FixSample before = last_fix_.value_or(now);
  last_fix_ = now;
  way_.Add(t, now.track_D - before.track_D, now.p_W - before.p_W);
}

void SensorAgreement::AddDrive(double t, const Eigen::Vector2d& driven_H,
                               const Eigen::Vector2d& v_H) {
  const double dt = t - last_drive_t_.value_or(t);
  last_drive_t_ = t;
  drive_.Add(t, dt * driven_H, dt * v_H);
}

std::vector<Disagreement> SensorAgreement::Found() const {
  std::vector<Disagreement> found;
  const auto is_other = [](double ratio) { return !(ratio >= kLeastRatio && ratio <= kMostRatio); };
  if (const auto turn = turn_.ratio(); turn && is_other(turn->median_H.x())) {
    found.push_back(
        {kTurn,
         fmt::format("the compass turns {:.3g} times as far as the gyro says: a sign, an axis or a "
                     "unit of one of them is wrong, or it does not turn freely",
                     turn->median_H.x())});
  }
  if (const auto dive = dive_.ratio(); dive && is_other(dive->median_H.x())) {
    found.push_back(
        {kDive,
         fmt::format("depth grows by {:.3g} times of what the DVL sinks: the sign, the axis or the "
                     "unit of one of them is wrong",
                     dive->median_H.x())});
  }
  if (const auto way = way_.ratio()) {
    const auto is_off = [&](const Eigen::Vector2d& ratio_H) {
      return is_other(ratio_H.x()) || std::abs(ratio_H.y()) > kAside;
    };
    if (is_off(way->low_H) || is_off(way->high_H)) {
      found.push_back(
          {kWay,
           fmt::format("fixes go {:.2g} to {:.2g} times as far as the DVL along its way, and "
                       "{:.2g} to {:.2g} times to starboard of it: the heading does not count "
                       "clockwise from north, or signs, axes, mounting or unit of the DVL "
                       "are wrong",
                       way->low_H.x(), way->high_H.x(), way->low_H.y(), way->high_H.y())});
    }
  }
  if (const auto drive = drive_.ratio()) {
    const Eigen::Vector2d ratio_H = drive->median_H;
    const bool is_wrong =
        ratio_H.x() < kBackwards || ratio_H.x() > kTooFast || std::abs(ratio_H.y()) > kAcross;
    if (is_wrong) {
      found.push_back(
          {kDrive, fmt::format("the DVL goes {:.2g} times as far as the thrusters push along "
                               "their push, and {:.2g} times to starboard of it: signs, axes, "
                               "mounting or unit of the DVL, or of the thrusters, are wrong",
                               ratio_H.x(), ratio_H.y())});
    }
  }
  return found;
}

}  // namespace limpet

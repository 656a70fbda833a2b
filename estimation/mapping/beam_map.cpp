// SPDX-License-Identifier: MIT
#include "estimation/mapping/beam_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limpet {
namespace {

constexpr int kLookWork = 1;
constexpr int kLayWork = 100;

/// Pings up to this time stay where they are: the shift begins with steps that are none [s].
double StaysUntil(const TrackShift& shift) {
  const auto is_none = [](const std::array<double, 5>& step) {
    return std::all_of(step.begin() + 1, step.end(), [](double part) { return part == 0.0; });
  };
  const auto first = std::ranges::find_if_not(shift.steps, is_none);
  return first == shift.steps.begin() ? -std::numeric_limits<double>::infinity()
                                      : (*std::prev(first))[0];
}

}  // namespace

BeamMap::BeamMap(Meters resolution, const DvlBeams& dvl)
    : directions_(BeamDirections(dvl)),
      reach_(std::sin(dvl.from_vertical.value())),
      evidence_(resolution.value()),
      depths_(resolution.value()) {}

int BeamMap::Add(double t, const PosedBeams& ping, const std::vector<BeamEnd>& ends) {
  const std::array<std::optional<double>, 4> ranges{ping.b1, ping.b2, ping.b3, ping.b4};
  Ping kept{.t = pings_.empty() ? t : std::max(t, pings_.back().t),
            .p_WD = {static_cast<float>(ping.north), static_cast<float>(ping.east),
                     static_cast<float>(ping.down)},
            .roll = static_cast<float>(ping.roll),
            .pitch = static_cast<float>(ping.pitch),
            .yaw = static_cast<float>(ping.yaw)};
  int laid = 0;
  const bool is_near = evidence_.Holds(ping.pose().p_WB);
  for (const BeamEnd& end : ends) {
    if (!is_near || !evidence_.Holds(end.p_W)) continue;
    ++laid;
    kept.ranges[end.beam] = static_cast<float>(ranges[end.beam].value_or(0.0));
    const auto bit = static_cast<std::uint8_t>(1U << end.beam);
    kept.used = static_cast<std::uint8_t>(kept.used | bit);
    kept.seabed = static_cast<std::uint8_t>(kept.seabed | (end.is_seabed ? bit : 0U));
  }
  if (laid > 0) {
    Lay(kept, Laying::kAdd);
    pings_.push_back(kept);
    NoteDepthSigma(ping);
  }
  return laid;
}

void BeamMap::NoteDepthSigma(const PosedBeams& ping) {
  if (!ping.sd_down) return;
  down_variance_ += *ping.sd_down * *ping.sd_down;
  ++with_variance_;
  depths_.SetZeroSigma(std::sqrt(down_variance_ / with_variance_));
}

void BeamMap::Lay(const Ping& ping, Laying laying) {
  const Eigen::Vector3d p_WD =
      Eigen::Vector3f(ping.p_WD[0], ping.p_WD[1], ping.p_WD[2]).cast<double>();
  const Eigen::Matrix3d R_WD = RotationFromRollPitchYaw(ping.roll, ping.pitch, ping.yaw);
  for (std::size_t beam = 0; beam < ping.ranges.size(); ++beam) {
    if ((ping.used >> beam & 1U) == 0) continue;
    const Eigen::Vector3d end_W =
        p_WD + R_WD * (static_cast<double>(ping.ranges[beam]) * directions_[beam]);
    if (!evidence_.Holds(p_WD) || !evidence_.Holds(end_W)) continue;  // nor was it laid there
    const bool is_seabed = (ping.seabed >> beam & 1U) != 0;
    if (laying == Laying::kAdd) {
      evidence_.Add(p_WD, end_W);
      if (is_seabed) depths_.Add(end_W);
    } else {
      evidence_.TakeBack(p_WD, end_W);
      if (is_seabed) depths_.TakeBack(end_W);
    }
  }
}

void BeamMap::Shift(const TrackShift& shift) {
  if (shift.steps.empty()) return;
  const auto is_until = [](double t) { return [t](const Ping& ping) { return ping.t <= t; }; };
  const auto first = std::ranges::partition_point(pings_, is_until(StaysUntil(shift)));
  const auto end = std::ranges::partition_point(pings_, is_until(shift.steps.back()[0]));
  if (first < end) {
    sweeps_.push_back({.shift = shift,
                       .next = static_cast<std::size_t>(first - pings_.begin()),
                       .end = static_cast<std::size_t>(end - pings_.begin())});
  }
}

double BeamMap::Owed(const Ping& ping) const {
  const auto [north, east, down, yaw] = ping.owed;
  const double swing = std::abs(static_cast<double>(yaw)) * reach_ *
                       static_cast<double>(std::ranges::max(ping.ranges));
  return std::sqrt(static_cast<double>(north * north + east * east + down * down)) + swing;
}

int BeamMap::Move(Ping& ping, const TrackShift& shift) {
  const Pose moved = shift.Apply(ping.t, Pose{});
  for (std::size_t axis = 0; axis < 3; ++axis) {
    ping.owed[axis] += static_cast<float>(moved.p_WB[static_cast<Eigen::Index>(axis)]);
  }
  ping.owed[3] += static_cast<float>(moved.yaw);
  if (Owed(ping) <= kStays) return kLookWork;
  Lay(ping, Laying::kTakeBack);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    ping.p_WD[axis] += ping.owed[axis];
  }
  ping.yaw += ping.owed[3];
  ping.owed = {};
  Lay(ping, Laying::kAdd);
  return kLayWork;
}

bool BeamMap::Settle(int work) {
  while (!sweeps_.empty()) {
    Sweep& sweep = sweeps_.front();
    for (; sweep.next < sweep.end; ++sweep.next) {
      if (work <= 0) return false;
      work -= Move(pings_[sweep.next], sweep.shift);
    }
    sweeps_.pop_front();
  }
  return true;
}

void BeamMap::SettleAll() {
  while (!Settle()) {
  }
}

}  // namespace limpet

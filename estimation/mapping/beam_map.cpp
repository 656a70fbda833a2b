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

/// Sorts the pings' numbers in ascending order and removes repeated ones.
void LeaveEachOnce(std::vector<std::uint32_t>& pings) {
  std::ranges::sort(pings);
  pings.erase(std::unique(pings.begin(), pings.end()), pings.end());
}

}  // namespace

BeamMap::BeamMap(Meters resolution, const DvlBeams& dvl, std::size_t most_held)
    : directions_(BeamDirections(dvl)),
      reach_(std::sin(dvl.from_vertical.value())),
      evidence_(resolution.value(), most_held),
      depths_(resolution.value()) {}

int BeamMap::Add(double t, const PosedBeams& ping, const std::vector<BeamEnd>& ends) {
  const std::array<std::optional<double>, 4> ranges{ping.b1, ping.b2, ping.b3, ping.b4};
  Ping kept{.t = pings_.empty() ? t : std::max(t, pings_.back().t), .X_WD = ping.pose()};
  int held = 0;
  for (const BeamEnd& end : ends) {
    held += evidence_.Holds(ping.pose().p_WB) && evidence_.Holds(end.p_W) ? 1 : 0;
    kept.ranges[end.beam] = ranges[end.beam].value_or(0.0);
    const auto bit = static_cast<std::uint8_t>(1U << end.beam);
    kept.used = static_cast<std::uint8_t>(kept.used | bit);
    kept.seabed = static_cast<std::uint8_t>(kept.seabed | (end.is_seabed ? bit : 0U));
  }
  Lay(static_cast<std::uint32_t>(pings_.size()), kept, Laying::kAdd);
  pings_.push_back(kept);
  evidence_.DropUnused();
  NoteDepthSigma(ping);
  return held;
}

Eigen::Vector3d BeamMap::EndOf(const Ping& ping, const Eigen::Matrix3d& R_WD,
                               std::size_t beam) const {
  return ping.X_WD.p_WB + R_WD * (ping.ranges[beam] * directions_[beam]);
}

std::vector<Eigen::Vector3d> BeamMap::SeabedEnds(std::size_t ping) const {
  const Ping& kept = pings_[ping];
  const Eigen::Matrix3d R_WD = RotationOf(kept.X_WD);
  std::vector<Eigen::Vector3d> ends;
  for (std::size_t beam = 0; beam < kept.ranges.size(); ++beam) {
    if (kept.sees_seabed(beam)) ends.push_back(EndOf(kept, R_WD, beam));
  }
  return ends;
}

void BeamMap::NoteDepthSigma(const PosedBeams& ping) {
  if (!ping.sd_down) return;
  down_variance_ += *ping.sd_down * *ping.sd_down;
  ++with_variance_;
  depths_.SetZeroSigma(std::sqrt(down_variance_ / with_variance_));
}

template <class Visit>
void BeamMap::ForEachBeam(const Ping& ping, const Visit& visit) const {
  if (!evidence_.Holds(ping.X_WD.p_WB)) return;
  const Eigen::Matrix3d R_WD = RotationOf(ping.X_WD);
  for (std::size_t beam = 0; beam < ping.ranges.size(); ++beam) {
    if (!ping.uses(beam)) continue;
    const Eigen::Vector3d end_W = EndOf(ping, R_WD, beam);
    if (evidence_.Holds(end_W)) visit(beam, end_W);
  }
}

void BeamMap::NoteTiles(std::uint32_t ping, const Eigen::AlignedBox3d& extent_W) {
  const TileKey from = TileOf(KeyOf(extent_W.min(), evidence_.resolution()));
  const TileKey to = TileOf(KeyOf(extent_W.max(), evidence_.resolution()));
  for (TileKey tile = from; tile.north <= to.north; ++tile.north) {
    for (tile.east = from.east; tile.east <= to.east; ++tile.east) {
      TilePings& known = tile_pings_[tile];
      if (!known.pings.empty() && known.pings.back() == ping) continue;
      known.pings.push_back(ping);
      // A track that moves time and again must not make the list grow.
      if (known.pings.size() > 2 * known.each_once + 1024) {
        LeaveEachOnce(known.pings);
        known.each_once = known.pings.size();
      }
    }
  }
}

void BeamMap::Lay(std::uint32_t number, const Ping& ping, Laying laying) {
  const Eigen::Vector3d& p_WD = ping.X_WD.p_WB;
  Eigen::AlignedBox3d extent_W;
  ForEachBeam(ping, [&](std::size_t beam, const Eigen::Vector3d& end_W) {
    if (laying == Laying::kAdd) {
      extent_W.extend(end_W);
      evidence_.Add(p_WD, end_W);
      if (ping.sees_seabed(beam)) depths_.Add(end_W);
    } else {
      evidence_.TakeBack(p_WD, end_W);
      if (ping.sees_seabed(beam)) depths_.TakeBack(end_W);
    }
  });
  if (!extent_W.isEmpty()) NoteTiles(number, extent_W.extend(p_WD));
}

void BeamMap::Hold(const TileKey& tile) const {
  const auto found = tile_pings_.find(tile);
  if (found == tile_pings_.end()) return;
  std::vector<std::uint32_t> pings = found->second.pings;
  LeaveEachOnce(pings);
  evidence_.Hold(tile, [&](const BeamEvidence::BeamVisitor& visit) {
    for (const std::uint32_t number : pings) {
      const Ping& ping = pings_[number];
      ForEachBeam(ping, [&](std::size_t /*beam*/, const Eigen::Vector3d& end_W) {
        visit(ping.X_WD.p_WB, end_W);
      });
    }
  });
}

VoxelCounts BeamMap::At(const VoxelKey& key) const {
  if (const TileKey tile = TileOf(key); evidence_.IsDropped(tile)) Hold(tile);
  return evidence_.At(key);
}

void BeamMap::ForEachKnown(const TileKey& tile, const BeamEvidence::VoxelVisitor& visit) const {
  if (evidence_.IsDropped(tile)) Hold(tile);
  evidence_.ForEachKnown(tile, visit);
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
  const double swing = std::abs(static_cast<double>(yaw)) * reach_ * std::ranges::max(ping.ranges);
  return std::sqrt(static_cast<double>(north * north + east * east + down * down)) + swing;
}

int BeamMap::Move(std::uint32_t number, const TrackShift& shift) {
  Ping& ping = pings_[number];
  const Pose moved = shift.Apply(ping.t, Pose{});
  for (std::size_t axis = 0; axis < 3; ++axis) {
    ping.owed[axis] += static_cast<float>(moved.p_WB[static_cast<Eigen::Index>(axis)]);
  }
  ping.owed[3] += static_cast<float>(moved.yaw);
  if (Owed(ping) <= kStays) return kLookWork;
  Lay(number, ping, Laying::kTakeBack);
  ping.X_WD.p_WB += Eigen::Vector3f(ping.owed[0], ping.owed[1], ping.owed[2]).cast<double>();
  ping.X_WD.yaw += static_cast<double>(ping.owed[3]);
  ping.owed = {};
  Lay(number, ping, Laying::kAdd);
  return kLayWork;
}

bool BeamMap::Settle(int work) {
  while (!sweeps_.empty()) {
    Sweep& sweep = sweeps_.front();
    for (; sweep.next < sweep.end; ++sweep.next) {
      if (work <= 0) return false;
      work -= Move(static_cast<std::uint32_t>(sweep.next), sweep.shift);
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

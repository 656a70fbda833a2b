// SPDX-License-Identifier: MIT
#include "limpet/waypoints/track_crossings.hpp"

#include <algorithm>

#include "limpet/waypoints/left_of.hpp"
#include "limpet/waypoints/map_geometry.hpp"

namespace limpet {
namespace {

/// True if two pieces of a track meet.
bool Meet(const MapLeg& one, const MapLeg& other) {
  const auto straddles = [](const MapLeg& line, const MapLeg& ends) {
    return LeftOf(line.from, line.to, ends.from) * LeftOf(line.from, line.to, ends.to) <= 0.0;
  };
  const auto reach = [](double a, double b, double c, double d) {
    return std::max(std::min(a, b), std::min(c, d)) <= std::min(std::max(a, b), std::max(c, d));
  };
  return straddles(one, other) && straddles(other, one) &&
         reach(one.from.x, one.to.x, other.from.x, other.to.x) &&
         reach(one.from.y, one.to.y, other.from.y, other.to.y);
}

}  // namespace

void TrackCrossings::Move(const MapPoint& at) {
  constexpr double kStep = 1.0;           // [m]
  constexpr std::size_t kLongest = 5000;  // pieces; what is older is forgotten
  if (!track_.empty() && DistanceBetween(track_.back(), at) < kStep) return;
  if (Crosses(at)) {
    ++count_;
    track_.clear();
    return;
  }
  if (track_.size() > kLongest) track_.erase(track_.begin());
  track_.push_back(at);
}

/// The last piece always meets the new one: it is left out.
bool TrackCrossings::Crosses(const MapPoint& at) const {
  for (std::size_t i = 0; i + 2 < track_.size(); ++i) {
    if (Meet({track_[i], track_[i + 1]}, {track_.back(), at})) return true;
  }
  return false;
}

}  // namespace limpet

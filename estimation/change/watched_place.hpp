// SPDX-License-Identifier: MIT
// How exactly a place is watched, and when it is to be watched anew.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "estimation/change/place_watch.hpp"

namespace limpet {

/// A landmark relative to the poses it was seen from: the error that they share moves both.
[[nodiscard]] inline ObjectEstimate WatchedPlace(ObjectEstimate place) {
  constexpr double kRelativeSigma = 0.15;  // [m]
  place.cov_W = kRelativeSigma * kRelativeSigma * Eigen::Matrix3d::Identity();
  return place;
}

/// How much larger one of them is than the other, as a natural logarithm; infinite where only one
/// is known.
[[nodiscard]] inline double SizeChange(const ObjectEstimate& a, const ObjectEstimate& b) {
  if (a.is_size_known() != b.is_size_known()) return std::numeric_limits<double>::infinity();
  return a.is_size_known() ? std::abs(std::log(a.size->radius / b.size->radius)) : 0.0;
}

/// True if the place is now somewhere else, or its object known to be of another size, or the place
/// much better or worse than when it was judged: then it is judged again from all frames.
[[nodiscard]] inline bool HasMoved(const PlaceWatch& watch, const ObjectEstimate& place) {
  constexpr double kDistance = 0.3;     // [m]
  constexpr double kSpread = 0.3;       // share by which its standard deviation may change,
  constexpr double kLeastSpread = 0.1;  // and by how much in any case [m]
  constexpr double kSize = 0.1;         // logarithm of the share by which its size may
  const auto spread = [](const ObjectEstimate& object) {
    return std::sqrt(std::max(object.cov_W(0, 0) + object.cov_W(1, 1), 0.0));
  };
  const double change = std::abs(spread(place) - spread(watch.place()));
  return (watch.place().p_W - place.p_W).norm() > kDistance ||
         change > std::max(kSpread * spread(watch.place()), kLeastSpread) ||
         SizeChange(watch.place(), place) > kSize;
}

}  // namespace limpet

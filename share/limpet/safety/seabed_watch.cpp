// SPDX-License-Identifier: MIT
#include "limpet/safety/seabed_watch.hpp"

#include <algorithm>
#include <cmath>

namespace limpet {
namespace {

constexpr Seconds kKeepEvery(0.5);
constexpr Seconds kWindow(10.0);
constexpr double kSteepest = 0.6;  ///< metres of depth per metre of way

}  // namespace

void SeabedWatch::Hear(const NavState& nav, Seconds now) {
  if (!nav.altitude) {
    step_.reset();
    return;
  }
  const Sounding sounding{
      .time = now, .north = nav.north, .east = nav.east, .seabed = nav.down + *nav.altitude};
  double greatest = 0.0;
  for (std::size_t i = 0; i < std::min(count_, kKept); ++i) {
    const Sounding& former = kept_[i];
    if (now - former.time > kWindow) continue;
    const double way = std::hypot(sounding.north - former.north, sounding.east - former.east);
    greatest = std::max(greatest, std::abs(sounding.seabed - former.seabed) - kSteepest * way);
  }
  step_ = greatest;
  if (count_ == 0 || now - kept_[(count_ - 1) % kKept].time >= kKeepEvery) {
    kept_[count_ % kKept] = sounding;
    ++count_;
  }
}

}  // namespace limpet

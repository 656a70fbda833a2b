// SPDX-License-Identifier: MIT
#include "apps/pSurvey/transit.hpp"

namespace limpet {
namespace {

/// Nearer by less is no progress: a vehicle that a current holds sways [m].
constexpr double kProgressStepM = 1.0;

}  // namespace

bool Transit::Track(const NavState& nav, const Region& region) {
  const double outside = region.Outside({.north = nav.north, .east = nav.east, .yaw = nav.yaw});
  if (outside > 0.0 && outside > to_go_m_ - kProgressStepM) {
    return false;
  }
  to_go_m_ = outside;
  return true;
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/safety/depth_watch.hpp"

#include <cmath>

namespace limpet {
namespace {

constexpr Seconds kStillWanted(2.0);
constexpr double kNear_m = 1.0;      ///< less is a matter of control
constexpr double kProgress_m = 0.3;  ///< more than waves and noise bring
constexpr double kOther_m = 0.5;     ///< so far from what was wanted, it is another depth

}  // namespace

void DepthWatch::Hear(double depth, Seconds now) {
  if (!wanted_ || now - wanted_->time > kStillWanted) {
    begin_.reset();
    lacking_.reset();
    return;
  }
  const double off = std::abs(wanted_->value - depth);
  const bool goes_on = begin_ && off > kNear_m && off > begin_->off - kProgress_m &&
                       std::abs(wanted_->value - begin_->wanted) < kOther_m;
  if (!goes_on) begin_ = Begin{.at = now, .wanted = wanted_->value, .off = off};
  lacking_ = (now - begin_->at).value();
}

}  // namespace limpet

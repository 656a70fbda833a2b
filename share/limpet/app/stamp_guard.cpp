// SPDX-License-Identifier: MIT
#include "limpet/app/stamp_guard.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limpet {

StampGuard::Verdict StampGuard::Judge(const std::string& variable, Seconds stamp, Seconds now) {
  const bool is_number = std::isfinite(stamp.value());
  if (is_number && stamp <= now + kTolerance * warp_) {
    const auto known = refused_.empty() ? refused_.end() : refused_.find(variable);
    if (known == refused_.end() || !known->second.is_up ||
        now - known->second.last < kQuiet * warp_) {
      return Verdict::kGood;
    }
    known->second.is_up = false;
    return Verdict::kGoodAgain;
  }
  Refused& refused = refused_[variable];
  const double ahead = is_number ? (stamp - now).value() : std::numeric_limits<double>::infinity();
  ++refused.count;
  refused.farthest = Seconds(std::max(refused.farthest.value(), ahead));
  refused.last = now;
  refused.is_up = true;
  return Verdict::kRefused;
}

}  // namespace limpet

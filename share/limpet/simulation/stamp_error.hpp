// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "limpet/core/params.hpp"
#include "limpet/core/random.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

/// How a sensor's stamps differ from the time at which it measured.
struct StampErrorParams {
  Seconds delay{0.0};
  Seconds jitter{0.0};
  double late_share = 0.0;
  Seconds late{0.5};

  template <class V>
  void Describe(V& visit) {
    using namespace literals;
    visit("stamp_delay_s", delay, "Stamps are later than what they stamp; below 0: earlier",
          InRange(-1.0_s, 3.0_s));
    visit("stamp_jitter_s", jitter, "1-sigma of what every stamp is off by itself",
          InRange(0.0_s, 1.0_s));
    visit("late_share", late_share, "Share of the samples that a busy driver stamps too late",
          InRange(0.0, 1.0));
    visit("late_s", late, "How late the samples are that are stamped too late",
          InRange(0.0_s, 10.0_s));
  }
  [[nodiscard]] bool is_off() const {
    return delay == Seconds(0.0) && jitter == Seconds(0.0) && late_share == 0.0;
  }
};

/// Stamps of one sensor. A driver hands on its samples in order: no stamp lies before the last one.
class StampError {
 public:
  StampError(const StampErrorParams& params, Random random) : params_(params), random_(random) {}

  /// The stamp of what was measured at `now`, which does not go back.
  [[nodiscard]] Seconds StampOf(Seconds now) {
    if (params_.is_off()) return now;
    Seconds stamp = now + params_.delay + Seconds(random_.Normal(params_.jitter.value()));
    if (random_.Chance(params_.late_share)) stamp += params_.late;
    last_ = std::max(last_.value_or(stamp), stamp);
    return *last_;
  }

 private:
  StampErrorParams params_;
  Random random_;
  std::optional<Seconds> last_;
};

}  // namespace limpet

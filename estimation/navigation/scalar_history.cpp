// SPDX-License-Identifier: MIT
#include "estimation/navigation/scalar_history.hpp"

#include <algorithm>
#include <iterator>

namespace limpet {

void ScalarHistory::DropBefore(double t) {
  const auto is_old = [t](const Sample& sample) { return sample.t < t; };
  samples_.erase(samples_.begin(), std::ranges::find_if_not(samples_, is_old));
}

std::optional<double> ScalarHistory::last_time() const {
  return samples_.empty() ? std::nullopt : std::optional(samples_.back().t);
}

std::optional<ScalarHistory::Sample> ScalarHistory::Nearest(double t) const {
  if (samples_.empty()) return std::nullopt;
  const auto after = std::ranges::lower_bound(samples_, t, {}, &Sample::t);
  if (after == samples_.begin()) return *after;
  const auto before = std::prev(after);
  return after == samples_.end() || t - before->t <= after->t - t ? *before : *after;
}

std::optional<double> ScalarHistory::Slope(double span) const {
  double count = 0.0, sum_t = 0.0, sum_z = 0.0, sum_tt = 0.0, sum_tz = 0.0;
  for (auto sample = samples_.rbegin(); sample != samples_.rend(); ++sample) {
    const double age = samples_.back().t - sample->t;
    if (age > span) break;
    count += 1.0, sum_t -= age, sum_z += sample->value;
    sum_tt += age * age, sum_tz -= age * sample->value;
  }
  const double spread = count * sum_tt - sum_t * sum_t;
  return count >= 4.0 && spread > 0.0
             ? std::optional<double>((count * sum_tz - sum_t * sum_z) / spread)
             : std::nullopt;
}

}  // namespace limpet

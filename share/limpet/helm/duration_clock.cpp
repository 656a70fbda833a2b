// SPDX-License-Identifier: MIT
#include "limpet/helm/duration_clock.hpp"

#include <algorithm>

#include "limpet/core/number_text.hpp"

namespace limpet {

bool DurationClock::IsResetBy(std::string_view variable, const Value& value) const {
  if (settings_.reset_variable.empty() || settings_.reset_variable != variable) {
    return false;
  }
  if (settings_.reset_value.empty()) {
    return true;
  }
  if (const auto* text = std::get_if<std::string>(&value)) {
    return *text == settings_.reset_value;
  }
  const auto* number = std::get_if<double>(&value);
  return number != nullptr && ParseNumber(settings_.reset_value) == *number;
}

void DurationClock::Reset() {
  begun_.reset();
  running_ = idle_ = Seconds(0.0);
}

void DurationClock::Begin(Seconds now) {
  if (!begun_) {
    begun_ = now;
    idle_ = Seconds(0.0);  // what it was idle before it first ran does not count
  }
}

std::optional<Seconds> DurationClock::Remaining(Seconds now) const {
  if (!settings_.limit) {
    return std::nullopt;
  }
  if (!begun_) {
    return settings_.limit;
  }
  const Seconds elapsed = now - *begun_ - (settings_.counts_idle_time ? Seconds(0.0) : idle_);
  return std::max(*settings_.limit - elapsed, Seconds(0.0));
}

void DurationClock::Spend(Seconds now, bool is_running) {
  const Seconds elapsed = now - spent_.value_or(now);
  spent_ = now;
  (is_running ? running_ : idle_) += elapsed;
}

}  // namespace limpet

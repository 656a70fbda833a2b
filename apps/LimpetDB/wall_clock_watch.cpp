// SPDX-License-Identifier: MIT
#include "apps/LimpetDB/wall_clock_watch.hpp"

#include <cmath>

#include <fmt/format.h>

#include "limpet/core/record.hpp"
#include "limpet/topics/wall_clock.hpp"

namespace limpet {

std::optional<WallClockWatch::News> WallClockWatch::Look(Seconds vehicle, Seconds wall) {
  const Seconds ahead = wall - vehicle;
  const bool has_stepped = std::abs((ahead - told_ahead_).value()) > kNoticed.value();
  if (told_ && !has_stepped && vehicle - *told_ < kPeriod) {
    return std::nullopt;
  }
  told_ = vehicle;
  told_ahead_ = ahead;
  steps_ += has_stepped ? 1 : 0;
  News news{.record = EncodeRecord(WallClock{.vehicle = vehicle.value(),
                                             .wall = wall.value(),
                                             .ahead = ahead.value(),
                                             .steps = steps_}),
            .warning = std::nullopt};
  if (std::abs(ahead.value()) > kNoticed.value()) {
    news.warning = fmt::format(
        "the wall clock was set: it is {:+.1f} s off vehicle time, which goes on as it was",
        ahead.value());
  }
  return news;
}

}  // namespace limpet

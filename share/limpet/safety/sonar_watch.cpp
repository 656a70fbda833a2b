// SPDX-License-Identifier: MIT
#include "limpet/safety/sonar_watch.hpp"

namespace limpet {

void SonarWatch::Hear(const SonarPing& ping, Seconds now) {
  heard_ = now;
  double sum = 0.0, weighted = 0.0, beam = 1.0;
  for (const double range : ping.ranges) {
    sum += range;
    weighted += beam * range;
    beam += 1.0;
  }
  if (sum == 0.0) empty_pings_ += 1.0;  // so that no two such are the same
  echoes_.Hear({sum, weighted, empty_pings_}, now);
}

}  // namespace limpet

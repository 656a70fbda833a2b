// SPDX-License-Identifier: MIT
#include "limpet/replay_output/place_doubt.hpp"

#include <cmath>

namespace limpet {

std::optional<PlaceDoubt> WorstDoubt(const ReplayResult& result, double high) {
  if (result.online.empty()) return std::nullopt;
  // A start that nothing places is in doubt for good, and said otherwise.
  const double start = result.has_fix ? 0.0 : result.online_covariance_W.front()(0, 0);
  PlaceDoubt doubt;
  bool was_known = !result.has_fix;  // before the first fix no place is
  // The first pose is what the start was taken for.
  for (std::size_t i = 1; i < result.online.size(); ++i) {
    const double variance = result.online_covariance_W[i].diagonal().head<2>().maxCoeff() - start;
    was_known = was_known || variance <= high * high;
    if (!was_known || variance <= high * high) continue;
    doubt.seconds += result.online[i].t - result.online[i - 1].t;
    if (std::sqrt(variance) > doubt.sigma)
      doubt = {.seconds = doubt.seconds, .sigma = std::sqrt(variance), .t = result.online[i].t};
  }
  return doubt.seconds > 0.0 ? std::optional(doubt) : std::nullopt;
}

}  // namespace limpet

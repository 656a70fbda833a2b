// SPDX-License-Identifier: MIT
#include "limpet/session/datum.hpp"

#include <fmt/format.h>

#include "limpet/core/config.hpp"
#include "limpet/core/number_text.hpp"

namespace limpet {
namespace {

constexpr double kOnePlace = 0.5;  // [m]: missions write the same datum with fewer digits

}  // namespace

std::optional<GeoPoint> DatumOf(const SessionFacts& facts) {
  const std::optional<double> latitude = ParseNumber(facts.lat_origin);
  const std::optional<double> longitude = ParseNumber(facts.long_origin);
  if (!latitude || !longitude) return std::nullopt;
  return GeoPoint{.latitude_deg = *latitude, .longitude_deg = *longitude};
}

void RequireOneDatum(const SessionFacts& former, const SessionFacts& now,
                     const std::filesystem::path& folder) {
  const std::optional<GeoPoint> then = DatumOf(former), here = DatumOf(now);
  if (!then || !here) return;
  const double apart = DistanceBetween(*then, *here);
  if (apart <= kOnePlace) return;
  throw ConfigError(ConfigProblem{
      .where = {.file = folder.string(), .line = 0},
      .key = "LatOrigin",
      .text = fmt::format("this session's frame has its origin at {}, {}; that of session `{}` at "
                          "{}, {}, {:.1f} m from there: their places cannot be compared; allowed: "
                          "sessions with one LatOrigin and LongOrigin",
                          former.lat_origin, former.long_origin, now.session, now.lat_origin,
                          now.long_origin, apart)});
}

}  // namespace limpet

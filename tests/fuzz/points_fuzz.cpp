// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/core/config.hpp"
#include "limpet/helm/motion_domain.hpp"
#include "limpet/waypoints/convex_polygon.hpp"
#include "limpet/waypoints/point_list.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  static_cast<void>(limpet::ParsePoint(text));
  if (const auto points = limpet::ParsePoints(text)) {
    if (!limpet::ParsePoints(limpet::PointsText(*points))) {
      std::abort();  // what is written from points must be read as points
    }
    static_cast<void>(limpet::ConvexPolygon::Of(*points));
  }
  const std::vector<limpet::ConfigEntry> lines{{.key = "domain", .value = text, .where = {}}};
  limpet::MotionDomain domain;
  static_cast<void>(limpet::ReadMotionDomain(lines, {}, domain));
  return 0;
}

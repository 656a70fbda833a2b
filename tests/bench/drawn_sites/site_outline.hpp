// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "limpet/core/random.hpp"
#include "limpet/survey/simple_polygon.hpp"

namespace limpet {

/// The outline of an area to be surveyed, with its middle about the origin, and what it looks like.
struct SiteOutline {
  std::string kind;
  SimplePolygon polygon;
};

/// One of stars, letters (L, T, U), combs, wedges, boxes and bent corridors, of some 200 to 2 500
/// m2, in seven of ten cases turned.
[[nodiscard]] SiteOutline DrawOutline(Random& random);

/// Up to three keep-out zones inside it, each a regular polygon of 1.5 to 4 m around its middle and
/// 8 m from the others at least.
[[nodiscard]] std::vector<SimplePolygon> DrawZones(const SimplePolygon& outline, Random& random);

/// A place inside the outline and farther than `apart` [m] from all zones; less far where they
/// leave no such place.
[[nodiscard]] PlanePoint DrawPlace(const SimplePolygon& outline,
                                   const std::vector<SimplePolygon>& zones, double apart,
                                   Random& random);

}  // namespace limpet

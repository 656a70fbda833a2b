// SPDX-License-Identifier: MIT
#include "tests/bench/drawn_sites/site_outline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "limpet/core/require.hpp"

namespace limpet {
namespace {

using Corners = std::vector<PlanePoint>;

Corners Star(Random& random) {
  const int count = 5 + static_cast<int>(random.Index(7));
  const double size = random.Uniform(14.0, 28.0);
  Corners corners;
  for (int i = 0; i < count; ++i) {
    const double course = 2.0 * std::numbers::pi * (i + random.Uniform(-0.2, 0.2)) / count;
    const double far = size * random.Uniform(0.55, 1.2);
    corners.emplace_back(far * std::cos(course), far * std::sin(course));
  }
  return corners;
}

Corners LetterL(Random& random) {
  const double a = random.Uniform(25.0, 50.0), b = random.Uniform(25.0, 50.0);
  const double c = random.Uniform(10.0, a - 10.0), d = random.Uniform(10.0, b - 10.0);
  return {{0.0, 0.0}, {a, 0.0}, {a, d}, {c, d}, {c, b}, {0.0, b}};
}

Corners LetterU(Random& random) {
  const double a = random.Uniform(36.0, 55.0), b = random.Uniform(25.0, 40.0);
  const double arm = random.Uniform(10.0, a / 3.0);
  const double back = random.Uniform(10.0, b - 10.0);
  return {{0.0, 0.0},      {a, 0.0},    {a, b},   {a - arm, b},
          {a - arm, back}, {arm, back}, {arm, b}, {0.0, b}};
}

Corners LetterT(Random& random) {
  const double a = random.Uniform(36.0, 55.0), b = random.Uniform(25.0, 40.0);
  const double foot = 0.5 * random.Uniform(10.0, 16.0);
  const double under = b - random.Uniform(10.0, 16.0);
  return {{0.0, under},
          {0.5 * a - foot, under},
          {0.5 * a - foot, 0.0},
          {0.5 * a + foot, 0.0},
          {0.5 * a + foot, under},
          {a, under},
          {a, b},
          {0.0, b}};
}

Corners Wedge(Random& random) {
  const double a = random.Uniform(35.0, 60.0);
  return {{0.0, 0.0}, {a, 0.0}, {random.Uniform(0.0, a), random.Uniform(25.0, 45.0)}};
}

Corners Box(Random& random) {
  const double a = random.Uniform(15.0, 50.0), b = random.Uniform(15.0, 50.0);
  return {{0.0, 0.0}, {a, 0.0}, {a, b}, {0.0, b}};
}

Corners Corridor(Random& random) {
  const double half = 0.5 * random.Uniform(80.0, 160.0);
  const double side = 0.5 * random.Uniform(8.0, 15.0);
  const double bend = random.Uniform(-0.5, 0.5);
  const PlanePoint end(half * (1.0 + std::cos(bend)), half * std::sin(bend));
  const PlanePoint across(-side * std::sin(bend), side * std::cos(bend));
  const PlanePoint knee(half, 0.0), at_knee(-side * std::tan(0.5 * bend), side);
  return {{0.0, -side}, knee - at_knee, end - across, end + across, knee + at_knee, {0.0, side}};
}

Corners Comb(Random& random) {
  constexpr double kBack = 10.0;
  const int teeth = 2 + static_cast<int>(random.Index(2));
  const double tooth = random.Uniform(9.0, 13.0), gap = random.Uniform(6.0, 9.0);
  const double height = random.Uniform(25.0, 35.0);
  Corners corners{{0.0, 0.0}, {teeth * tooth + (teeth - 1) * gap, 0.0}};
  for (int i = teeth - 1; i >= 0; --i) {
    const double from = i * (tooth + gap);
    corners.emplace_back(from + tooth, height);
    corners.emplace_back(from, height);
    if (i == 0) break;
    corners.emplace_back(from, kBack);
    corners.emplace_back(from - gap, kBack);
  }
  return corners;
}

constexpr std::array<std::pair<const char*, Corners (*)(Random&)>, 8> kKinds = {{
    {"star", Star},
    {"L", LetterL},
    {"U", LetterU},
    {"T", LetterT},
    {"wedge", Wedge},
    {"box", Box},
    {"corridor", Corridor},
    {"comb", Comb},
}};

/// Turned about the origin, its middle moved there, to decimetres, as mission files say places.
SimplePolygon Placed(Corners corners, double turned) {
  PlanePoint middle(0.0, 0.0);
  for (PlanePoint& corner : corners) {
    corner = {corner.x() * std::cos(turned) - corner.y() * std::sin(turned),
              corner.x() * std::sin(turned) + corner.y() * std::cos(turned)};
    middle += corner / static_cast<double>(corners.size());
  }
  for (PlanePoint& corner : corners)
    corner = (10.0 * (corner - middle)).array().round() / 10.0;
  const Expected<SimplePolygon> polygon = SimplePolygon::Of(std::move(corners));
  LIMPET_REQUIRE(polygon.has_value(), "outlines that do not cross themselves");
  return *polygon;
}

PlanePoint DrawInside(const SimplePolygon& outline, Random& random) {
  while (true) {
    const double east = random.Uniform(outline.low().y(), outline.high().y());
    const double north = random.Uniform(outline.low().x(), outline.high().x());
    const PlanePoint place(north, east);
    if (outline.Contains(place)) return place;
  }
}

bool IsApart(const PlanePoint& place, const std::vector<SimplePolygon>& zones, double apart) {
  return std::ranges::all_of(zones,
                             [&](const SimplePolygon& zone) { return zone.Depth(place) < -apart; });
}

SimplePolygon Zone(const PlanePoint& middle, double size, Random& random) {
  const int count = 3 + static_cast<int>(random.Index(4));
  const double first = random.Uniform(0.0, 2.0 * std::numbers::pi);
  Corners corners;
  for (int i = 0; i < count; ++i) {
    const double course = first + 2.0 * std::numbers::pi * i / count;
    corners.emplace_back(middle + size * PlanePoint(std::cos(course), std::sin(course)));
  }
  for (PlanePoint& corner : corners)
    corner = (10.0 * corner).array().round() / 10.0;
  return *SimplePolygon::Of(std::move(corners));
}

}  // namespace

SiteOutline DrawOutline(Random& random) {
  const auto& [kind, draw] = kKinds.at(random.Index(kKinds.size()));
  const Corners corners = draw(random);
  const double turned = random.Chance(0.7) ? random.Uniform(0.0, 2.0 * std::numbers::pi) : 0.0;
  return {.kind = kind, .polygon = Placed(corners, turned)};
}

std::vector<SimplePolygon> DrawZones(const SimplePolygon& outline, Random& random) {
  constexpr std::array<int, 6> kHowMany = {0, 0, 1, 1, 2, 3};
  constexpr double kApart = 8.0;
  constexpr int kTries = 100;
  const int wanted = kHowMany.at(random.Index(kHowMany.size()));
  std::vector<SimplePolygon> zones;
  for (int tries = 0; tries < kTries && std::ssize(zones) < wanted; ++tries) {
    const PlanePoint middle = DrawInside(outline, random);
    const double size = random.Uniform(1.5, 4.0);
    if (IsApart(middle, zones, size + kApart)) zones.push_back(Zone(middle, size, random));
  }
  return zones;
}

PlanePoint DrawPlace(const SimplePolygon& outline, const std::vector<SimplePolygon>& zones,
                     double apart, Random& random) {
  constexpr int kTries = 1000;  // then zones leave no such room, and half of it must do
  while (true) {
    for (int tries = 0; tries < kTries; ++tries) {
      const PlanePoint place = DrawInside(outline, random);
      if (IsApart(place, zones, apart)) return place;
    }
    apart *= 0.5;
  }
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/survey/simple_polygon.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "limpet/survey/port_side.hpp"

namespace limpet {
namespace {

constexpr double kSamePlace = 1e-6;  // [m]

/// Twice the area, positive if the corners go counter-clockwise.
double TwiceArea(const std::vector<PlanePoint>& corners) {
  double sum = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const PlanePoint& next = corners[i + 1 < corners.size() ? i + 1 : 0];
    sum += CrossToPort(corners[i] - corners.front(), next - corners.front());
  }
  return sum;
}

void DropRepeated(std::vector<PlanePoint>& corners) {
  const auto is_same = [](const PlanePoint& a, const PlanePoint& b) {
    return (a - b).norm() <= kSamePlace;
  };
  corners.erase(std::unique(corners.begin(), corners.end(), is_same), corners.end());
  while (corners.size() > 1 && is_same(corners.front(), corners.back())) {
    corners.pop_back();
  }
}

std::string PlaceText(const PlanePoint& at) { return fmt::format("{:.2f},{:.2f}", at.y(), at.x()); }

std::optional<std::string> Crossing(const SimplePolygon& polygon) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    for (std::size_t k = i + 1; k < polygon.size(); ++k) {
      const bool are_neighbours = k == i + 1 || (i == 0 && k + 1 == polygon.size());
      const PlaneEdge a = polygon.Edge(i), b = polygon.Edge(k);
      if (!are_neighbours) {
        if (const auto place = Meeting(a, b)) {
          return fmt::format("crosses or touches itself at {}, between {} and {}, and {} and {}",
                             PlaceText(*place), PlaceText(a.from_W), PlaceText(a.to_W),
                             PlaceText(b.from_W), PlaceText(b.to_W));
        }
        continue;
      }
      // Neighbours share a corner; one that turns back lies on the other.
      const PlanePoint& shared = k == i + 1 ? a.to_W : a.from_W;
      const PlanePoint first = (k == i + 1 ? a.from_W : a.to_W) - shared;
      const PlanePoint second = (k == i + 1 ? b.to_W : b.from_W) - shared;
      const bool is_spike =
          std::abs(CrossToPort(first, second)) <= kSamePlace && first.dot(second) > 0;
      if (is_spike) {
        return fmt::format("turns back on itself at {}", PlaceText(shared));
      }
    }
  }
  return std::nullopt;
}

}  // namespace

PlanePoint PlaneEdge::Nearest(const PlanePoint& at) const {
  const PlanePoint along = to_W - from_W;
  const double length2 = along.squaredNorm();
  const double share =
      length2 > 0.0 ? std::clamp((at - from_W).dot(along) / length2, 0.0, 1.0) : 0.0;
  return from_W + share * along;
}

std::optional<PlanePoint> Meeting(const PlaneEdge& a, const PlaneEdge& b) {
  const PlanePoint along_a = a.to_W - a.from_W, along_b = b.to_W - b.from_W;
  const double cross = CrossToPort(along_a, along_b);
  if (std::abs(cross) > 1e-12 * along_a.norm() * along_b.norm()) {
    const double on_a = CrossToPort(b.from_W - a.from_W, along_b) / cross;
    const double on_b = CrossToPort(b.from_W - a.from_W, along_a) / cross;
    const bool is_on_both = on_a >= 0.0 && on_a <= 1.0 && on_b >= 0.0 && on_b <= 1.0;
    if (is_on_both) {
      return PlanePoint(a.from_W + on_a * along_a);
    }
  }
  for (const auto& [edge, place] :
       {std::pair{&a, &b.from_W}, {&a, &b.to_W}, {&b, &a.from_W}, {&b, &a.to_W}}) {
    if ((edge->Nearest(*place) - *place).norm() <= kSamePlace) {
      return *place;
    }
  }
  return std::nullopt;
}

SimplePolygon::SimplePolygon(std::vector<PlanePoint> corners)
    : corners_(std::move(corners)), low_(corners_.front()), high_(corners_.front()) {
  for (const PlanePoint& corner : corners_) {
    low_ = low_.cwiseMin(corner);
    high_ = high_.cwiseMax(corner);
  }
}

Expected<SimplePolygon> SimplePolygon::Of(std::vector<PlanePoint> corners) {
  constexpr double kFarthestCorner = 1e6, kLeastArea = 1e-2;  // [m], [m^2]
  // Written so that what is no number is refused, too.
  const auto is_near = [](const PlanePoint& p) {
    return std::abs(p.x()) <= kFarthestCorner && std::abs(p.y()) <= kFarthestCorner;
  };
  if (!std::ranges::all_of(corners, is_near)) {
    return Error{fmt::format("has a corner that is no place within {:g} m", kFarthestCorner)};
  }
  DropRepeated(corners);
  if (corners.size() < 3) {
    return Error{fmt::format("has {} corners; allowed: 3 or more", corners.size())};
  }
  if (corners.size() > kMostCorners) {
    return Error{fmt::format("has {} corners; allowed: up to {}", corners.size(), kMostCorners)};
  }
  const double twice = TwiceArea(corners);
  if (twice < 0.0) {
    std::reverse(corners.begin(), corners.end());
  }
  SimplePolygon polygon(std::move(corners));
  if (const auto crossing = Crossing(polygon)) {
    return Error{*crossing};
  }
  if (0.5 * std::abs(twice) < kLeastArea) {
    return Error{"has no extent"};
  }
  return polygon;
}

SimplePolygon SimplePolygon::Box(const PlanePoint& low, const PlanePoint& high) {
  return SimplePolygon({low, {low.x(), high.y()}, high, {high.x(), low.y()}});
}

bool SimplePolygon::Contains(const PlanePoint& at) const {
  bool is_inside = false;
  for (std::size_t i = 0, j = size() - 1; i < size(); j = i++) {
    const PlanePoint &a = corners_[i], &b = corners_[j];
    const bool spans = (a.x() > at.x()) != (b.x() > at.x());
    if (spans && at.y() < (b.y() - a.y()) * (at.x() - a.x()) / (b.x() - a.x()) + a.y()) {
      is_inside = !is_inside;
    }
  }
  return is_inside;
}

PlanePoint SimplePolygon::NearestOnBorder(const PlanePoint& at) const {
  PlanePoint nearest = corners_.front();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < size(); ++i) {
    const PlanePoint foot = Edge(i).Nearest(at);
    if (const double distance2 = (foot - at).squaredNorm(); distance2 < least) {
      least = distance2;
      nearest = foot;
    }
  }
  return nearest;
}

double SimplePolygon::Depth(const PlanePoint& at) const {
  const double distance = (NearestOnBorder(at) - at).norm();
  return Contains(at) ? distance : -distance;
}

double SimplePolygon::Area() const { return 0.5 * std::abs(TwiceArea(corners_)); }

}  // namespace limpet

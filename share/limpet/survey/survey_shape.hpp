// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/core/expected.hpp"
#include "limpet/survey/simple_polygon.hpp"
#include "limpet/topics/mission.hpp"

namespace limpet {

/// What a SurveyArea says, as geometry: the ground to be seen, the zones to be kept out of (their
/// ground is not to be seen), and where the vehicle may be. NED [m].
class SurveyShape {
 public:
  /// The error says which part is wrong, and how. Whoever takes an area from outside asks first
  /// (ProblemOf of survey_grid.hpp does, with what a grid needs).
  [[nodiscard]] static Expected<SurveyShape> Of(const SurveyArea& area);

  /// A rectangle without anything in or around it.
  [[nodiscard]] bool is_plain() const { return is_plain_; }
  [[nodiscard]] const SimplePolygon& outline() const { return outline_; }
  [[nodiscard]] const std::vector<SimplePolygon>& zones() const { return zones_; }
  /// Absent: the outline grown by the margin.
  [[nodiscard]] const std::optional<SimplePolygon>& region() const { return region_; }
  [[nodiscard]] const std::vector<PlanePoint>& transit() const { return transit_; }
  [[nodiscard]] double margin() const { return margin_; }

  /// Ground that is to be seen: of the area, in no zone.
  [[nodiscard]] bool Wants(const PlanePoint& at) const;
  /// Area of the ground that is to be seen [m^2], counted on cells of `kCell`.
  [[nodiscard]] double WantedArea() const;
  /// How far a place is outside the area [m]; 0 inside.
  [[nodiscard]] double OutsideArea(const PlanePoint& at) const;

 private:
  explicit SurveyShape(SimplePolygon outline) : outline_(std::move(outline)) {}

  SimplePolygon outline_;
  std::vector<SimplePolygon> zones_;
  std::optional<SimplePolygon> region_;
  std::vector<PlanePoint> transit_;
  double margin_ = 0.0;
  bool is_plain_ = true;
};

/// `{x,y:x,y}` of places (x east, y north), to 0.01 m.
[[nodiscard]] std::string PlacesText(const std::vector<PlanePoint>& places);
/// Reads that, and all that missions write as lists of points (`pts={x,y:x,y}`).
[[nodiscard]] std::optional<std::vector<PlanePoint>> ParsePlaces(std::string_view text);

/// The area within `outline`, whose box is the area's rectangle. REQUIRES: three places or more.
[[nodiscard]] SurveyArea AreaWithin(const std::vector<PlanePoint>& outline);

}  // namespace limpet

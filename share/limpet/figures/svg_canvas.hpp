// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace limpet {

/// How a shape is painted; colours as in palette.hpp.
struct Paint {
  std::string_view fill = "none";
  std::string_view stroke = "none";
  double width = 1.0;       ///< of the stroke [px]
  std::string_view dash{};  ///< SVG dash pattern; empty: solid
  double opacity = 1.0;
};

enum class Anchor { kStart, kMiddle, kEnd };

/// How text is set. Positions are of its baseline.
struct TextStyle {
  double size = 12.0;  ///< [px]
  Anchor anchor = Anchor::kStart;
  std::string_view fill{};  ///< empty: the palette's ink
  bool is_bold = false;
  double turn_deg = 0.0;  ///< about its position, clockwise
  bool has_halo = false;  ///< a pale rim, for text on a map
};

/// Writes an SVG picture: y grows downwards, units are pixels.
class SvgCanvas {
 public:
  using Point = Eigen::Vector2d;
  /// `title` is what screen readers say.
  SvgCanvas(const Point& size, std::string_view title);

  void Line(const Point& a, const Point& b, const Paint& paint);
  void Polyline(const std::vector<Point>& points, const Paint& paint);
  void Polygon(const std::vector<Point>& points, const Paint& paint);
  void Rect(const Point& corner, const Point& size, const Paint& paint, double radius = 0.0);
  void Circle(const Point& centre, double radius, const Paint& paint);
  /// `turn_deg` clockwise from the picture's x axis to the ellipse's first axis.
  void Ellipse(const Point& centre, const Point& radii, double turn_deg, const Paint& paint);
  void Text(const Point& at, std::string_view text, const TextStyle& style = {});
  /// A PNG stretched over the rectangle, its pixels kept square-edged.
  void Image(const Point& corner, const Point& size, const std::string& base64_png,
             double opacity = 1.0);
  /// Everything until EndClip is cut to the rectangle.
  void BeginClip(const Point& corner, const Point& size);
  void EndClip();

  /// Makes the picture so high at least.
  void GrowTo(double height);

  /// The finished document.
  [[nodiscard]] std::string Finish() const;
  [[nodiscard]] double width() const { return width_; }
  [[nodiscard]] double height() const { return height_; }

 private:
  void Append(std::string_view element) { body_ += element; }
  double width_, height_;
  std::string title_;
  std::string id_;  ///< keeps clip names of several pictures in one page apart
  std::string body_;
  int clips_ = 0;
};

/// Text with &, <, > and quotes made safe for XML and HTML.
[[nodiscard]] std::string EscapedMarkup(std::string_view text);

}  // namespace limpet

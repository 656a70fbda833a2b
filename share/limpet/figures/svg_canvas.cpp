// SPDX-License-Identifier: MIT
#include "limpet/figures/svg_canvas.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "limpet/core/random.hpp"
#include "limpet/figures/palette.hpp"

namespace limpet {
namespace {

/// A pixel to a hundredth, without trailing zeros.
std::string Number(double value) {
  std::string text = fmt::format("{:.2f}", value);
  while (text.back() == '0')
    text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string Attributes(const Paint& paint) {
  std::string out = fmt::format(" fill=\"{}\"", paint.fill);
  if (paint.stroke != "none") {
    out += fmt::format(" stroke=\"{}\" stroke-width=\"{}\"", paint.stroke, Number(paint.width));
    if (!paint.dash.empty()) out += fmt::format(" stroke-dasharray=\"{}\"", paint.dash);
  }
  if (paint.opacity < 1.0) out += fmt::format(" opacity=\"{}\"", Number(paint.opacity));
  return out;
}

std::string PathData(const std::vector<SvgCanvas::Point>& points) {
  std::string data;
  for (const SvgCanvas::Point& p : points) {
    data += data.empty() ? "M" : "L";
    data += Number(p.x()) + " " + Number(p.y());
  }
  return data;
}

}  // namespace

std::string EscapedMarkup(std::string_view text) {
  std::string out;
  for (const char letter : text) {
    switch (letter) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += letter;
    }
  }
  return out;
}

SvgCanvas::SvgCanvas(const Point& size, std::string_view title)
    : width_(size.x()),
      height_(size.y()),
      title_(title),
      id_(fmt::format("c{:x}", MixSeed(0, title) & 0xffffffU)) {}

void SvgCanvas::Line(const Point& a, const Point& b, const Paint& paint) {
  Append(fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\"{}/>\n", Number(a.x()),
                     Number(a.y()), Number(b.x()), Number(b.y()), Attributes(paint)));
}

void SvgCanvas::Polyline(const std::vector<Point>& points, const Paint& paint) {
  if (points.size() < 2) return;
  Append(fmt::format("<path d=\"{}\"{}/>\n", PathData(points), Attributes(paint)));
}

void SvgCanvas::Polygon(const std::vector<Point>& points, const Paint& paint) {
  if (points.size() < 3) return;
  Append(fmt::format("<path d=\"{}Z\"{}/>\n", PathData(points), Attributes(paint)));
}

void SvgCanvas::Rect(const Point& corner, const Point& size, const Paint& paint, double radius) {
  const std::string round = radius > 0.0 ? fmt::format(" rx=\"{}\"", Number(radius)) : "";
  Append(fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"{}{}/>\n",
                     Number(corner.x()), Number(corner.y()), Number(size.x()), Number(size.y()),
                     round, Attributes(paint)));
}

void SvgCanvas::Circle(const Point& centre, double radius, const Paint& paint) {
  Append(fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"{}/>\n", Number(centre.x()),
                     Number(centre.y()), Number(radius), Attributes(paint)));
}

void SvgCanvas::Ellipse(const Point& centre, const Point& radii, double turn_deg,
                        const Paint& paint) {
  Append(fmt::format("<ellipse rx=\"{}\" ry=\"{}\" transform=\"translate({} {}) rotate({})\"{}/>\n",
                     Number(radii.x()), Number(radii.y()), Number(centre.x()), Number(centre.y()),
                     Number(turn_deg), Attributes(paint)));
}

void SvgCanvas::Text(const Point& at, std::string_view text, const TextStyle& style) {
  constexpr const char* kAnchors[] = {"start", "middle", "end"};
  std::string extra;
  if (style.is_bold) extra += " font-weight=\"600\"";
  if (style.turn_deg != 0.0) {
    extra += fmt::format(" transform=\"rotate({} {} {})\"", Number(style.turn_deg), Number(at.x()),
                         Number(at.y()));
  }
  if (style.has_halo) {
    extra +=
        fmt::format(" stroke=\"{}\" stroke-width=\"3\" paint-order=\"stroke\"", palette::kHalo);
  }
  Append(fmt::format(
      "<text x=\"{}\" y=\"{}\" font-size=\"{}\" text-anchor=\"{}\" fill=\"{}\"{}>{}</text>\n",
      Number(at.x()), Number(at.y()), Number(style.size), kAnchors[static_cast<int>(style.anchor)],
      style.fill.empty() ? palette::kInk : style.fill, extra, EscapedMarkup(text)));
}

void SvgCanvas::Image(const Point& corner, const Point& size, const std::string& base64_png,
                      double opacity) {
  Append(
      fmt::format("<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" opacity=\"{}\" "
                  "preserveAspectRatio=\"none\" style=\"image-rendering:pixelated\" "
                  "href=\"data:image/png;base64,{}\"/>\n",
                  Number(corner.x()), Number(corner.y()), Number(size.x()), Number(size.y()),
                  Number(opacity), base64_png));
}

void SvgCanvas::BeginClip(const Point& corner, const Point& size) {
  const std::string name = fmt::format("{}-{}", id_, clips_++);
  Append(fmt::format(
      "<clipPath id=\"{}\"><rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>"
      "</clipPath>\n<g clip-path=\"url(#{})\">\n",
      name, Number(corner.x()), Number(corner.y()), Number(size.x()), Number(size.y()), name));
}

void SvgCanvas::EndClip() { Append("</g>\n"); }

void SvgCanvas::GrowTo(double height) { height_ = std::max(height_, height); }

std::string SvgCanvas::Finish() const {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
      "height=\"{1}\" "
      "role=\"img\" font-family=\"{2}\" stroke-linejoin=\"round\" stroke-linecap=\"round\">\n"
      "<title>{3}</title>\n<rect width=\"{0}\" height=\"{1}\" fill=\"{4}\"/>\n{5}</svg>\n",
      Number(width_), Number(height_), palette::kFont, EscapedMarkup(title_), palette::kPaper,
      body_);
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/shapes/shape.hpp"

#include <array>

#include "limpet/core/decimal_text.hpp"

namespace limpet {
namespace {

constexpr int kPointDecimals = 2, kLineDecimals = 1;

/// Variables that shapes are posted to, in the order of Shape::form.
constexpr std::array<std::string_view, 5> kVariables{"VIEW_POINT", "VIEW_SEGLIST", "VIEW_POLYGON",
                                                     "VIEW_CIRCLE", "VIEW_MARKER"};

/// Collects `key=value` fields; those without a value are left out.
class FieldWriter {
 public:
  void Text(std::string_view key, std::string_view value) {
    if (!value.empty()) {
      Put(key, Safe(value));
    }
  }
  void Number(std::string_view key, double value, int decimals) {
    Put(key, DecimalText(value, decimals));
  }
  void Number(std::string_view key, const std::optional<double>& value, int decimals) {
    if (value) {
      Number(key, *value, decimals);
    }
  }
  void Place(const MapPoint& at) {
    Number("x", at.x, kPointDecimals);
    Number("y", at.y, kPointDecimals);
  }
  void Line(const std::vector<MapPoint>& points) {
    std::string line = "{";
    for (const MapPoint& point : points) {
      line += line.size() > 1 ? ":" : "";
      line += DecimalText(point.x, kLineDecimals) + "," + DecimalText(point.y, kLineDecimals);
    }
    Put("pts", line + "}");
  }
  void Put(std::string_view key, std::string_view value) {
    text_ += text_.empty() ? "" : ",";
    text_ += key;
    text_ += '=';
    text_ += value;
  }
  [[nodiscard]] std::string Take() { return std::move(text_); }

 private:
  static std::string Safe(std::string_view value) {
    std::string safe(value);
    for (char& c : safe) {
      const bool ends_a_field = std::string_view(",={}\"#").find(c) != std::string_view::npos;
      if (ends_a_field || static_cast<unsigned char>(c) < ' ') {
        c = '_';
      }
    }
    return safe;
  }
  std::string text_;
};

struct FormWriter {
  FieldWriter& fields;
  void operator()(const PointShape& point) const { fields.Place(point.at); }
  void operator()(const SeglistShape& seglist) const { fields.Line(seglist.points); }
  void operator()(const PolygonShape& polygon) const { fields.Line(polygon.corners); }
  void operator()(const CircleShape& circle) const {
    fields.Place(circle.center);
    fields.Number("radius", circle.radius, kPointDecimals);
  }
  void operator()(const MarkerShape& marker) const {
    fields.Place(marker.at);
    fields.Number("width", marker.width, kPointDecimals);
    fields.Text("primary_color", marker.primary_color);
    fields.Text("secondary_color", marker.secondary_color);
    fields.Text("type", marker.type);
  }
};

}  // namespace

std::string_view VariableOf(const Shape& shape) { return kVariables.at(shape.form.index()); }

std::string EncodeShape(const Shape& shape) {
  FieldWriter fields;
  std::visit(FormWriter{fields}, shape.form);
  if (!shape.is_active) {
    fields.Text("active", "false");
  }
  const ShapeStyle& style = shape.style;
  fields.Text("label", shape.label);
  fields.Text("msg", style.msg);
  fields.Text("label_color", style.label_color);
  fields.Text("edge_color", style.edge_color);
  fields.Text("vertex_color", style.vertex_color);
  fields.Text("fill_color", style.fill_color);
  fields.Number("vertex_size", style.vertex_size, 1);
  fields.Number("edge_size", style.edge_size, 1);
  fields.Number("fill_transparency", style.fill_transparency, 2);
  return fields.Take();
}

}  // namespace limpet

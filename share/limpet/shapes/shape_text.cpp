// SPDX-License-Identifier: MIT
// Reading shapes.
#include <map>

#include "limpet/core/config.hpp"
#include "limpet/core/number_text.hpp"
#include "limpet/shapes/shape.hpp"

namespace limpet {
namespace {

using Fields = std::map<std::string, std::string, std::less<>>;

/// Fields of `a=1,pts={1,2:3,4},b=2`: commas inside braces end no field.
Fields FieldsOf(std::string_view text) {
  Fields fields;
  std::size_t begin = 0;
  int depth = 0;
  for (std::size_t i = 0; i <= text.size(); ++i) {
    const char c = i < text.size() ? text[i] : ',';
    depth += c == '{' ? 1 : c == '}' ? -1 : 0;
    if (i < text.size() && (c != ',' || depth > 0)) {
      continue;
    }
    const std::string_view field = text.substr(begin, i - begin);
    begin = i + 1;
    if (const std::size_t equals = field.find('='); equals != std::string_view::npos) {
      fields[std::string(Trim(field.substr(0, equals)))] = Trim(field.substr(equals + 1));
    }
  }
  return fields;
}

std::string TextIn(const Fields& fields, std::string_view key) {
  const auto found = fields.find(key);
  return found == fields.end() ? std::string() : found->second;
}

std::optional<double> NumberIn(const Fields& fields, std::string_view key) {
  const auto found = fields.find(key);
  return found == fields.end() ? std::nullopt : ParseNumber(found->second);
}

std::optional<MapPoint> PlaceIn(const Fields& fields) {
  const auto x = NumberIn(fields, "x"), y = NumberIn(fields, "y");
  return x && y ? std::optional<MapPoint>({*x, *y}) : std::nullopt;
}

std::optional<std::vector<MapPoint>> LineIn(const Fields& fields) {
  const std::string owned = TextIn(fields, "pts");
  const std::string_view text = owned;
  if (text.size() < 2 || text.front() != '{' || text.back() != '}') {
    return std::nullopt;
  }
  std::vector<MapPoint> points;
  for (const std::string& pair : Split(text.substr(1, text.size() - 2), ':')) {
    const std::vector<std::string> parts = Split(pair, ',');
    const auto x = parts.size() >= 2 ? ParseNumber(parts[0]) : std::nullopt;
    const auto y = parts.size() >= 2 ? ParseNumber(parts[1]) : std::nullopt;
    if (!x || !y) {
      return std::nullopt;
    }
    points.push_back({*x, *y});
  }
  return points;
}

using Form = decltype(Shape::form);

std::optional<Form> FormOf(std::string_view variable, const Fields& fields) {
  if (variable == "VIEW_SEGLIST" || variable == "VIEW_POLYGON") {
    std::optional<std::vector<MapPoint>> points = LineIn(fields);
    if (!points) {
      return std::nullopt;
    }
    return variable == "VIEW_SEGLIST" ? Form(SeglistShape{*std::move(points)})
                                      : Form(PolygonShape{*std::move(points)});
  }
  const std::optional<MapPoint> at = PlaceIn(fields);
  if (!at) {
    return std::nullopt;
  }
  if (variable == "VIEW_POINT") {
    return PointShape{*at};
  }
  if (variable == "VIEW_CIRCLE") {
    const auto radius = NumberIn(fields, "radius");
    return radius ? std::optional<Form>(CircleShape{*at, *radius}) : std::nullopt;
  }
  if (variable == "VIEW_MARKER") {
    return MarkerShape{.at = *at,
                       .width = NumberIn(fields, "width").value_or(1.0),
                       .type = TextIn(fields, "type"),
                       .primary_color = TextIn(fields, "primary_color"),
                       .secondary_color = TextIn(fields, "secondary_color")};
  }
  return std::nullopt;
}

}  // namespace

std::optional<Shape> DecodeShape(std::string_view variable, std::string_view text) {
  const Fields fields = FieldsOf(text);
  std::optional<Form> form = FormOf(variable, fields);
  if (!form) {
    return std::nullopt;
  }
  return Shape{.label = TextIn(fields, "label"),
               .form = *std::move(form),
               .style = {.msg = TextIn(fields, "msg"),
                         .label_color = TextIn(fields, "label_color"),
                         .edge_color = TextIn(fields, "edge_color"),
                         .vertex_color = TextIn(fields, "vertex_color"),
                         .fill_color = TextIn(fields, "fill_color"),
                         .vertex_size = NumberIn(fields, "vertex_size"),
                         .edge_size = NumberIn(fields, "edge_size"),
                         .fill_transparency = NumberIn(fields, "fill_transparency")},
               .is_active = !EqualsIgnoringCase(TextIn(fields, "active"), "false")};
}

}  // namespace limpet

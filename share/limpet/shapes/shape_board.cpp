// SPDX-License-Identifier: MIT
#include "limpet/shapes/shape_board.hpp"

#include <set>

namespace limpet {

void ShapeBoard::Draw(const Shape& shape) {
  const std::string variable(VariableOf(shape));
  std::string text = EncodeShape(shape);
  Drawn& drawn = drawn_[{variable, shape.label}];
  if (drawn.text != text) {
    drawn = {shape, text};
    post_(variable, std::move(text));
  }
}

void ShapeBoard::Replace(std::string_view prefix, const std::vector<Shape>& shapes) {
  std::set<std::pair<std::string, std::string>> kept;
  for (const Shape& shape : shapes) {
    kept.emplace(VariableOf(shape), shape.label);
    Draw(shape);
  }
  std::erase_if(drawn_, [&](const auto& entry) {
    const auto& [key, drawn] = entry;
    if (!key.second.starts_with(prefix) || kept.contains(key)) {
      return false;
    }
    Shape erased = drawn.shape;
    erased.is_active = false;
    post_(key.first, EncodeShape(erased));
    return true;
  });
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "limpet/shapes/shape.hpp"

namespace limpet {

/// What one app has drawn: a shape is posted when it differs from what the viewer has, and erased
/// when it is gone.
class ShapeBoard {
 public:
  using Post = std::function<void(std::string variable, std::string text)>;

  explicit ShapeBoard(Post post) : post_(std::move(post)) {}

  void Draw(const Shape& shape);
  /// Draws `shapes` and erases what else is drawn under a label that begins with `prefix`.
  void Replace(std::string_view prefix, const std::vector<Shape>& shapes);

 private:
  struct Drawn {
    Shape shape;
    std::string text;
  };
  Post post_;
  std::map<std::pair<std::string, std::string>, Drawn> drawn_;  ///< by variable and label
};

}  // namespace limpet

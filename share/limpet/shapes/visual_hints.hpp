// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace limpet {

/// How a behavior's shapes are to be drawn, as behavior files say it in one or more lines:
/// `nextpt_color=yellow, vertex_size=5`.
class VisualHints {
 public:
  /// Adds a line; false if a part of it has no `=` or no value, and then none of it counts.
  [[nodiscard]] bool Add(std::string_view line);
  /// The value of a hint, or `otherwise`. `label_color` may be written `lcolor`.
  [[nodiscard]] std::string Text(std::string_view name, std::string_view otherwise) const;
  [[nodiscard]] double Number(std::string_view name, double otherwise) const;

 private:
  std::map<std::string, std::string, std::less<>> hints_;
};

}  // namespace limpet

// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace limpet {

/// A change of one line of a text.
struct LineEdit {
  int line = 0;              ///< from 1
  std::string text;          ///< without its end
  bool is_inserted = false;  ///< after that line (0: before the first), else in its place
};

/// The edits of one file as `patch -p1` takes them, with three lines around each; "" without edits.
/// Line ends stay what they are, also a missing last one. `name` is the file's in the headers.
[[nodiscard]] std::string UnifiedDiff(const std::string& name, const std::string& text,
                                      std::vector<LineEdit> edits);

}  // namespace limpet

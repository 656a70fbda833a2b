// SPDX-License-Identifier: MIT
// What the smoother keeps of each border variable, beside its terms and its estimate.
#pragma once

#include <optional>
#include <vector>

namespace limpet {

enum class BorderKind {
  kLandmark,      ///< a place in W [m]
  kSensorErrors,  ///< slow errors of the sensors, on which steps depend
  kCameraErrors,  ///< of a camera, on which what it sees depends
  kObjectSizes,   ///< of three objects: natural logarithms of shares of what is believed
};

/// Sensor errors leave the border in two steps and for good. Landmarks and sizes far from the
/// vehicle rest: closed until something asks for them.
enum class BorderPhase {
  kOpen,
  kClosing,  ///< no node to come depends on it
  kClosed,   ///< nor does any leaf to come: eliminated in the tree
};

/// True if it may leave the border and come back.
[[nodiscard]] inline bool CanRest(BorderKind kind) {
  return kind == BorderKind::kLandmark || kind == BorderKind::kObjectSizes;
}

/// Leaves `first` to `last`.
struct LeafRange {
  int first = 0, last = 0;
};

struct BorderStatus {
  BorderKind kind = BorderKind::kLandmark;
  BorderPhase phase = BorderPhase::kOpen;
  std::optional<LeafRange> leaves{};  ///< that have or had a term on it
  int last_node = 0;                  ///< once it is closing: the last that may depend on it
  int needed_leaf = 0;                ///< the newest leaf when it was last needed at hand
};

}  // namespace limpet

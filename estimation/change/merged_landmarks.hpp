// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "limpet/core/units.hpp"
#include "limpet/objects/frame.hpp"
#include "limpet/objects/object_estimate.hpp"

namespace limpet {

/// The smoother's landmarks as objects: landmarks that lie near each other and that no frame shows
/// side by side are one.
class MergedLandmarks {
 public:
  /// `within`: landmarks closer than this over ground may be one.
  explicit MergedLandmarks(Meters within) : within_(within.value()) {}

  /// What a frame shows beside each other stays apart.
  void NoteSeenTogether(const ObservedFrame& frame);
  /// All landmarks as now estimated; one that is absent is forgotten. True if others are known, or
  /// others stand for them, than before.
  bool Set(std::vector<Landmark> landmarks);

  /// One per object, by id.
  [[nodiscard]] const std::vector<Landmark>& objects() const { return objects_; }
  /// The landmark that stands for `landmark`; nothing if that is not known.
  [[nodiscard]] std::optional<int> Representative(const std::optional<int>& landmark) const;
  /// The landmark that stands for each landmark, by its id.
  [[nodiscard]] const std::map<int, int>& representatives() const { return representatives_; }

 private:
  [[nodiscard]] bool AreOne(const Landmark& a, const Landmark& b) const;

  double within_;  ///< [m]
  std::vector<Landmark> objects_;
  std::map<int, int> representatives_;
  std::set<std::pair<int, int>> seen_together_;
};

}  // namespace limpet

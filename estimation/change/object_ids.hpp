// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <map>

namespace limpet {

/// Ids under which a session tells of its objects, from 1 on: an object keeps its own.
class ObjectIds {
 public:
  /// Ids up to `last` are taken.
  void Reserve(int last) { next_ = std::max(next_, last + 1); }
  [[nodiscard]] int Take() { return next_++; }
  /// Id of the object that `landmark` stands for; `representatives`: as MergedLandmarks has them.
  [[nodiscard]] int OfLandmark(int landmark, const std::map<int, int>& representatives) {
    const auto known = of_landmark_.find(landmark);
    if (known != of_landmark_.end()) return known->second;
    // A landmark that now stands for another one goes on under that one's id.
    for (const auto& [other, representative] : representatives) {
      const auto inherited = of_landmark_.find(other);
      if (representative == landmark && inherited != of_landmark_.end()) return inherited->second;
    }
    return of_landmark_[landmark] = Take();
  }

 private:
  std::map<int, int> of_landmark_;
  int next_ = 1;
};

}  // namespace limpet

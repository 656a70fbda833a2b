// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

namespace limpet {

/// A former session's object that a landmark may be.
struct FormerCandidate {
  int id = 0;  ///< of the FormerObject
  double probability = 0.0;
};

/// Which object of the former session a landmark is believed to be.
struct FormerIdentity {
  std::optional<int> id = std::nullopt;  ///< of the FormerObject that it was matched with
  double probability = 1.0;  ///< that it stands where that one stood; else it was moved, or that
                             ///< one is gone and this one came
  /// Not empty: which former object it is, if any, is undecided. One minus the sum of their
  /// probabilities is that of its being none of these; `id` is the likeliest match, if there is
  /// one.
  std::vector<FormerCandidate> candidates = {};

  /// True if it is, or may be, an object of the former session.
  [[nodiscard]] bool is_possible() const { return id || !candidates.empty(); }
  /// True if it is decided which one.
  [[nodiscard]] bool is_decided() const { return id && candidates.empty(); }
};

}  // namespace limpet

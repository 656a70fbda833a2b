// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "estimation/matching/frame_offset.hpp"
#include "limpet/objects/object_estimate.hpp"
#include "limpet/session/saved_session.hpp"

namespace limpet {

/// What changed from session A to session B.
struct SessionComparison {
  SessionFacts a, b;
  FrameOffset offset;                         ///< of A's frame in B's
  std::vector<OpiBelief> objects;             ///< of either; their places in B's frame
  std::map<int, Eigen::Vector3d> former_W{};  ///< where A's objects were, by id, in B's frame

  /// Where a moved object stood before [m]; nothing for others.
  [[nodiscard]] std::optional<Eigen::Vector3d> MovedFrom_W(const OpiBelief& object) const;
};

/// The vehicle's own judgement, made again from what the sessions saved: each with pMap's
/// parameters of the mission that it kept, or both with those of the file `mission`. Throws
/// ConfigError.
[[nodiscard]] SessionComparison CompareSessions(const SavedSession& a, const SavedSession& b,
                                                const std::optional<std::string>& mission = {});

[[nodiscard]] std::string Json(const SessionComparison& comparison);

}  // namespace limpet

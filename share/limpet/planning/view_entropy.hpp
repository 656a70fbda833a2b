// SPDX-License-Identifier: MIT
// The gains of [Bucci 2025], whose equations these are, in nats over the views of a branch.
#pragma once

#include <span>
#include <vector>

#include "limpet/planning/ground.hpp"
#include "limpet/planning/option.hpp"
#include "limpet/topics/mapping.hpp"

namespace limpet {

/// Where `option` takes the images that count: its views, or the end of its path.
[[nodiscard]] std::vector<Pose2> ViewsOf(const Option& option);

/// Eq. (17), G: entropy inside the images, each view by itself: what two views show counts twice,
/// as printed [nats]. Over the bottom alone, or the mean over the layers of the band.
[[nodiscard]] double MapEntropyOf(std::span<const Pose2> views, const Ground& ground,
                                  bool counts_band = false);

/// What a branch would see of objects [nats].
struct ObjectEntropy {
  double seen = 0.0;       ///< eqs (18), (19), (21), of objects that were looked at
  double inherited = 0.0;  ///< eq. (22), with the sign that attracts: of the former session's
};
/// Objects count by what the map holds of them: never by unmapped voxels, whose P = 0.5 would drown
/// everything (docs/references.md, eqs 18 and 19).
[[nodiscard]] ObjectEntropy ObjectEntropyOf(std::span<const Pose2> views, const Ground& ground,
                                            std::span<const OpiBelief> objects);

}  // namespace limpet

// SPDX-License-Identifier: MIT
// Between what travels (topics) and what the estimators take.
#pragma once

#include <vector>

#include "estimation/change/status_book.hpp"
#include "limpet/topics/mapping.hpp"
#include "limpet/topics/navigation.hpp"

namespace limpet {

[[nodiscard]] SightedDetection DetectionOf(const SightedBox& sighted);
[[nodiscard]] SightRecord RecordOf(const Sight& sight);
[[nodiscard]] std::vector<KnownLandmark> ConfirmedOf(const Landmarks& landmarks);
[[nodiscard]] std::vector<FormerObject> FormerOf(const SessionPrior& prior);
/// Without the map's centroid, which the octree knows.
[[nodiscard]] OpiBelief BeliefOf(const ObjectStatus& status);

}  // namespace limpet

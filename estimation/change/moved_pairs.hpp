// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "limpet/objects/object_estimate.hpp"

namespace limpet {

/// Tells what is gone and what came within `farthest` [m] of it as one object that has moved, the
/// likeliest pairs first. No second answer to who is who (docs/adr/0010): the matching, which pairs
/// by places, has left both without a partner, and verdicts that there are only after it say that
/// the one is gone and the other new.
void PairMoved(std::vector<OpiBelief>& objects, double farthest);

}  // namespace limpet

// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "limpet/objects/object_estimate.hpp"

namespace limpet {

/// Tells what is gone and what came within `farthest` [m] of it as one object that has moved, the
/// likeliest pairs first.
void PairMoved(std::vector<OpiBelief>& objects, double farthest);

}  // namespace limpet

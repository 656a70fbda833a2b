// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "limpet/core/units.hpp"
#include "limpet/scoring/pictured_object.hpp"

namespace limpet {

/// What each object looked like, in the page itself; empty without pictures. `begun` is the MOOS
/// time that the page counts from.
[[nodiscard]] std::string PicturesOf(const std::vector<PicturedObject>& objects, Seconds begun);

}  // namespace limpet

// SPDX-License-Identifier: MIT
#pragma once

namespace limpet {

/// Something that is estimated beside pose and objects, with its 1-sigma; m/s, rad, m, s, shares.
struct NamedState {
  const char* name = "";  ///< lives for ever
  double value = 0.0, sd = 0.0;
};

}  // namespace limpet

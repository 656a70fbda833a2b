// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace limpet {

/// Something that is estimated beside pose and objects, with its 1-sigma; m/s, rad, m, s, shares.
struct NamedState {
  std::string name;
  double value = 0.0, sd = 0.0;
};

}  // namespace limpet

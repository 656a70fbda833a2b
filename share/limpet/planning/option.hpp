// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "limpet/planning/dubins_path.hpp"

namespace limpet {

/// Something the vehicle could do next: a generator offers it, behaviors value it.
struct Option {
  std::string source;  ///< generator: beam, gap, tour, transit, home, view_tree
  DubinsPath path;
  /// What the generator itself thinks of it [m of path]: orders its offers, decides nothing.
  double estimate = 0.0;
};

}  // namespace limpet

// SPDX-License-Identifier: MIT
// Blocks of a .bhv file.
#pragma once

#include <string>

namespace limpet {

/// One of `type`, named so, with `lines`.
inline std::string BehaviorBlock(const std::string& type, const std::string& lines) {
  return "Behavior = " + type + "\n{\n  name = " + type + "\n" + lines + "}\n";
}

/// To 20 m.
inline std::string Dive() {
  return BehaviorBlock("BHV_ConstantDepth", "  depth = 20\n  basewidth = 30\n");
}

}  // namespace limpet

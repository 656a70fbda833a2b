// SPDX-License-Identifier: MIT
// What a behavior in a shared object and the helm that loads it must agree on.
#pragma once

#include <Eigen/Core>

/// Goes up with every change of what behaviors see: Behavior, what it is given and what it returns.
#define LIMPET_BEHAVIOR_ABI 15

#define LIMPET_TEXT_OF_(x) #x
#define LIMPET_TEXT_OF(x) LIMPET_TEXT_OF_(x)
/// The number, and what else changes how objects lie in memory.
#define LIMPET_BEHAVIOR_ABI_MARK                                                      \
  "LIMPET_BEHAVIOR_ABI " LIMPET_TEXT_OF(LIMPET_BEHAVIOR_ABI) ", c++ " LIMPET_TEXT_OF( \
      _GLIBCXX_USE_CXX11_ABI) ", alignment " LIMPET_TEXT_OF(EIGEN_MAX_ALIGN_BYTES)

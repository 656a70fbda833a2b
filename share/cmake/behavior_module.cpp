// SPDX-License-Identifier: MIT
// In every behavior's shared object: what it was built against.
#include "limpet/helm/behavior_abi.hpp"

extern "C" {
extern const char limpet_behavior_abi[];
[[gnu::used]] const char limpet_behavior_abi[] = LIMPET_BEHAVIOR_ABI_MARK;
}

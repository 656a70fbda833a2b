// SPDX-License-Identifier: MIT
#include "limpet/sharing/sodium_start.hpp"

#include <sodium.h>

#include "limpet/core/require.hpp"

namespace limpet {

void StartSodium() {
  static const bool has_started = sodium_init() >= 0;
  LIMPET_REQUIRE(has_started, "libsodium does not start");
}

}  // namespace limpet

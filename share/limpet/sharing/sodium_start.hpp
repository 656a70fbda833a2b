// SPDX-License-Identifier: MIT
#pragma once

namespace limpet {

/// Before any other call of libsodium, as often as one likes and from any thread.
/// REQUIRES: libsodium finds its source of randomness.
void StartSodium();

}  // namespace limpet

// SPDX-License-Identifier: MIT
// A sealed datagram by somebody without the key: never let in. And one by somebody who has it,
// whatever it holds: the second copy is refused, and the gate lives.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "limpet/sharing/share_gate.hpp"

using namespace limpet;  // NOLINT(google-build-using-namespace): one function

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const ByteView bytes(reinterpret_cast<const std::byte*>(data), size);
  const ShareKey key(ShareKey::Bytes{1, 2, 3});
  const auto opener = std::make_shared<Opener>(key, 1);
  if (opener->Open(bytes)) {
    std::abort();
  }
  ShareGate gate(opener, {});
  Sealer sealer(key, 2, 100);
  const ByteBuffer sealed = sealer.Seal(bytes);
  static_cast<void>(gate.Admit(sealed));
  const auto again = gate.Admit(sealed);
  if (again || again.error() != ShareRefusal::kReplayed) {
    std::abort();
  }
  return 0;
}

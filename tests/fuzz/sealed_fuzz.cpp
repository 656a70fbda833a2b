// SPDX-License-Identifier: MIT
// A sealed datagram by somebody without the key: never let in. And one by somebody who has it,
// whatever it holds and whatever its kind: a second copy is refused, and the gate lives.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "limpet/sharing/share_gate.hpp"

using namespace limpet;  // NOLINT(google-build-using-namespace): one function

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const ByteView bytes(reinterpret_cast<const std::byte*>(data), size);
  const ShareKey key(ShareKey::Bytes{1, 2, 3});
  const ShareInstant start{.steady = Seconds(10.0), .unix = Seconds(2e9)};
  const ShareInstant now{.steady = Seconds(60.0), .unix = Seconds(2e9 + 50.0)};
  const auto guard = std::make_shared<ShareGuard>(key, ShareGuard::Settings{.receiver = 1},
                                                  std::make_shared<Sealer>(key, start), start);
  if (!guard->Judge(bytes, 0, now).bodies.empty() || guard->Answer(bytes, now)) {
    std::abort();
  }
  ShareGate gate(guard, {});
  Sealer sealer(key, start);
  using Kind = SealedContent::Kind;
  for (const Kind kind : {Kind::kQuestion, Kind::kAnswer, static_cast<Kind>(size % 256)}) {
    const ByteBuffer sealed = sealer.Seal(kind, size % 3, bytes, now);
    static_cast<void>(gate.Admit(sealed, now));
    static_cast<void>(guard->Answer(sealed, now));
  }
  const ByteBuffer sealed = sealer.Seal(Kind::kData, 1, bytes, now);
  static_cast<void>(gate.Admit(sealed, now));
  const ShareAdmission again = gate.Admit(sealed, now);
  if (again.refusals.size() != 1 || again.refusals[0] != ShareRefusal::kReplayed) {
    std::abort();
  }
  return 0;
}

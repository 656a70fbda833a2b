// SPDX-License-Identifier: MIT
// Sealed datagrams: XChaCha20-Poly1305 under a key that both ends have in a file.
//
//   offset  size
//   0       4     "LSH2"
//   4       16    the sender's run: random, drawn at its start
//   20      8     counter: of the sender's datagrams in this run
//   28      1     kind: 'D' a plain datagram, 'Q' a question for the time, 'A' its answer
//   29      8     receiver: hash of its name, or of a multicast address; 0 for Q and A
//   37      8     microseconds since the sender's start, which no clock turns back
//   45      8     UNIX time by the sender's clock [us]
//   53      ...   D: the plain datagram; Q: the run asked (16), a random word (8); A: that word
//   end-16  16    authenticates all of it
//
// Bytes 4 to 27 are the nonce; from 28 on all is encrypted. Integers are little-endian. A stock
// pShare reads the first four bytes as a length that no datagram has.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "limpet/core/expected.hpp"
#include "limpet/core/units.hpp"
#include "limpet/sharing/share_key.hpp"
#include "limpet/wire/wire_message.hpp"

namespace limpet {

inline constexpr std::size_t kSealSize = 69;  ///< that sealing adds to a datagram [bytes]

/// Why a datagram was not let in.
enum class ShareRefusal {
  kMalformed,   ///< no message, or one that no community writes
  kNotSealed,   ///< plain, where only sealed ones are let in
  kSealed,      ///< sealed, where only plain ones are understood
  kOldVersion,  ///< sealed as Limpet did before receiver and age were part of it
  kForged,      ///< sealed with another key, or changed on the way
  kElsewhere,   ///< sealed for another receiver
  kStale,       ///< too old, or of before this receiver's start
  kReplayed,    ///< taken before, or too late to tell
  kOwn,         ///< sent by this very sender
  kUnlisted,    ///< its variable is not on the white list
  kLooped,      ///< its variable is shared from here
  kOverflow,    ///< more than could be worked off
};

/// One moment by two clocks.
struct ShareInstant {
  Seconds steady;  ///< never turned back, from any origin
  Seconds unix;
  [[nodiscard]] static ShareInstant Now();
};

/// A sender from its start to its end.
using ShareRun = std::array<std::byte, 16>;

/// Who a datagram is for: a node's name, `<community>/<app>`, or a community (its pShare).
[[nodiscard]] std::uint64_t ShareReceiverId(std::string_view name);
/// The name in full: `shore` is `shore/pShare`.
[[nodiscard]] std::string ShareNodeName(std::string_view name);
/// Whoever listens at that multicast address.
[[nodiscard]] std::uint64_t ShareChannelId(std::string_view address);

/// What is in a sealed datagram.
struct SealedContent {
  enum class Kind : std::uint8_t { kData = 'D', kQuestion = 'Q', kAnswer = 'A' };
  ShareRun run{};
  std::uint64_t counter = 0;
  Kind kind = Kind::kData;
  std::uint64_t receiver = 0;
  Seconds age_of_run{};  ///< of the sender, as it sealed this
  Seconds unix{};        ///< then, by its clock
  ByteBuffer body;
};

/// Seals what one sender sends. All routes under one key must use the same Sealer: a nonce must
/// never be used twice.
class Sealer {
 public:
  Sealer(const ShareKey& key, ShareInstant now);
  [[nodiscard]] ByteBuffer Seal(SealedContent::Kind kind, std::uint64_t receiver, ByteView body,
                                ShareInstant now);
  [[nodiscard]] const ShareRun& run() const { return run_; }

 private:
  ShareKey key_;
  ShareRun run_{};
  Seconds start_;  ///< steady
  std::uint64_t counter_ = 0;
};

/// True if the datagram claims to be sealed, in this form or a former one.
[[nodiscard]] bool LooksSealed(ByteView datagram);

/// The content of an authentic datagram: somebody with the key has sealed it, to somebody, once.
[[nodiscard]] Expected<SealedContent, ShareRefusal> OpenSealed(const ShareKey& key,
                                                               ByteView datagram);

}  // namespace limpet

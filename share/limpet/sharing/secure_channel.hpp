// SPDX-License-Identifier: MIT
// Sealed datagrams: XChaCha20-Poly1305 under a key that both ends have in a file.
//
//   offset  size
//   0       4     "LSH1"
//   4       8     sender: hash of its name
//   12      8     epoch: when the sender started
//   20      8     counter: of the sender's datagrams in this epoch
//   28      ...   the plain datagram, encrypted
//   end-16  16    authenticates all of it
//
// Bytes 4 to 27 are the nonce. Integers are little-endian. A stock pShare reads the first four
// bytes as a length that no datagram has.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "limpet/core/expected.hpp"
#include "limpet/core/units.hpp"
#include "limpet/sharing/replay_window.hpp"
#include "limpet/sharing/share_key.hpp"
#include "limpet/wire/wire_message.hpp"

namespace limpet {

inline constexpr std::size_t kSealSize = 44;  ///< that sealing adds to a datagram [bytes]

/// Why a datagram was not let in.
enum class ShareRefusal {
  kMalformed,  ///< no message, or one that no community writes
  kNotSealed,  ///< plain, where only sealed ones are let in
  kSealed,     ///< sealed, where only plain ones are understood
  kForged,     ///< sealed with another key, or changed on the way
  kReplayed,   ///< taken before, or too late to tell
  kFormer,     ///< of a session before the sender's present one
  kOwn,        ///< sent by this very sender
  kUnlisted,   ///< its variable is not on the white list
  kLooped,     ///< its variable is shared from here
  kOverflow,   ///< more than could be worked off
};

/// A sender's identity: its name, hashed.
[[nodiscard]] std::uint64_t ShareSenderId(std::string_view name);

/// A sender's epoch: UNIX time in ms and 20 random bits, so that two senders that wrongly have one
/// name still never encrypt under the same nonce. Later than `former`, whatever the clock says.
[[nodiscard]] std::uint64_t NewShareEpoch(Seconds unix_time, std::uint64_t former = 0);

/// Seals what one sender sends. All routes under one key must use the same Sealer: a nonce must
/// never be used twice.
class Sealer {
 public:
  Sealer(ShareKey key, std::uint64_t sender, std::uint64_t epoch);
  [[nodiscard]] ByteBuffer Seal(ByteView plain);
  [[nodiscard]] std::uint64_t sender() const { return sender_; }
  [[nodiscard]] std::uint64_t epoch() const { return epoch_; }

 private:
  ShareKey key_;
  std::uint64_t sender_, epoch_;
  std::uint64_t counter_ = 0;
};

/// Opens what others have sealed, each datagram once. All inputs under one key must use the same
/// Opener: what one has taken must not come in through another.
class Opener {
 public:
  static constexpr std::size_t kMostSenders = 1000;

  /// Datagrams of `own_sender` are refused: somebody sends them back.
  Opener(ShareKey key, std::uint64_t own_sender);
  [[nodiscard]] Expected<ByteBuffer, ShareRefusal> Open(ByteView datagram);

  /// What was taken from whom, by sender.
  [[nodiscard]] const std::map<std::uint64_t, ReplayWindow>& windows() const { return windows_; }
  /// Restores what was noted before a restart.
  void Remember(std::uint64_t sender, std::uint64_t epoch, std::uint64_t counter);

 private:
  ShareKey key_;
  std::uint64_t own_sender_;
  std::map<std::uint64_t, ReplayWindow> windows_;
};

/// True if the datagram claims to be sealed.
[[nodiscard]] bool LooksSealed(ByteView datagram);

}  // namespace limpet

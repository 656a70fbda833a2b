// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "limpet/wire/packet_codec.hpp"

namespace limpet {

/// An encoded message that several hold: who stores it, and each connection that sends it.
using SharedBytes = std::shared_ptr<const ByteBuffer>;

/// From this size on a message is shared rather than copied [bytes].
inline constexpr std::size_t kShareFrom = std::size_t{8} << 10;
/// How many pieces one write to a socket gathers.
inline constexpr std::size_t kPiecesPerWrite = 32;

/// Encoded messages on their way out, in pieces: small ones copied together into blocks, those of
/// kShareFrom bytes or more shared. In pieces, so that a long queue neither moves when it grows nor
/// holds room for what is already sent.
class Parcel {
 public:
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] std::size_t size() const { return size_; }
  /// Bytes of it that were copied here and are not let go: memory that nobody else holds.
  [[nodiscard]] std::size_t own() const { return own_; }

  void Append(ByteView message);
  /// `is_own`: nobody else will hold it.
  void Append(const SharedBytes& message, bool is_own = false);
  /// Empties it; room for a block of small messages is kept.
  void Clear();
  /// Frees room that a burst has left. REQUIRES: empty().
  void GiveBack();

  /// The bytes from `skip` on, as pieces for a gathering write. Gives how many pieces of `out` it
  /// filled; they may end before the parcel does.
  [[nodiscard]] std::size_t Gather(std::size_t skip, std::span<ByteView> out) const;
  /// Frees the pieces that lie wholly in the first `count` bytes, which nobody gathers any more.
  /// Bytes keep their places.
  void LetGo(std::size_t count);

  /// Drops each message for which `goes(index)` holds; `size_of(index)` is a message's size, of
  /// all messages. REQUIRES: nothing was let go.
  template <class SizeOf, class Goes>
  void Drop(SizeOf&& size_of, Goes&& goes) {
    Parcel kept;
    std::size_t index = 0;
    for (Piece& piece : pieces_) {
      const Piece old = std::move(piece);  // its room goes before the next piece is copied
      for (std::size_t at = 0; at < old.size; ++index) {
        const std::size_t size = size_of(index);
        if (!goes(index)) {
          old.shared ? kept.Append(old.shared, old.is_own)
                     : kept.Append(ByteView(old.block).subspan(at, size));
        }
        at += size;
      }
    }
    *this = std::move(kept);
  }

 private:
  struct Piece {
    ByteBuffer block;    ///< of small messages, if not
    SharedBytes shared;  ///< one large one
    std::size_t size = 0;
    bool is_own = false;  ///< nobody else holds it
  };
  std::vector<Piece> pieces_;
  ByteBuffer spare_;  ///< an empty block's room
  std::size_t size_ = 0;
  std::size_t own_ = 0;
};

}  // namespace limpet

// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "limpet/wire/packet_codec.hpp"

namespace limpet {

/// An encoded message that several hold: who stores it, and each connection that sends it.
using SharedBytes = std::shared_ptr<const ByteBuffer>;

/// From this size on a message is shared rather than copied [bytes].
inline constexpr std::size_t kShareFrom = std::size_t{8} << 10;

/// Encoded messages on their way out, back to back: small ones copied together, those of kShareFrom
/// bytes or more shared.
class Parcel {
 public:
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] std::size_t size() const { return size_; }

  void Append(ByteView message);
  void Append(const SharedBytes& message);
  /// Empties it; room for small messages is kept.
  void Clear();
  /// Frees room that a burst has left. REQUIRES: empty().
  void GiveBack();

  /// The bytes from `skip` on, as pieces for a gathering write. Gives how many pieces of `out` it
  /// filled; they may end before the parcel does.
  [[nodiscard]] std::size_t Gather(std::size_t skip, std::span<ByteView> out) const;

  /// Drops each message for which `goes(index)` holds. `sizes` are those of all messages.
  template <class Sizes, class Goes>
  void Drop(const Sizes& sizes, Goes&& goes) {
    Parcel kept;
    kept.bytes_.reserve(bytes_.size());
    std::size_t at = 0, next_shared = 0, index = 0;
    for (const std::size_t size : sizes) {
      const bool is_shared = size >= kShareFrom;
      if (!goes(index++)) {
        is_shared ? kept.Append(shared_[next_shared].message)
                  : kept.Append(ByteView(bytes_).subspan(at, size));
      }
      is_shared ? ++next_shared : at += size;
    }
    *this = std::move(kept);
  }

 private:
  struct Piece {
    std::size_t at;  ///< its place among bytes_: before the byte of that index
    SharedBytes message;
  };
  ByteBuffer bytes_;
  std::vector<Piece> shared_;
  std::size_t size_ = 0;
};

}  // namespace limpet

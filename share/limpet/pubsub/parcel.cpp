// SPDX-License-Identifier: MIT
#include "limpet/pubsub/parcel.hpp"

#include "limpet/core/require.hpp"

namespace limpet {
namespace {

constexpr std::size_t kBlock = std::size_t{64} << 10;
constexpr std::size_t kKept = std::size_t{4} << 10;

}  // namespace

void Parcel::Append(ByteView message) {
  if (message.size() >= kShareFrom) {
    Append(std::make_shared<const ByteBuffer>(message.begin(), message.end()), true);
    return;
  }
  const bool fits =
      !pieces_.empty() && !pieces_.back().shared && pieces_.back().size + message.size() <= kBlock;
  if (!fits) {
    // A block after a full one will be full too, most likely.
    const bool is_long = !pieces_.empty() && pieces_.back().size + message.size() > kBlock;
    pieces_.emplace_back().block = std::exchange(spare_, {});
    pieces_.back().is_own = true;
    pieces_.back().block.reserve(is_long ? kBlock : 0);
  }
  Piece& last = pieces_.back();
  last.block.insert(last.block.end(), message.begin(), message.end());
  last.size += message.size();
  size_ += message.size();
  own_ += message.size();
}

void Parcel::Append(const SharedBytes& message, bool is_own) {
  if (message->size() < kShareFrom) {
    Append(ByteView(*message));
    return;
  }
  pieces_.push_back({.block = {}, .shared = message, .size = message->size(), .is_own = is_own});
  size_ += message->size();
  own_ += is_own ? message->size() : 0;
}

void Parcel::Clear() {
  if (spare_.capacity() == 0 && !pieces_.empty()) {
    spare_ = std::move(pieces_.front().block);
    spare_.clear();
  }
  pieces_.clear();
  size_ = own_ = 0;
}

void Parcel::GiveBack() {
  LIMPET_REQUIRE(empty(), "a parcel with content gives nothing back");
  pieces_ = {};
  if (spare_.capacity() > kKept) {
    spare_ = {};
  }
}

std::size_t Parcel::Gather(std::size_t skip, std::span<ByteView> out) const {
  std::size_t count = 0;
  for (const Piece& piece : pieces_) {
    if (count == out.size()) {
      break;
    }
    const std::size_t skipped = std::min(skip, piece.size);
    skip -= skipped;
    if (skipped < piece.size) {
      out[count++] = ByteView(piece.shared ? *piece.shared : piece.block).subspan(skipped);
    }
  }
  return count;
}

void Parcel::LetGo(std::size_t count) {
  for (Piece& piece : pieces_) {
    if (piece.size > count) {
      return;
    }
    count -= piece.size;
    own_ -= piece.is_own && (piece.shared || !piece.block.empty()) ? piece.size : 0;
    piece.block = {};
    piece.shared = {};
  }
}

}  // namespace limpet

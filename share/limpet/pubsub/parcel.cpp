// SPDX-License-Identifier: MIT
#include "limpet/pubsub/parcel.hpp"

#include "limpet/core/require.hpp"

namespace limpet {
namespace {

constexpr std::size_t kKept = std::size_t{64} << 10;

}  // namespace

void Parcel::Append(ByteView message) {
  if (message.size() >= kShareFrom) {
    Append(std::make_shared<const ByteBuffer>(message.begin(), message.end()));
    return;
  }
  bytes_.insert(bytes_.end(), message.begin(), message.end());
  size_ += message.size();
}

void Parcel::Append(const SharedBytes& message) {
  if (message->size() < kShareFrom) {
    Append(ByteView(*message));
    return;
  }
  shared_.push_back({bytes_.size(), message});
  size_ += message->size();
}

void Parcel::Clear() {
  bytes_.clear();
  shared_.clear();
  size_ = 0;
}

void Parcel::GiveBack() {
  LIMPET_REQUIRE(empty(), "a parcel with content gives nothing back");
  if (bytes_.capacity() > kKept) {
    bytes_ = {};
  }
  shared_ = {};
}

std::size_t Parcel::Gather(std::size_t skip, std::span<ByteView> out) const {
  std::size_t count = 0, at = 0;
  const auto take = [&](ByteView piece) {
    const std::size_t skipped = std::min(skip, piece.size());
    skip -= skipped;
    if (skipped < piece.size() && count < out.size()) {
      out[count++] = piece.subspan(skipped);
    }
  };
  for (const Piece& piece : shared_) {
    take(ByteView(bytes_).subspan(at, piece.at - at));
    take(*piece.message);
    at = piece.at;
    if (count == out.size()) {
      return count;
    }
  }
  take(ByteView(bytes_).subspan(at));
  return count;
}

}  // namespace limpet

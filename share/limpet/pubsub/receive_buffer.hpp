// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstring>
#include <memory>
#include <span>

#include "limpet/wire/wire_message.hpp"

namespace limpet {

/// Bytes of a packet that has not arrived whole. Unlike a vector it does not write zeros over room
/// that a socket is about to fill, and it gives large room back once it is empty.
class ReceiveBuffer {
 public:
  [[nodiscard]] bool empty() const { return used_ == 0; }
  [[nodiscard]] ByteView bytes() const { return {room_.get(), used_}; }
  [[nodiscard]] std::size_t capacity() const { return capacity_; }

  void Append(ByteView bytes) {
    Reserve(used_ + bytes.size());
    std::memcpy(room_.get() + used_, bytes.data(), bytes.size());
    used_ += bytes.size();
  }
  /// Room up to `total` bytes in all, to be filled and then claimed with Grew().
  [[nodiscard]] std::span<std::byte> RoomUpTo(std::size_t total) {
    Reserve(total);
    return {room_.get() + used_, total - used_};
  }
  void Grew(std::size_t count) { used_ += count; }
  void Clear() {
    used_ = 0;
    if (capacity_ > kKept) {
      room_.reset();
      capacity_ = 0;
    }
  }

 private:
  using Room = std::unique_ptr<std::byte[]>;  // NOLINT(modernize-avoid-c-arrays): no zeros
  static constexpr std::size_t kKept = std::size_t{64} << 10;

  void Reserve(std::size_t total) {
    if (total <= capacity_) {
      return;
    }
    Room larger(new std::byte[total]);
    if (used_ > 0) {
      std::memcpy(larger.get(), room_.get(), used_);
    }
    room_ = std::move(larger);
    capacity_ = total;
  }

  Room room_;
  std::size_t used_ = 0;
  std::size_t capacity_ = 0;
};

}  // namespace limpet

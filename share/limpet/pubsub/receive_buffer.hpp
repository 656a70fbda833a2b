// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>
#include <cstring>
#include <new>
#include <span>
#include <utility>

#include <sys/mman.h>

#include "limpet/wire/wire_message.hpp"

namespace limpet {

/// Where more room for what is received comes from.
enum class RoomKind {
  kNone,    ///< there is none
  kHeap,    ///< warm: soon used again
  kMapped,  ///< from the system, and back to it: many that grow side by side leave no holes
};

/// Bytes of a packet that has not arrived whole. Unlike a vector it does not write zeros over room
/// that a socket is about to fill, and it gives large room back once it is empty.
class ReceiveBuffer {
 public:
  ReceiveBuffer() = default;
  ReceiveBuffer(const ReceiveBuffer&) = delete;
  ReceiveBuffer& operator=(const ReceiveBuffer&) = delete;
  ReceiveBuffer(ReceiveBuffer&& other) noexcept { Swap(other); }
  ReceiveBuffer& operator=(ReceiveBuffer&& other) noexcept {
    ReceiveBuffer(std::move(other)).Swap(*this);
    return *this;
  }
  ~ReceiveBuffer() { Free(); }

  [[nodiscard]] bool empty() const { return used_ == 0; }
  [[nodiscard]] ByteView bytes() const { return {room_, used_}; }
  [[nodiscard]] std::size_t capacity() const { return capacity_; }

  void Append(ByteView bytes) {
    Reserve(used_ + bytes.size(), RoomKind::kHeap);
    std::memcpy(room_ + used_, bytes.data(), bytes.size());
    used_ += bytes.size();
  }
  /// Room up to `total` bytes in all, to be filled and then claimed with Grew().
  [[nodiscard]] std::span<std::byte> RoomUpTo(std::size_t total, RoomKind kind) {
    Reserve(total, kind);
    return {room_ + used_, total - used_};
  }
  void Grew(std::size_t count) { used_ += count; }
  void Clear() {
    used_ = 0;
    if (capacity_ > kKept) {
      Free();
    }
  }

 private:
  static constexpr std::size_t kKept = std::size_t{16} << 10;

  void Swap(ReceiveBuffer& other) noexcept {
    std::swap(room_, other.room_);
    std::swap(used_, other.used_);
    std::swap(capacity_, other.capacity_);
    std::swap(is_mapped_, other.is_mapped_);
  }
  void Free() {
    if (is_mapped_) {
      ::munmap(room_, capacity_);
    } else {
      std::free(room_);  // NOLINT(cppcoreguidelines-no-malloc): what Reserve got
    }
    room_ = nullptr;
    used_ = capacity_ = 0;
    is_mapped_ = false;
  }
  /// What is mapped grows in place, or moves without being copied.
  void Reserve(std::size_t total, RoomKind kind) {
    if (total <= capacity_) {
      return;
    }
    void* larger = nullptr;
    if (is_mapped_) {
      larger = ::mremap(room_, capacity_, total, MREMAP_MAYMOVE);
    } else if (kind == RoomKind::kMapped) {
      larger = ::mmap(nullptr, total, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    } else {
      larger = std::realloc(room_, total);  // NOLINT(cppcoreguidelines-no-malloc): no zeros
    }
    if (larger == nullptr || larger == MAP_FAILED) {
      throw std::bad_alloc();
    }
    if (!is_mapped_ && kind == RoomKind::kMapped) {
      const std::size_t used = used_;
      if (used > 0) {
        std::memcpy(larger, room_, used);
      }
      Free();
      used_ = used;
      is_mapped_ = true;
    }
    room_ = static_cast<std::byte*>(larger);
    capacity_ = total;
  }

  std::byte* room_ = nullptr;
  std::size_t used_ = 0;
  std::size_t capacity_ = 0;
  bool is_mapped_ = false;
};

}  // namespace limpet

// SPDX-License-Identifier: MIT
// How binary topics are written and read; for their codecs alone.
#pragma once

#include <bit>
#include <cstddef>
#include <cstring>
#include <utility>

#include "limpet/core/message.hpp"

namespace limpet {

static_assert(std::endian::native == std::endian::little,
              "binary topics are written as they lie in memory");

class ByteWriter {
 public:
  explicit ByteWriter(std::size_t size) { bytes_.reserve(size); }
  void Magic(const char* four) { Raw(four, 4); }
  void Zeros(std::size_t count) { bytes_.resize(bytes_.size() + count); }
  template <class T>
  void Put(T value) {
    Raw(&value, sizeof value);
  }
  void Raw(const void* data, std::size_t size) {
    const auto* first = static_cast<const std::byte*>(data);
    bytes_.insert(bytes_.end(), first, first + size);
  }
  Binary Take() { return std::move(bytes_); }

 private:
  Binary bytes_;
};

class ByteReader {
 public:
  explicit ByteReader(const Binary& bytes) : bytes_(bytes) {}
  [[nodiscard]] bool HasMagic(const char* four) {
    constexpr std::size_t kSize = 4;
    const bool is_it = left() >= kSize && std::memcmp(bytes_.data() + position_, four, kSize) == 0;
    position_ += is_it ? kSize : 0;
    return is_it;
  }
  template <class T>
  bool Get(T& value) {
    return Raw(&value, sizeof value);
  }
  bool Skip(std::size_t count) {
    const bool fits = left() >= count;
    position_ += fits ? count : 0;
    return fits;
  }
  bool Raw(void* data, std::size_t size) {
    if (left() < size) {
      return false;
    }
    if (size == 0) {
      return true;  // an empty vector may have no address, which memcpy must not see
    }
    std::memcpy(data, bytes_.data() + position_, size);
    position_ += size;
    return true;
  }
  [[nodiscard]] std::size_t left() const { return bytes_.size() - position_; }

 private:
  const Binary& bytes_;
  std::size_t position_ = 0;
};

}  // namespace limpet

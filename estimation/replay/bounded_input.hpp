// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <mrpt/io/CStream.h>

namespace limpet {

/// Bytes for MRPT to make an object of, which may lie. MRPT makes room for as many elements as four
/// bytes say before it reads them. In the classes that are read with this, four bytes are such a
/// length or what a length announced, so that a length of more than follows is refused first.
class BoundedInput final : public mrpt::io::CStream {
 public:
  explicit BoundedInput(std::string_view bytes) : bytes_(bytes.substr(0, kLongest)) {}

  std::size_t Read(void* out, std::size_t count) override {
    const std::size_t given = std::min(count, bytes_.size() - at_);
    has_ended_ = has_ended_ || given < count;
    std::memcpy(out, bytes_.data() + at_, given);
    at_ += given;
    const std::uint32_t elements = std::exchange(length_, 0);
    const bool is_content = elements > 0 && count % elements == 0;
    if (given == sizeof(length_) && count == sizeof(length_) && !is_content) {
      std::memcpy(&length_, out, sizeof(length_));
      if (length_ > bytes_.size() - at_) {
        has_ended_ = true;
        throw std::runtime_error("it says more than follows");
      }
    }
    return given;
  }
  std::size_t Write(const void* /*bytes*/, std::size_t /*count*/) override { return 0; }
  std::uint64_t Seek(std::int64_t /*offset*/, TSeekOrigin /*origin*/) override { return at_; }
  [[nodiscard]] std::uint64_t getTotalBytesCount() const override { return bytes_.size(); }
  [[nodiscard]] std::uint64_t getPosition() const override { return at_; }
  /// More was asked for than there is.
  [[nodiscard]] bool has_ended() const { return has_ended_; }

 private:
  static constexpr std::size_t kLongest = std::size_t{1} << 22U;  ///< no observation is longer
  std::string_view bytes_;
  std::size_t at_ = 0;
  std::uint32_t length_ = 0;  ///< of what is read next, in elements
  bool has_ended_ = false;
};

}  // namespace limpet

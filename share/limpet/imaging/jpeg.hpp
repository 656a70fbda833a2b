// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "limpet/vision/image.hpp"

namespace limpet {

/// Sends pictures through a camera's JPEG stream and back.
class Jpeg {
 public:
  /// `quality` 1 to 100; below 1 pictures stay as they are.
  explicit Jpeg(int quality);
  ~Jpeg();
  Jpeg(Jpeg&&) noexcept;
  Jpeg& operator=(Jpeg&&) noexcept;
  Jpeg(const Jpeg&) = delete;
  Jpeg& operator=(const Jpeg&) = delete;
  void Compress(Image& image);
  /// Of the last picture [bytes].
  [[nodiscard]] std::size_t size() const { return bytes_.size(); }

 private:
  struct Scratch;
  std::unique_ptr<Scratch> scratch_;
  int quality_;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace limpet

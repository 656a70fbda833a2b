// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "limpet/vision/image.hpp"

namespace limpet {

/// Sends pictures through a camera's JPEG stream and back.
class Jpeg {
 public:
  /// `quality` 1 to 100; below 1 pictures stay as they are.
  explicit Jpeg(int quality) : quality_(quality) {}
  void Compress(Image& image);
  /// Of the last picture [bytes].
  [[nodiscard]] std::size_t size() const { return bytes_.size(); }

 private:
  int quality_;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace limpet

// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <memory>

#include "limpet/vision/image.hpp"

namespace limpet {

/// What a camera's JPEG stream leaves of a picture: luminance and halved colour, cosine transform
/// of 8 x 8 pixels, quantised by the tables of ITU-T T.81, annex K. What follows in a real stream
/// loses nothing and is left out, so the cost does not depend on the picture.
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

 private:
  using Block = std::array<float, 64>;  ///< row by row
  struct Scratch;

  std::unique_ptr<Scratch> scratch_;
  int quality_;
  Block luminance_steps_, color_steps_;
};

}  // namespace limpet

// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "limpet/imaging/linear_image.hpp"
#include "limpet/simulation/image_params.hpp"

namespace limpet {

/// What lens and water do to the sharpness of a picture: each point becomes a small disc, and light
/// that water scatters forward arrives beside its place, as a glow around whatever is bright
/// [Jaffe 1990, the forward-scattered component]. The picture keeps its total light.
class Lens {
 public:
  explicit Lens(const ImageParams::Lens& params);
  ~Lens();
  Lens(Lens&&) noexcept;
  Lens& operator=(Lens&&) noexcept;
  Lens(const Lens&) = delete;
  Lens& operator=(const Lens&) = delete;

  /// `glow`: share of the light that arrives beside its place, 0 to 1.
  void Blur(LinearImage& image, double glow);

 private:
  struct Scratch;
  std::unique_ptr<Scratch> scratch_;
  double blur_px_;
};

/// Share of the light that a pixel gets, `corner2` [0 to 1] being its squared distance from the
/// image's centre over that of the corners: the cos^4 law and the barrel of the lens as one curve.
[[nodiscard]] inline double VignetteAt(const ImageParams::Lens& lens, double corner2) {
  return 1.0 - lens.vignette * corner2;
}

}  // namespace limpet

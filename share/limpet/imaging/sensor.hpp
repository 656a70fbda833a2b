// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "limpet/imaging/linear_image.hpp"
#include "limpet/simulation/image_params.hpp"
#include "limpet/vision/image.hpp"

namespace limpet {

/// Makes 8-bit pixels of light, as a camera's sensor and its processor do: automatic exposure and
/// white balance of this one picture, shot and read noise by electrons, saturation, tone curve.
class Sensor {
 public:
  Sensor(const ImageParams::Sensor& params, int width_px, std::uint64_t seed);

  /// What the automatics chose for a picture.
  struct Settings {
    Eigen::Array3f gain = Eigen::Array3f::Ones();  ///< of blue, green, red: light to signal
    float amplification = 1.0F;  ///< of the electrons, where a longer exposure is not enough
  };
  [[nodiscard]] Settings Meter(const LinearImage& light) const;

  /// `image` has the size of `light` and its memory already. Equal `frame`: equal noise.
  void Develop(const LinearImage& light, const Settings& settings, std::uint32_t frame,
               Image& image);

 private:
  void Code(std::uint8_t* bgr);

  ImageParams::Sensor params_;
  std::uint64_t seed_;
  std::vector<std::uint8_t> curve_;   ///< level of a signal in 1/kWhite
  std::vector<float> noise_;          ///< normal draws, 1-sigma 1
  std::vector<float> signal_;         ///< of a row: blue, then green, then red
  std::vector<std::int32_t> levels_;  ///< of a row: blue, then green, then red, in 1/kWhite
  std::vector<float> sum_;            ///< of the channels' light along a row
};

}  // namespace limpet

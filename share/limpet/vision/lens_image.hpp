// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "limpet/core/lens_model.hpp"
#include "limpet/vision/image.hpp"

namespace limpet {

/// Makes the image that a lens throws of the one that its enclosing pinhole sees.
class LensImage {
 public:
  explicit LensImage(const LensModel& lens);
  ~LensImage();
  LensImage(const LensImage&) = delete;
  LensImage& operator=(const LensImage&) = delete;
  LensImage(LensImage&&) noexcept;
  LensImage& operator=(LensImage&&) noexcept;

  /// `pinhole`: as large as lens.enclosing().
  [[nodiscard]] Image Distorted(const Image& pinhole) const;

 private:
  struct Map;
  std::unique_ptr<Map> map_;
};

}  // namespace limpet

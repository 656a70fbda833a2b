// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "limpet/core/expected.hpp"
#include "limpet/vision/image.hpp"

namespace limpet {

/// Reads PNG, JPEG, TIFF and whatever else OpenCV knows, as 8-bit BGR.
[[nodiscard]] Expected<Image> ReadImage(const std::filesystem::path& file);

}  // namespace limpet

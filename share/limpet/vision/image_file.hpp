// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "limpet/core/expected.hpp"
#include "limpet/vision/image.hpp"

namespace limpet {

/// Reads PNG, JPEG, TIFF and whatever else OpenCV knows, as 8-bit BGR.
[[nodiscard]] Expected<Image> ReadImage(const std::filesystem::path& file);
/// Writes in the format that the extension names; the complaint if that failed.
[[nodiscard]] Expected<bool> WriteImage(const std::filesystem::path& file, const ImageView& image);

}  // namespace limpet

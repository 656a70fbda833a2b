// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>

#include "limpet/core/expected.hpp"
#include "limpet/vision/image.hpp"

namespace limpet {

/// Reads PNG, JPEG, TIFF and whatever else OpenCV knows, as 8-bit BGR. The error names the file,
/// also one that is cut short.
[[nodiscard]] Expected<Image> ReadImage(const std::filesystem::path& file);
/// Writes it as what the name's extension says. The complaint if that failed.
[[nodiscard]] std::optional<Error> WriteImage(const std::filesystem::path& file,
                                              const Image& image);

}  // namespace limpet

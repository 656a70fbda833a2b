// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace limpet {

/// True for a JPEG or PNG that stops before its end: decoders fill up with grey what is lost, and
/// call it a picture. False for other files.
[[nodiscard]] bool IsCutShort(const std::filesystem::path& file);

}  // namespace limpet

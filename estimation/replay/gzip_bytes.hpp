// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "limpet/core/expected.hpp"

namespace limpet {

/// As a gzip file. Equal input gives equal bytes: neither name nor time is in it.
[[nodiscard]] std::string Gzip(std::string_view bytes);

struct UnpackedFile {
  std::string bytes;
  std::optional<std::string> damage;  ///< why there are no more of them
};
/// A file, unpacked if it is gzip, up to `most` bytes. The error names the file.
[[nodiscard]] Expected<UnpackedFile> ReadUnpacked(const std::filesystem::path& file,
                                                  std::size_t most);

}  // namespace limpet

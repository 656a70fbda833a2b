// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "limpet/core/expected.hpp"

namespace limpet {

/// How much time packing may take: kFast takes half the time of kSmall, and a map becomes an eighth
/// of its size instead of a thirteenth.
enum class Packing { kFast, kSmall };

/// As a gzip file. Equal input gives equal bytes: neither name nor time is in it.
[[nodiscard]] std::string Gzip(std::string_view bytes, Packing packing = Packing::kSmall);

/// What Gzip made of; up to `most` bytes. The error says what is wrong with it.
[[nodiscard]] Expected<std::string> Gunzip(std::string_view packed, std::size_t most);
/// True if these are the first bytes of a gzip file.
[[nodiscard]] bool IsGzip(std::string_view bytes);

struct UnpackedFile {
  std::string bytes;
  std::optional<std::string> damage;  ///< why there are no more of them
};
/// A file, unpacked if it is gzip, up to `most` bytes. The error names the file.
[[nodiscard]] Expected<UnpackedFile> ReadUnpacked(const std::filesystem::path& file,
                                                  std::size_t most);

}  // namespace limpet

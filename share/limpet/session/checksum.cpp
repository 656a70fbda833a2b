// SPDX-License-Identifier: MIT
#include "limpet/session/checksum.hpp"

#include <fmt/format.h>
#include <xxhash.h>

namespace limpet {

std::string ChecksumOf(std::string_view bytes) {
  return fmt::format("{:016x}", XXH3_64bits(bytes.data(), bytes.size()));
}

}  // namespace limpet

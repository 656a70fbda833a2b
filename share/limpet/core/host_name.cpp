// SPDX-License-Identifier: MIT
#include "limpet/core/host_name.hpp"

#include <array>

#include <unistd.h>

namespace limpet {

std::optional<std::string> HostName() {
  std::array<char, 256> name{};
  if (::gethostname(name.data(), name.size() - 1) != 0) return std::nullopt;
  return name.data();
}

}  // namespace limpet

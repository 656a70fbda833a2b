// SPDX-License-Identifier: MIT
#include "limpet/core/require.hpp"

#include <cstdlib>

#include <fmt/core.h>

namespace limpet {

void RequirementFailed(const char* condition, const char* file, int line, std::string_view detail) {
  fmt::print(stderr, "{}:{}: requirement failed: {} ({})\n", file, line, condition, detail);
  std::abort();
}

}  // namespace limpet

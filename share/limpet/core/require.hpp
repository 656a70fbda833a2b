// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace limpet {

/// Prints the broken precondition with its place and aborts. Always armed: a bug must not fly on.
[[noreturn]] void RequirementFailed(const char* condition, const char* file, int line,
                                    std::string_view detail);

}  // namespace limpet

/// A broken precondition is a bug: stop at once and say where.
#define LIMPET_REQUIRE(condition, detail)                                    \
  do {                                                                       \
    if (!(condition)) {                                                      \
      ::limpet::RequirementFailed(#condition, __FILE__, __LINE__, (detail)); \
    }                                                                        \
  } while (false)

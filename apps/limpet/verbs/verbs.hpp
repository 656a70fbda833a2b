// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

namespace limpet {

struct Verb {
  const char* name;
  const char* summary;
  int (*run)(std::span<const std::string> args);
};

/// Every verb, in the order of the help text. A new one is a line in verbs.cpp.
[[nodiscard]] const std::vector<Verb>& Verbs();

}  // namespace limpet

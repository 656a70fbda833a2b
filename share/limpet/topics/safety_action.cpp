// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>

#include "limpet/topics/safety.hpp"

namespace limpet {
namespace {

constexpr std::array<std::string_view, 7> kSafetyActionNames{"none",   "warn",    "degrade", "hold",
                                                             "return", "surface", "abort"};

}  // namespace

std::string_view NameOf(SafetyAction action) {
  return kSafetyActionNames[static_cast<std::size_t>(action)];
}

std::optional<SafetyAction> SafetyActionNamed(std::string_view name) {
  const auto* const found = std::ranges::find(kSafetyActionNames, name);
  if (found == kSafetyActionNames.end()) return std::nullopt;
  return static_cast<SafetyAction>(found - kSafetyActionNames.begin());
}

}  // namespace limpet

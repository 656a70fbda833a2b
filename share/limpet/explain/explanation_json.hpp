// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "limpet/explain/explanation.hpp"

namespace limpet {

/// The keys of `limpet why --json`, one object with its line feed. `session`: which it is of, left
/// out if empty.
[[nodiscard]] std::string JsonOf(const Explanation& explanation, const std::string& session);
/// A list of such objects.
[[nodiscard]] std::string JsonOf(std::span<const Explanation> explanations,
                                 const std::string& session);

}  // namespace limpet

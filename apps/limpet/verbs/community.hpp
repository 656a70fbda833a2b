// SPDX-License-Identifier: MIT
// Verbs that look at a community and write into it; uScope, uPoke and uPlay are the same.
#pragma once

#include <span>
#include <string>

namespace limpet {

[[nodiscard]] int RunScopeVerb(std::span<const std::string> args);
[[nodiscard]] int RunPokeVerb(std::span<const std::string> args);
[[nodiscard]] int RunPlayVerb(std::span<const std::string> args);
[[nodiscard]] int RunStatusVerb(std::span<const std::string> args);

}  // namespace limpet

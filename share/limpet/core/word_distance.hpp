// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string_view>

namespace limpet {

/// Letters to insert, to remove or to change that turn `a` into `b`; case does not count.
[[nodiscard]] std::size_t WordDistance(std::string_view a, std::string_view b);

}  // namespace limpet

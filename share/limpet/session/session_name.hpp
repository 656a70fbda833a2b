// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/core/expected.hpp"

namespace limpet {

/// Why `name` cannot name a session, or nothing. A session's name is a folder in its run's folder,
/// so it is letters a-z, digits, `_` and `-` (at most 64), and not what Limpet itself keeps there.
[[nodiscard]] std::optional<Error> SessionNameProblem(std::string_view name);

/// Why these cannot be the sessions of one run in this order, or nothing: no session, a name that
/// is none, one that comes twice, or one that is not among `known` (with the nearest that is).
/// An empty `known` allows every name: not every mission has a scenario.
[[nodiscard]] std::optional<Error> SessionListProblem(const std::vector<std::string>& sessions,
                                                      const std::vector<std::string>& known);

}  // namespace limpet

// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "limpet/pubsub/wildcard.hpp"

namespace limpet {

/// `AppPattern=<p>,VarPattern=<p>,Interval=<seconds>` as wildcard registrations carry it: any
/// order, blanks around names and values tolerated, what is missing matches all. Nothing if it is
/// no such text.
[[nodiscard]] std::optional<WildcardFilter> ParseWildcard(std::string_view text);
[[nodiscard]] std::string TextOf(const WildcardFilter& filter);

}  // namespace limpet

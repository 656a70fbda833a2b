// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>

#include "limpet/core/geodesy.hpp"
#include "limpet/session/session_store.hpp"

namespace limpet {

/// Where on earth a session's frame has its origin; nothing if its mission did not say.
[[nodiscard]] std::optional<GeoPoint> DatumOf(const SessionFacts& facts);

/// Throws ConfigError if two sessions' frames have origins apart: the same numbers are other places
/// then. `folder` is the former's. Sessions that do not know theirs pass.
void RequireOneDatum(const SessionFacts& former, const SessionFacts& now,
                     const std::filesystem::path& folder);

}  // namespace limpet

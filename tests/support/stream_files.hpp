// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "tests/support/simulated_stream.hpp"

namespace limpet {

/// Writes a simulated session as `limpet nav` reads one (meta.csv, stream.csv.gz, not compressed:
/// zlib reads that too), with its truth beside it.
void WriteStreamFolder(const SimulatedStream& session, const std::filesystem::path& folder);

}  // namespace limpet

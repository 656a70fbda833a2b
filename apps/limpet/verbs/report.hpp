// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

namespace limpet {

/// `limpet report <run folder> [--json]`: scores, figures and page again from the run's logs.
/// Returns the exit code.
int RunReport(std::span<const std::string> args);

}  // namespace limpet

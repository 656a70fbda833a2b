// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "apps/limpet/cli.hpp"

namespace limpet {

/// The words of a search that goes on: those that it was `asked` for with, and of `given` (with its
/// --resume) what says how it is run and shown here: --jobs, --runner, --keep-runs, --json. Throws
/// Refusal if `given` asks for another search; it names both.
[[nodiscard]] std::vector<std::string> ResumedWords(const std::vector<std::string>& asked,
                                                    const Arguments& given);

}  // namespace limpet

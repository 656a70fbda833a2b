// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

namespace limpet {

/// `limpet survey <mission folder> [--seed N] [--out DIR] [--sessions a,b] [--set app.key=value
/// ...] [--gain full|coverage]
/// [--planner limpet|lawnmower|paper]`: surveys embedded, once per session, and reports.
/// Returns the exit code.
int RunSurvey(std::span<const std::string> args);

}  // namespace limpet

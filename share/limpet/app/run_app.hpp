// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace limpet {

/// Runs a registered app as a process of a community, until SIGINT or SIGTERM: the whole of an
/// app's main. Exit codes: 0 ended in order, 2 command line or configuration.
[[nodiscard]] int RunApp(const std::string& process, int argc, const char* const* argv);

/// Installs handlers for SIGINT and SIGTERM; true once one has come.
void CatchEndSignals();
[[nodiscard]] bool EndIsRequested();

}  // namespace limpet

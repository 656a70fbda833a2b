// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace limpet {

/// Looks at a mission before anything of it is started and says what is wrong, one line each, on
/// stderr. 0 if it may start, 2 if it cannot be read, 3 if it cannot work: the exit code.
[[nodiscard]] int RefuseToLaunch(const std::filesystem::path& mission_file);

}  // namespace limpet

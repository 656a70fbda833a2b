// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

namespace limpet {

/// `limpet tune <mission folder> --vary owner.key=low:high[:levels] ... --objective EXPRESSION`:
/// which setting of a mission is best. `--live`: one parameter of a behavior that runs.
[[nodiscard]] int RunTune(std::span<const std::string> args);

}  // namespace limpet

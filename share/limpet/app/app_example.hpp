// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "limpet/app/registry.hpp"

namespace limpet {

/// A ProcessConfig block with every parameter of an app, one comment each: what `--example` prints.
/// The app takes it as it is; what is marked `required` holds an example, not a default.
[[nodiscard]] std::string AppExample(const std::string& process, const AppEntry& entry);

}  // namespace limpet

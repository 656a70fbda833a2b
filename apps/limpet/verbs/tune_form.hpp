// SPDX-License-Identifier: MIT
#pragma once

#include "apps/limpet/cli.hpp"

namespace limpet {

/// What `limpet tune` takes.
[[nodiscard]] Command TuneForm();

}  // namespace limpet

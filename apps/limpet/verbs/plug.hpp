// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

namespace limpet {

/// `limpet plug <in> <out> [options] [MACRO=value ...]`: expands a template as nsplug does, with
/// its options. Never writes over a file without --force or a person's yes.
int RunPlug(std::span<const std::string> args);

}  // namespace limpet

// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

namespace limpet {

/// `limpet log scan|stat|grep|clip|csv|recover|rawlog`: looks into .alog files, ours and MOOS's.
int RunLog(std::span<const std::string> args);

}  // namespace limpet

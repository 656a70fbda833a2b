// SPDX-License-Identifier: MIT
// A recorder's clock that was set while it recorded: all sensors' stamps leap together.
#pragma once

#include <string>

#include "estimation/replay/sensor_stream.hpp"

namespace limpet {

/// Takes such leaps out of a stream's times, so that each row has the time it would have had, and
/// says each in `left_out`. Back is a step of the clock. Ahead, by more than ten minutes, it is one
/// if attitude and depth go on as they were; else it is a pause, and of what comes more than half
/// an hour later nothing is kept: that is another dive, and `cut` says so. The first few rows
/// before such a leap are left out. By less it is a pause, too, and `doubts` says that it may be a
/// step. Others that leap by themselves are left to the gates. `name` is
/// the file's.
void TakeOutClockSteps(const std::string& name, SensorStream& stream);

}  // namespace limpet

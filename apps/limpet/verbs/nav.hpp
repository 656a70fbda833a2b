// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

namespace limpet {

/// `limpet nav <stream folder> --out DIR [--vehicle FILE] [--plot]`: runs the estimator alone on a
/// recorded sensor stream and writes online.csv, smoothed.csv, states.csv, landmarks.csv,
/// associations.csv and timing.json. Returns the exit code.
int RunNav(std::span<const std::string> args);

}  // namespace limpet

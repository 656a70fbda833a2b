// SPDX-License-Identifier: MIT
// pNav's block as a mission file has it: its own keys and those of the sensors that it names, each
// behind its sensor's name: `beacon_range_sigma_m`.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "apps/pNav/nav_app.hpp"
#include "estimation/navigation/source_block.hpp"
#include "limpet/core/config.hpp"

namespace limpet {

/// The app's parameters, and a factory per sensor that holds the sensor's.
struct NavBlock {
  NavApp::Params params;
  NamedSources sensors, sources;  ///< of dead reckoning, and further ones
  std::vector<ConfigProblem> problems;

  explicit NavBlock(const ConfigBlock& block);
};

/// Every problem of the block.
[[nodiscard]] std::vector<ConfigProblem> CheckNavBlock(const ConfigBlock& block);
/// Throws ConfigError with every problem of the block.
[[nodiscard]] std::unique_ptr<App> CreateNavApp(const AppContext& context,
                                                const ConfigBlock& block);

}  // namespace limpet

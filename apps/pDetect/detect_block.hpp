// SPDX-License-Identifier: MIT
// pDetect's block as a mission file has it: its own keys and those of the detector that it names.
#pragma once

#include <memory>
#include <vector>

#include "apps/pDetect/detect_app.hpp"
#include "limpet/core/config.hpp"
#include "limpet/vision/detector_registry.hpp"

namespace limpet {

/// The app's parameters, and a factory that holds the detector's; none if the detector is unknown.
struct DetectBlock {
  DetectApp::Params params;
  std::unique_ptr<DetectorFactory> factory;
  std::vector<ConfigProblem> problems;

  explicit DetectBlock(const ConfigBlock& block);
};

/// Every problem of the block.
[[nodiscard]] std::vector<ConfigProblem> CheckDetectBlock(const ConfigBlock& block);
/// Throws ConfigError with every problem of the block.
[[nodiscard]] std::unique_ptr<App> CreateDetectApp(const AppContext& context,
                                                   const ConfigBlock& block);

}  // namespace limpet

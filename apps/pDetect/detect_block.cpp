// SPDX-License-Identifier: MIT
#include "apps/pDetect/detect_block.hpp"

#include <algorithm>
#include <iterator>
#include <string>

#include "limpet/app/registry.hpp"

namespace limpet {
namespace {

std::string DetectorOf(const ConfigBlock& block) {
  const ConfigEntry* entry = block.Find("detector");
  return entry != nullptr ? entry->value : DetectApp::Params().detector;
}

/// MOOS's keys; where the detector is unknown, those of all detectors too: one slip is one problem.
std::vector<std::string> KeysOfOthers(bool is_known_detector) {
  std::vector<std::string> keys = CommonAppKeys();
  for (const std::string& name : is_known_detector ? std::vector<std::string>() : DetectorNames()) {
    std::ranges::transform((*FindDetector(name))->Parameters(), std::back_inserter(keys),
                           &ParamSpec::name);
  }
  return keys;
}

}  // namespace

DetectBlock::DetectBlock(const ConfigBlock& block) {
  std::vector<ParamSpec> specs = DescribeParams(params);
  if (auto found = FindDetector(DetectorOf(block))) {
    factory = *std::move(found);
    std::ranges::move(factory->Parameters(), std::back_inserter(specs));
  }
  problems = ApplyBlock(block, specs, KeysOfOthers(factory != nullptr));
}

std::vector<ConfigProblem> CheckDetectBlock(const ConfigBlock& block) {
  std::vector<ConfigProblem> problems = CheckCommonAppKeys(block);
  std::ranges::move(DetectBlock(block).problems, std::back_inserter(problems));
  return problems;
}

std::unique_ptr<App> CreateDetectApp(const AppContext& context, const ConfigBlock& block) {
  const DetectBlock read(block);
  if (!read.problems.empty()) {
    throw ConfigError(read.problems);
  }
  return std::make_unique<DetectApp>(context, read.params, read.factory->Make());
}

}  // namespace limpet

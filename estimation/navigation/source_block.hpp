// SPDX-License-Identifier: MIT
// The measurement sources that a block names, and their keys, each behind its source's name:
// `sources = beacon_range`, `beacon_range_sigma_m = 0.3`.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "estimation/navigation/source_factory.hpp"
#include "limpet/core/config.hpp"
#include "limpet/core/params.hpp"

namespace limpet {

/// A factory per source, in the block's order.
using NamedSources = std::vector<std::pair<std::string, std::unique_ptr<SourceFactory>>>;

struct SourceBlock {
  NamedSources sources;
  std::vector<ParamSpec> specs;         ///< write into `sources`
  std::vector<ConfigProblem> problems;  ///< unknown or repeated names

  explicit SourceBlock(const ConfigBlock& block);
};

/// A source's parameters as a block spells them.
[[nodiscard]] std::vector<ParamSpec> PrefixedKeys(const std::string& name, SourceFactory& factory);

/// Sources of a command line: `acoustic_fix, beacon_range; beacon_range_at_m = 10, 0, 20`, where
/// the first part is what a block's `sources` says and the others are its lines. Throws
/// ConfigError.
[[nodiscard]] NamedSources ParseSources(std::string_view text);

}  // namespace limpet

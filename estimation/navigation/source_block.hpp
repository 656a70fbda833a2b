// SPDX-License-Identifier: MIT
// The sensors that a block names, and their keys, each behind its sensor's name: `sensors = imu,
// dvl, depth, gps` are those that dead reckoning stands on, `sources = beacon_range` any others;
// `beacon_range_sigma_m = 0.3`.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "estimation/navigation/measurement_source.hpp"
#include "estimation/navigation/source_factory.hpp"
#include "limpet/core/config.hpp"
#include "limpet/core/params.hpp"

namespace limpet {

/// A factory per source, in the block's order.
using NamedSources = std::vector<std::pair<std::string, std::unique_ptr<SourceFactory>>>;

/// What dead reckoning stands on where a block does not say.
inline constexpr const char* kUsualSensors =
    "imu, fog, dvl, dvl_beams, depth, gps, boxes, thrusters";

struct SourceBlock {
  NamedSources sensors;          ///< that dead reckoning stands on
  NamedSources sources;          ///< the further ones
  std::vector<ParamSpec> specs;  ///< write into both
  std::vector<ConfigProblem>
      problems;  ///< names that are unknown, repeated, or under the other key

  explicit SourceBlock(const ConfigBlock& block);
  /// Without sensors that dead reckoning stands on, which a recorded stream has as its rows.
  [[nodiscard]] static SourceBlock OfSourcesAlone(const ConfigBlock& block);

 private:
  SourceBlock() = default;
  /// Reads the names that `key` lists.
  void Read(const ConfigEntry& entry, bool are_of_motion);
};

/// Takes a sensor that dead reckoning stands on out of `source`; nothing if it is none.
[[nodiscard]] std::unique_ptr<MotionSensor> TakeMotionSensor(
    std::unique_ptr<MeasurementSource>& source);
/// Those that dead reckoning stands on where a block does not say, as they come.
[[nodiscard]] std::vector<std::unique_ptr<MotionSensor>> UsualSensors();

/// A source's parameters as a block spells them.
[[nodiscard]] std::vector<ParamSpec> PrefixedKeys(const std::string& name, SourceFactory& factory);

/// Sources of a command line: `acoustic_fix, beacon_range; beacon_range_at_m = 10, 0, 20`, where
/// the first part is what a block's `sources` says and the others are its lines. Throws
/// ConfigError.
[[nodiscard]] NamedSources ParseSources(std::string_view text);

}  // namespace limpet

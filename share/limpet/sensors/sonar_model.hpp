// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <utility>

#include "limpet/core/random.hpp"
#include "limpet/core/units.hpp"
#include "limpet/sensors/sound_scene.hpp"
#include "limpet/topics/sensors.hpp"
#include "limpet/topics/simulation.hpp"
#include "limpet/vehicle/sensor_sheets.hpp"

namespace limpet {

/// Sonar that looks ahead: the first echo along each narrow beam of a fan that is level with the
/// vehicle. What is nearer than it can hear hides what is behind.
class SonarModel {
 public:
  SonarModel(const SonarSheet& sheet, SoundScene scene, Random random)
      : sheet_(sheet), scene_(std::move(scene)), random_(random) {}
  [[nodiscard]] std::optional<SonarPing> Sample(const SimTruth& truth, Seconds now);

 private:
  SonarSheet sheet_;
  SoundScene scene_;
  Random random_;
};

}  // namespace limpet

// SPDX-License-Identifier: MIT
// A sensor's samples as the scenario's faults leave them.
#pragma once

#include <optional>
#include <string>

#include "limpet/core/random.hpp"
#include "limpet/mission/fault_schedule.hpp"
#include "limpet/topics/sensors.hpp"

namespace limpet {

/// Silent and stuck, as any sensor may be; `name` is what its faults are called by: dvl, depth...
template <class T>
class FaultySensor {
 public:
  explicit FaultySensor(const std::string& name)
      : silent_(name + "_silent"), stuck_(name + "_stuck") {}

  /// What comes of `sample`; nothing while it is silent.
  [[nodiscard]] std::optional<T> Pass(const T& sample, const FaultSchedule& faults) {
    if (faults.Active(silent_) != nullptr) return std::nullopt;
    if (faults.Active(stuck_) != nullptr) {
      if (!last_) last_ = sample;
      return last_;
    }
    last_ = sample;
    return sample;
  }

 private:
  std::string silent_, stuck_;
  std::optional<T> last_;  ///< that it said while it was sound
};

/// An IMU, which may glitch, too.
class FaultyImu {
 public:
  explicit FaultyImu(Random random) : random_(random) {}
  [[nodiscard]] std::optional<ImuSample> Pass(ImuSample sample, const FaultSchedule& faults);

 private:
  FaultySensor<ImuSample> any_{"imu"};
  Random random_;
};

/// A DVL, whose altitude may stick while its velocity is sound, and which may glitch.
class FaultyDvl {
 public:
  explicit FaultyDvl(Random random) : random_(random) {}
  [[nodiscard]] std::optional<DvlSample> Pass(DvlSample sample, const FaultSchedule& faults);

 private:
  FaultySensor<DvlSample> any_{"dvl"};
  Random random_;
  std::optional<double> altitude_;
};

[[nodiscard]] double WithDepthFault(double depth_m, const FaultSchedule& faults);
[[nodiscard]] GpsFix WithGpsFault(GpsFix fix, const FaultSchedule& faults);

}  // namespace limpet

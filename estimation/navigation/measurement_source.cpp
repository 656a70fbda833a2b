// SPDX-License-Identifier: MIT
#include "estimation/navigation/measurement_source.hpp"

#include <mrpt/obs/CObservation.h>

namespace limpet {

std::optional<MotionReading> MotionSensor::Read(double t, const Value& value) const {
  const auto seen = Observe(t, value);
  return seen == nullptr ? std::nullopt : ReadingOf(*seen);
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
// A sensor that dead reckoning stands on: from mail to an observation, to a file and back, to what
// it reads.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <variant>

#include <gtest/gtest.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/obs/CObservation.h>
#include <mrpt/obs/registerAllClasses.h>
#include <mrpt/serialization/CArchive.h>

#include "estimation/navigation/observation_forms.hpp"
#include "estimation/navigation/source_block.hpp"
#include "limpet/topics/sensors.hpp"

namespace limpet {

constexpr double kMailTime = 1767225600.1234567;  // [s] MOOS time

inline std::unique_ptr<MotionSensor> MotionSensorCalled(const std::string& name) {
  auto source = (*FindSource(name))->Make();
  return TakeMotionSensor(source);
}

/// What comes back of an observation from an archive of MRPT's.
inline ObservationPtr Archived(const ObservationPtr& seen) {
  mrpt::obs::registerAllClasses_mrpt_obs();
  mrpt::io::CMemoryStream memory;
  auto archive = mrpt::serialization::archiveFrom(memory);
  archive << *seen;
  memory.Seek(0);
  return std::dynamic_pointer_cast<mrpt::obs::CObservation>(archive.ReadObject());
}

/// What the sensor reads in mail of `kMailTime`, by way of an archive.
template <class Reading>
Reading ReadingBy(const std::string& name, const Value& value) {
  const auto sensor = MotionSensorCalled(name);
  return std::get<Reading>(*sensor->ReadingOf(*Archived(sensor->Observe(kMailTime, value))));
}

/// Mail that is none of the sensor's, and observations that it cannot have made, are nothing.
inline void ExpectRefusals(const std::string& name) {
  const auto sensor = MotionSensorCalled(name);
  EXPECT_EQ(sensor->Observe(kMailTime, Value(std::string("{\"u\":"))), nullptr);
  const auto imu = MotionSensorCalled("imu"), gps = MotionSensorCalled("gps");
  const MotionSensor& other = name == "gps" ? *imu : *gps;
  const Value said =
      name == "gps" ? TopicCodec<ImuSample>::Encode({}) : TopicCodec<GpsFix>::Encode({.sd = 0.4});
  EXPECT_FALSE(sensor->ReadingOf(*other.Observe(kMailTime, said)).has_value());
}

}  // namespace limpet

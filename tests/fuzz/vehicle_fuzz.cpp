// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "limpet/core/config.hpp"
#include "limpet/vehicle_file/vehicle_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    const limpet::VehicleFile vehicle = limpet::ParseVehicleFile(text, "fuzz.yaml");
    const limpet::CameraModel camera = vehicle.camera.geometry();
    if (!(camera.fx > 0.0) || !std::isfinite(camera.fx)) std::abort();
  } catch (const limpet::ConfigError&) {
    return 0;  // a refusal is a fine answer
  }
  return 0;
}

// SPDX-License-Identifier: MIT
// What is estimated beside pose and objects, by name.
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <vector>

#include <fmt/format.h>

#include "estimation/navigation/aiding_sources.hpp"
#include "estimation/navigation/navigator.hpp"

namespace limpet {
namespace {

using Names = std::array<const char*, 3>;

constexpr Names kSlow{"dvl_scale", "dvl_misalignment", "yaw_rate_bias"};
constexpr Names kMount{"gyro_scale", "dvl_lever_ahead", "dvl_lever_starboard"};
constexpr Names kDepth{"depth_bias", "surface_depth_error", nullptr};
constexpr Names kTilt{"camera_tilt_roll", "camera_tilt_pitch", "camera_tilt_yaw"};
constexpr Names kCompass{"compass_offset", "compass_deviation_sin", "compass_deviation_cos"};
constexpr Names kShift{"camera_lever_ahead", "camera_lever_starboard", "delay"};

void AddBlock(const Smoother& smoother, int slot, const Names& names,
              std::vector<NamedState>& states) {
  const Eigen::Vector3d value = smoother.BorderAt(slot);
  const Eigen::Vector3d variance = smoother.Covariance({slot}).diagonal().tail<3>();
  for (int i = 0; i < 3 && names[static_cast<std::size_t>(i)] != nullptr; ++i) {
    states.push_back({.name = names[static_cast<std::size_t>(i)],
                      .value = value(i),
                      .sd = std::sqrt(std::max(variance(i), 0.0))});
  }
}

}  // namespace

std::vector<NamedState> Navigator::States(double t) const {
  std::vector<NamedState> states;
  if (const auto water = Water(t)) {
    states.push_back({"current_north", water->current_W.x(), water->sd_current_W.x()});
    states.push_back({"current_east", water->current_W.y(), water->sd_current_W.y()});
    states.push_back({"water_speed", water->speed, water->sd_speed});
  }
  const OdometryErrors& errors = chain_.errors();
  AddBlock(smoother_, errors.slow_slot(), kSlow, states);
  if (errors.mount_slot()) AddBlock(smoother_, *errors.mount_slot(), kMount, states);
  if (const auto slot = chain_.depth_errors().slot()) AddBlock(smoother_, *slot, kDepth, states);
  if (const auto error = fix_error()) states.push_back({"gps_sigma_ratio", error->mean, error->sd});
  if (compass_.slot()) AddBlock(smoother_, *compass_.slot(), kCompass, states);
  if (const auto& slots = tracker_.mount().slots()) {
    AddBlock(smoother_, (*slots)[0], kTilt, states);
    AddBlock(smoother_, (*slots)[1], kShift, states);
  }
  for (int source = 0; source < aiding().size(); ++source) {
    std::ranges::move(aiding().NamedErrorsOf(source), std::back_inserter(states));
  }
  return states;
}

std::vector<NamedState> Navigator::Sizes() const {
  std::vector<NamedState> sizes;
  for (const TrackedObject& object : tracker_.objects()) {
    if (!object.is_landmark()) continue;
    if (const auto size = tracker_.SizeOf(object))
      sizes.push_back({fmt::format("radius_{}", object.id()), size->radius, size->sd});
    if (object.motion_sd > 0.0)
      sizes.push_back({fmt::format("motion_{}", object.id()), object.motion_sd, 0.0});
  }
  return sizes;
}

}  // namespace limpet

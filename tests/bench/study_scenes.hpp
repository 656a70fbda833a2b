// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

#include "tests/bench/error_scenes.hpp"
#include "tests/support/simulated_stream.hpp"

namespace limpet {

/// Kinds of simulated sessions that the estimator is studied on, by name.
inline std::map<std::string, StreamScene> Scenes() {
  const StreamScene hour{.duration_s = 3600.0,
                         .half_size_m = 30.0,
                         .leg_spacing_m = 4.0,
                         .objects = 14,
                         .classes = 2,
                         .is_rough = true,
                         .tilt_deg = 0.0,
                         .altitude_m = 3.5,
                         .false_share = 0.5,
                         .long_dropouts = 1,
                         .has_turns_in_dropouts = true,
                         .current_mps = 0.15,
                         .leg_speed_sd_mps = 0.003};
  std::map<std::string, StreamScene> scenes{
      {"table1", {.current_mps = 0.15, .leg_speed_sd_mps = 0.003}}, {"hour", hour}};
  scenes["dropouts"] = hour;
  scenes["dropouts"].false_share = 0.6;
  scenes["dropouts"].yaw_bias_degph = 4.0;
  scenes["dropouts"].long_dropouts = 5;
  scenes["twins"] = hour;
  scenes["twins"].has_twins = true;
  scenes["twins"].look_alikes = 6;
  scenes["day"] = hour;
  scenes["day"].duration_s = 6 * 3600.0;
  scenes["day"].half_size_m = 40.0;
  scenes["day"].objects = 50;
  scenes["day"].long_dropouts = 12;
  scenes["day"].resurface_every_s = 3600.0;
  scenes["deep"] = scenes["day"];
  scenes["deep"].objects = 20;
  scenes["deep"].resurface_every_s = 0.0;
  scenes["crowd"] = hour;
  scenes["crowd"].duration_s = 2 * 3600.0;
  scenes["crowd"].half_size_m = 60.0;
  scenes["crowd"].objects = 300;
  scenes["chains"] = scenes["dropouts"];
  scenes["chains"].long_dropouts = 8;
  scenes["chains"].shortest_dropout_s = 90.0;
  scenes["chains"].longest_dropout_s = 180.0;
  scenes["unsteady"] = scenes["dropouts"];
  scenes["unsteady"].leg_speed_sd_mps = 0.02;
  scenes["bursts"] = hour;
  scenes["bursts"].velocity_bursts = 20;
  scenes["slow_dvl"] = hour;
  scenes["slow_dvl"].dvl_period_s = 1.0;
  scenes["noisy"] = hour;
  scenes["noisy"].noise = 5.0;
  for (const ErrorScene& error : ErrorScenes(hour))
    scenes[error.name] = error.scene;
  return scenes;
}

}  // namespace limpet

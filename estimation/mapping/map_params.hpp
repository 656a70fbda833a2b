// SPDX-License-Identifier: MIT
#pragma once

#include "estimation/change/frame_gate.hpp"
#include "estimation/change/status_params.hpp"
#include "estimation/mapping/dvl_beams.hpp"
#include "limpet/core/camera_params.hpp"
#include "limpet/core/params.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

/// How a map is made of what was seen: pMap's block, on board and where a saved session is judged
/// again.
struct MapParams {
  CameraParams camera;
  DvlBeams beams;
  StatusParams status;
  Meters cell{0.25};
  Meters voxel{0.2};
  double object_threshold = 0.7;
  Meters highest_view{6.5};
  Meters seam_loss{0.1};
  Seconds publish_every{0.5};
  Seconds altitude_lasts{5.0};
  template <class V>
  void Describe(V& visit) {
    using namespace literals;
    camera.Describe(visit);
    beams.Describe(visit);
    status.Describe(visit);
    visit("cell_m", cell, "Cell of the survey grid", InRange(0.05_m, 5.0_m));
    visit("voxel_m", voxel, "Voxel of the semantic octree", InRange(0.05_m, 2.0_m));
    visit("object_threshold", object_threshold, "P_a from which a voxel belongs to an object",
          InRange(0.51, 0.95));
    visit("highest_view_m", highest_view, "Frames from higher above the seabed show nothing",
          InRange(0.5_m, 100.0_m));
    visit(
        "seam_loss_m", seam_loss,
        "Strip between two passes that may stay unseen on average: images are drawn in by as much "
        "as that takes, where the vehicle knew its place badly",
        InRange(0.001_m, 1.0_m));
    visit("publish_every_s", publish_every, "Shortest time between two reports of the map",
          InRange(0.1_s, 60.0_s));
    visit("altitude_lasts_s", altitude_lasts, "How long an altitude stands in for a lost one",
          InRange(0.1_s, 60.0_s));
  }
  [[nodiscard]] FrameGate::Params frame_gate() const {
    return {.highest_view = highest_view, .altitude_lasts = altitude_lasts};
  }
};

}  // namespace limpet

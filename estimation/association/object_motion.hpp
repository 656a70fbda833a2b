// SPDX-License-Identifier: MIT
// Objects that move about their place while the vehicle looks: what sways on a line, or in the
// surf.
#pragma once

#include "estimation/association/camera_mount.hpp"
#include "estimation/association/tracked_object.hpp"
#include "estimation/smoothing/smoother.hpp"

namespace limpet {

/// Variance of each of north and east [m^2] of where an object is about its mean place, by the
/// looks of its last pass, whose sightings are no more than `pause` seconds apart; 0 if they do not
/// show that it moves. What is left of each look must swing slowly: noise and false boxes differ
/// from one look to the next.
[[nodiscard]] double MotionVariance(const TrackedObject& object, double pause,
                                    const Smoother& smoother, const CameraMount& mount);

/// Looks at `seen` that should have shown `absent` as well, were both there, and did not.
[[nodiscard]] int CountAbsences(const TrackedObject& seen, const TrackedObject& absent,
                                const Smoother& smoother, const CameraMount& mount);

/// What a look at an object that moves by so much (1-sigma, per axis [m]) says of its mean place.
/// `radius` of the object [m]; 0: not known.
[[nodiscard]] BoxReading OfMeanPlace(const BoxReading& reading, double motion_sd,
                                     const CameraModel& camera, double radius);

}  // namespace limpet

// SPDX-License-Identifier: MIT
// The words of docs/navigation-honesty.md around its tables.
#pragma once

namespace limpet {

inline constexpr const char* kHonestyHead = R"(# How sure the navigation is, and how right

Squared error over stated covariance (NEES) of simulated sessions with truth: 3 per point if the
covariance says what the error is, more if it is too sure, less if too cautious. Poses are those published
while the session ran, every tenth second; landmarks are those of the end. Both are absolute, so a session's
GPS error and first heading are one sample for all its points: the band is where 95 % of such means fall.
Between landmarks, under their joint covariance, these two drop out; there a session has as many
samples as landmarks, and its mean is not bound to the band. Per axis: x, y, z, 1 each.
Scenes and seeds are those of `tests/support/simulated_stream`, none left out.
Generated: `nav_study --markdown > docs/navigation-honesty.md` (`tests/bench`).

| scene | sessions | poses | landmarks | band | poses per axis | landmarks per axis | between landmarks | between, per axis | smoothed, aligned [m] |
|---|---|---|---|---|---|---|---|---|---|
)";

inline constexpr const char* kHonestyTail = R"(
The depth sensor's bias is a state: what its zero and the air's pressure leave lowers all poses and landmarks
alike, and is told by the readings at the surface, as well as it is known how deep the vehicle floats. Nothing
of it is off in these scenes: their z column is below 1.

All of it took {:.0f} s of one thread, simulation included.
)";

inline constexpr const char* kErrorsHead = R"(
## When the world is not as the data sheets say

The hour of above, each time with one thing that the estimator is not told (`tests/bench/error_scenes.hpp`;
the models are the simulator's, [scenario-file.md](scenario-file.md)): what a workshop leaves, or about twice what is believed.
30 seeds each, from 301 on, none left out. Errors are of the smoothed track, aligned; doubled, false and
missed objects are sums over all sessions. This table alone: `nav_study --errors`.
What is assumed halved and doubled, thing by thing, in closed loop: [half-and-twice.md](half-and-twice.md).

| what is off (scene) | mean [m] | worst [m] | doubled | false | missed | NEES of poses | of landmarks | between landmarks |
|---|---|---|---|---|---|---|---|---|
)";

}  // namespace limpet

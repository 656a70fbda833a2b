// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "training/detector/labelled_picture.hpp"

namespace limpet {

/// Pictures of the simulated camera over seabeds, in waters, lights and cameras drawn from wide
/// ranges; balls among things of other forms. Each seed is a world with `frames` pictures.
[[nodiscard]] std::vector<LabelledPicture> RenderedFrames(std::uint64_t seed, int frames);

}  // namespace limpet

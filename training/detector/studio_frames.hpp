// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "training/detector/labelled_picture.hpp"

namespace limpet {

/// A picture that is composed, not rendered: balls among all kinds of things before all kinds
/// of water, through all kinds of cameras. It is meant to hold more than any sea does, so that what
/// is learned of it does not depend on one.
[[nodiscard]] LabelledPicture StudioFrame(std::uint64_t seed);

}  // namespace limpet

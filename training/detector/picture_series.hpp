// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>

#include "training/detector/labelled_picture.hpp"

namespace limpet {

/// How many pictures of each kind. Those of different seeds have nothing in common.
struct PictureSeries {
  int studio = 0;
  int rendered = 0;
  std::uint64_t seed = 1;
};

/// Hands each picture to `take`; equal series are equal, byte by byte.
void MakePictures(const PictureSeries& series,
                  const std::function<void(const LabelledPicture&)>& take);

}  // namespace limpet

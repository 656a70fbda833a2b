// SPDX-License-Identifier: MIT
#include "training/detector/picture_series.hpp"

#include <algorithm>

#include "training/detector/rendered_frames.hpp"
#include "training/detector/studio_frames.hpp"

namespace limpet {

void MakePictures(const PictureSeries& series,
                  const std::function<void(const LabelledPicture&)>& take) {
  constexpr std::uint64_t kMostPictures = 1'000'000;
  constexpr int kPerWorld = 20;  // to make a world's seabed takes as long as its pictures
  const std::uint64_t first = series.seed * kMostPictures;
  for (int i = 0; i < series.studio; ++i)
    take(StudioFrame(first + static_cast<std::uint64_t>(i)));
  for (int i = 0; i < series.rendered; i += kPerWorld) {
    const int count = std::min(kPerWorld, series.rendered - i);
    for (const LabelledPicture& picture :
         RenderedFrames(first + static_cast<std::uint64_t>(i), count)) {
      take(picture);
    }
  }
}

}  // namespace limpet

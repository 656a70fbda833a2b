// SPDX-License-Identifier: MIT
// Lesson 5: a detector turns an image into boxes; pDetect runs whichever its block names.
#include <algorithm>
#include <cstdint>
#include <vector>

#include <fmt/format.h>

#include "limpet/vision/detector_registry.hpp"

namespace limpet {
namespace {

/// One box around all pixels that are brighter than `threshold`: a lamp on the seabed.
class LampDetector final : public Detector {
 public:
  struct Params {
    int threshold = 200;
    template <class Visitor>
    void Describe(Visitor& visit) {
      visit("threshold", threshold, "Green above this is light", InRange(1, 254));
    }
  };
  explicit LampDetector(const Params& params) : params_(params) {}

  [[nodiscard]] std::vector<Box> Detect(const ImageView& image) override {
    int left = image.width_px, top = image.height_px, right = -1, bottom = -1;
    for (int row = 0; row < image.height_px; ++row) {
      for (int column = 0; column < image.width_px; ++column) {
        if (image.pixel(column, row)[1] <= params_.threshold) continue;
        left = std::min(left, column), right = std::max(right, column);
        top = std::min(top, row), bottom = std::max(bottom, row);
      }
    }
    if (right < 0) return {};
    return {{.u = 0.5 * (left + right + 1),  // the centre, in pixels from the image's corner
             .v = 0.5 * (top + bottom + 1),
             .w = right + 1.0 - left,
             .h = bottom + 1.0 - top,
             .confidence = 0.9,
             .color = "white"}};
  }

 private:
  Params params_;
};

LIMPET_REGISTER_DETECTOR(LampDetector, "lamp");

int Run() {
  Image night{.width_px = 64, .height_px = 48, .bgr = std::vector<std::uint8_t>(3U * 64U * 48U)};
  for (const unsigned lit : {20U * 64U + 30U, 20U * 64U + 31U}) {
    night.bgr[3U * lit + 1U] = 255;
  }
  for (const Box& box : MakeDetector("lamp")->Detect(night.view())) {
    fmt::print("a lamp at ({}, {}), {} by {} pixels\n", box.u, box.v, box.w, box.h);
  }
  return 0;
}

}  // namespace
}  // namespace limpet

int main() { return limpet::Run(); }

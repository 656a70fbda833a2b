// SPDX-License-Identifier: MIT
#include "limpet/vision/chip_cutter.hpp"

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

namespace limpet {
namespace {

/// A bright square of 40 pixels around (320, 240) on a dark ground.
Image Picture() {
  Image image{640, 480, std::vector<std::uint8_t>(std::size_t{3} * 640 * 480, 20)};
  for (int row = 220; row < 260; ++row) {
    for (int column = 300; column < 340; ++column) {
      const std::size_t pixel =
          static_cast<std::size_t>(row) * 640 + static_cast<std::size_t>(column);
      for (std::size_t c = 0; c < 3; ++c)
        image.bgr[3 * pixel + c] = 220;
    }
  }
  return image;
}

Box BoxAt(double u, double v, double w, double h) {
  return {.u = u, .v = v, .w = w, .h = h, .confidence = 0.75, .color = "yellow"};
}

cv::Mat Decoded(const ImageChip& chip) {
  const std::vector<std::uint8_t> bytes(chip.jpeg.begin(), chip.jpeg.end());
  return cv::imdecode(bytes, cv::IMREAD_GRAYSCALE);
}

TEST(ChipCutter, ShowsTheBoxInTheMiddleOfWhatIsAroundIt) {
  const Image image = Picture();
  const ImageChip chip = CutChip(image.view(), BoxAt(320, 240, 40, 40), {});
  const cv::Mat picture = Decoded(chip);
  ASSERT_EQ(picture.size(), cv::Size(72, 72));
  EXPECT_GT(picture.at<std::uint8_t>(36, 36), 200);
  EXPECT_LT(picture.at<std::uint8_t>(4, 4), 40);
  EXPECT_EQ(chip.box.confidence, 0.75);
  EXPECT_EQ(chip.box.color, "yellow");
}

TEST(ChipCutter, ReducesWhatIsLargerThanAPersonNeeds) {
  const Image image = Picture();
  const cv::Mat picture = Decoded(CutChip(image.view(), BoxAt(320, 240, 200, 120), {}));
  EXPECT_EQ(std::max(picture.cols, picture.rows), 96);
  EXPECT_EQ(picture.cols, picture.rows) << "a square, whatever the box";
}

TEST(ChipCutter, StopsAtTheImagesBorder) {
  const Image image = Picture();
  const cv::Mat picture = Decoded(CutChip(image.view(), BoxAt(5, 240, 30, 30), {}));
  EXPECT_EQ(picture.cols, 32);  // from 0 to 5 + 0.9 * 30
  EXPECT_EQ(picture.rows, 54);
}

TEST(ChipCutter, MakesAPictureOfAnyBox) {
  const Image image = Picture();
  for (const Box& box : {BoxAt(-900, -900, 10, 10), BoxAt(9000, 9000, 10, 10),
                         BoxAt(320, 240, 0, 0), BoxAt(320, 240, 1e6, 1e6)}) {
    EXPECT_FALSE(Decoded(CutChip(image.view(), box, {})).empty());
  }
}

TEST(ChipCutter, GivesTheSameBytesForTheSamePicture) {
  const Image image = Picture();
  const Box box = BoxAt(330, 250, 120, 110);
  EXPECT_EQ(CutChip(image.view(), box, {}).jpeg, CutChip(image.view(), box, {}).jpeg);
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/objects/best_chips.hpp"

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

Box BoxOf(double u, double size, double confidence) {
  return {.u = u, .v = 200.0, .w = size, .h = size, .confidence = confidence, .color = "yellow"};
}

/// One image in which a landmark was seen, with its picture.
void See(BestChips& best, double t, std::optional<int> landmark, const Box& box,
         const std::string& picture) {
  best.Add(ImageChips{.exposure = Seconds(t), .chips = {{.box = box, .jpeg = picture}}});
  ObservedFrame frame;
  frame.exposure = Seconds(t);
  frame.boxes = {box};
  frame.boxes.front().landmark = landmark;
  best.Add(frame);
}

std::vector<std::string> PicturesOf(const BestChips& best, int landmark) {
  std::vector<std::string> pictures;
  for (const ObjectChip& chip : best.Of(landmark))
    pictures.push_back(chip.jpeg);
  return pictures;
}

TEST(BestChips, ShowALandmarkAtItsLargestAndSurestFirst) {
  BestChips best;
  See(best, 10.0, 3, BoxOf(100, 30, 0.9), "small");
  See(best, 20.0, 3, BoxOf(300, 80, 0.9), "large");
  See(best, 30.0, 3, BoxOf(300, 80, 0.5), "large and faint");
  See(best, 40.0, 3, BoxOf(300, 20, 0.5), "least");
  EXPECT_EQ(PicturesOf(best, 3), (std::vector<std::string>{"large", "large and faint", "small"}));
  EXPECT_TRUE(best.Of(4).empty());
}

TEST(BestChips, TakeOnePictureOfOneLook) {
  BestChips best;
  for (int i = 0; i < 8; ++i) {
    See(best, 10.0 + 0.25 * i, 3, BoxOf(100, 40 + i, 0.9), std::to_string(i));
  }
  EXPECT_EQ(PicturesOf(best, 3), std::vector<std::string>{"7"});
  See(best, 30.0, 3, BoxOf(100, 40, 0.9), "later");
  EXPECT_EQ(best.Of(3).size(), 2U);
}

TEST(BestChips, BelongToTheLandmarkWhoseBoxTheyShow) {
  BestChips best;
  const Box left = BoxOf(100, 40, 0.9);
  const Box right = BoxOf(400, 40, 0.8);
  best.Add(ImageChips{.exposure = Seconds(5.0),
                      .chips = {{.box = left, .jpeg = "left"}, {.box = right, .jpeg = "right"}}});
  ObservedFrame frame;
  frame.exposure = Seconds(5.0);
  frame.boxes = {right, left, BoxOf(250, 40, 0.9)};
  frame.boxes[0].landmark = 1, frame.boxes[1].landmark = 2, frame.boxes[2].landmark = 3;
  best.Add(frame);
  EXPECT_EQ(PicturesOf(best, 1), std::vector<std::string>{"right"});
  EXPECT_EQ(PicturesOf(best, 2), std::vector<std::string>{"left"});
  EXPECT_TRUE(best.Of(3).empty());
}

TEST(BestChips, AreNobodysWhereTheFrameKnowsNoLandmark) {
  BestChips best;
  See(best, 10.0, std::nullopt, BoxOf(100, 40, 0.9), "ghost");
  EXPECT_TRUE(best.Of(std::nullopt).empty());
}

TEST(BestChips, ForgetAnImageWhoseFrameNeverCame) {
  BestChips best;
  for (int i = 0; i < 100; ++i) {
    best.Add(ImageChips{.exposure = Seconds(i), .chips = {{.box = BoxOf(1, 9, 1), .jpeg = "x"}}});
  }
  ObservedFrame late;
  late.exposure = Seconds(3.0);
  late.boxes = {BoxOf(1, 9, 1)};
  late.boxes.front().landmark = 1;
  best.Add(late);
  EXPECT_TRUE(best.Of(1).empty());
}

TEST(BestChips, AreBoundedWhateverComes) {
  BestChips best;
  Random random(1, "chips");
  for (int i = 0; i < 3000; ++i) {
    See(best, 5.0 * i, i % 1000, BoxOf(100, random.Uniform(5.0, 90.0), 0.9), "x");
  }
  std::size_t landmarks = 0;
  for (int landmark = 0; landmark < 1000; ++landmark) {
    EXPECT_LE(best.Of(landmark).size(), BestChips::kOfEach);
    landmarks += best.Of(landmark).empty() ? 0 : 1;
  }
  EXPECT_EQ(landmarks, BestChips::kMostLandmarks);
}

TEST(BestChips, AreTheSameInWhateverOrderLooksCame) {
  for (int round = 0; round < 50; ++round) {
    Random random(static_cast<std::uint64_t>(round), "looks");
    std::vector<Box> boxes;
    for (int i = 0; i < 9; ++i)
      boxes.push_back(BoxOf(100, random.Uniform(10.0, 90.0), random.Uniform(0.3, 1.0)));
    BestChips forwards;
    BestChips backwards;
    for (int i = 0; i < 9; ++i) {
      See(forwards, 10.0 * i, 1, boxes[static_cast<std::size_t>(i)], std::to_string(i));
      const int other = 8 - i;
      See(backwards, 10.0 * other, 1, boxes[static_cast<std::size_t>(other)],
          std::to_string(other));
    }
    EXPECT_EQ(PicturesOf(forwards, 1), PicturesOf(backwards, 1));
  }
}

}  // namespace
}  // namespace limpet

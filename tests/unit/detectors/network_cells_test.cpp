// SPDX-License-Identifier: MIT
#include "limpet/detectors/network_cells.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace limpet {
namespace {

constexpr int kRows = 3;
constexpr int kColumns = 4;

/// A network's output in which nothing is found yet.
class NetworkCells : public testing::Test {
 protected:
  NetworkCells() {
    for (int row = 0; row < kRows; ++row) {
      for (int column = 0; column < kColumns; ++column)
        Set(0, row, column, -9.0);
    }
  }
  void Set(int channel, int row, int column, double value) {
    cells_.ptr<float>(0, channel)[row * kColumns + column] = static_cast<float>(value);
  }
  [[nodiscard]] std::vector<NetworkFinding> Read() const {
    return ReadCells(cells_, network_, {.least_logit = -2.0, .most_overlap = 0.45});
  }
  [[nodiscard]] NetworkFinding Ask(const PixelRect& place) const {
    return StrongestAt(cells_, network_, place);
  }
  NetworkDescription network_{
      .weights = {}, .colors = {"yellow", "orange", "green"}, .witnesses = {}};

 private:
  const std::array<int, 4> sizes_{1, 8, kRows, kColumns};
  cv::Mat cells_{4, sizes_.data(), CV_32F, cv::Scalar(0.0)};
};

TEST_F(NetworkCells, GiveAnObjectWhereACellIsSureOfOne) {
  Set(0, 1, 2, 3.0);
  Set(1, 1, 2, 0.25);
  Set(2, 1, 2, -0.5);
  Set(3, 1, 2, std::log(0.5));
  Set(6, 1, 2, 2.0);
  const auto found = Read();
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].rect.center_u(), (2.5 + 0.25) * 8.0, 1e-5);
  EXPECT_NEAR(found[0].rect.center_v(), (1.5 - 0.5) * 8.0, 1e-5);
  EXPECT_NEAR(found[0].rect.width(), 16.0, 1e-4);
  EXPECT_NEAR(found[0].rect.height(), 32.0, 1e-4);
  EXPECT_EQ(found[0].color, 1U);
  // A softmax over logits 0, 2, 0: the odds are exp(2) to 2.
  EXPECT_NEAR(found[0].color_logit, std::log(std::exp(2.0) / 2.0), 1e-5);
}

TEST_F(NetworkCells, OfOneObjectOnlyTheSurestSpeaks) {
  Set(0, 1, 1, 1.0);
  Set(0, 1, 2, 3.0);  // 32 pixels wide, 8 pixels apart
  EXPECT_EQ(Read().size(), 1U);
  EXPECT_NEAR(Read()[0].score_logit, 3.0, 1e-6);
}

TEST_F(NetworkCells, KeepsTwoObjectsApartSurestFirst) {
  Set(0, 0, 0, 1.0);
  Set(0, 2, 3, 2.0);
  const auto found = Read();
  ASSERT_EQ(found.size(), 2U);
  EXPECT_GT(found[0].score_logit, found[1].score_logit);
}

TEST_F(NetworkCells, SayNothingBelowTheLeastScore) {
  Set(0, 0, 0, -2.5);
  EXPECT_TRUE(Read().empty());
}

TEST_F(NetworkCells, AnswerForAPlaceByTheStrongestOfItsInnerHalf) {
  Set(0, 0, 0, 5.0);  // at the place's edge: another object's
  Set(0, 1, 1, -1.0);
  Set(0, 1, 2, -3.0);
  EXPECT_NEAR(Ask({0.0, 0.0, 32.0, 24.0}).score_logit, -1.0, 1e-6);
}

TEST_F(NetworkCells, AnswerForAPlaceSmallerThanACellAndForOneOutside) {
  Set(0, 1, 1, 1.5);
  EXPECT_NEAR(Ask({11.0, 11.0, 12.0, 12.0}).score_logit, 1.5, 1e-6);
  EXPECT_NEAR(Ask({500.0, 500.0, 510.0, 510.0}).score_logit, -9.0, 1e-6);
  EXPECT_NEAR(Ask({-50.0, -50.0, -40.0, -40.0}).score_logit, -9.0, 1e-6);
}

TEST_F(NetworkCells, StayFiniteWhateverTheNetworkSays) {
  Set(0, 0, 0, 40.0);
  Set(3, 0, 0, 1e6);
  Set(4, 0, 0, -1e6);
  Set(5, 0, 0, 300.0);
  const auto found = Read();
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(std::isfinite(found[0].rect.area()));
  EXPECT_TRUE(std::isfinite(found[0].color_logit));
}

}  // namespace
}  // namespace limpet

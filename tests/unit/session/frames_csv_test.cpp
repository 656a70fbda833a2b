// SPDX-License-Identifier: MIT
// What a session saw, as it is kept: read back to the digits promised, and refused with the line
// that is none.
#include "limpet/session/frames_csv.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/session/former_views.hpp"

namespace limpet {
namespace {

using ::testing::HasSubstr;

std::vector<ObservedFrame> RandomFrames(Random& random) {
  std::vector<ObservedFrame> frames;
  for (std::uint64_t i = random.Index(8); i > 0; --i) {
    ObservedFrame frame;
    frame.frame = static_cast<int>(random.Index(100000));
    frame.exposure = Seconds(1767225600.0 + random.Uniform(0.0, 1e5));
    frame.X_WB = {
        {random.Uniform(-500.0, 500.0), random.Uniform(-500.0, 500.0), random.Uniform(0.0, 80.0)},
        random.Uniform(-3.1, 3.1),
        random.Uniform(-1.5, 1.5),
        random.Uniform(-3.1, 3.1)};
    if (random.Chance(0.7)) frame.altitude = random.Uniform(0.0, 20.0);
    for (std::uint64_t boxes = random.Index(4); boxes > 0; --boxes) {
      frame.boxes.push_back({.u = random.Uniform(0.0, 640.0),
                             .v = random.Uniform(0.0, 480.0),
                             .w = random.Uniform(1.0, 99.0),
                             .h = random.Uniform(1.0, 99.0),
                             .confidence = random.Uniform(0.0, 1.0),
                             .color = random.Chance(0.5) ? "yellow" : "orange",
                             .landmark = static_cast<int>(random.Index(9))});
      if (random.Chance(0.1)) frame.boxes.back().landmark.reset();
    }
    frames.push_back(frame);
  }
  return frames;
}

void ExpectSameBox(const Box& a, const Box& b) {
  EXPECT_NEAR(a.u, b.u, 0.00501);
  EXPECT_NEAR(a.v, b.v, 0.00501);
  EXPECT_NEAR(a.w, b.w, 0.00501);
  EXPECT_NEAR(a.h, b.h, 0.00501);
  EXPECT_NEAR(a.confidence, b.confidence, 5.01e-5);
  EXPECT_EQ(a.color, b.color);
  EXPECT_EQ(a.landmark, b.landmark);
}

TEST(FramesCsvText, KeepsEveryFrameToTheDigitsPromised) {
  Random random(1, "frames");
  for (int run = 0; run < 100; ++run) {
    const std::vector<ObservedFrame> frames = RandomFrames(random);
    const auto back = FramesFromCsv(FramesToCsv(frames));
    ASSERT_TRUE(back);
    ASSERT_EQ(back->size(), frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
      const ObservedFrame &kept = (*back)[i], &seen = frames[i];
      EXPECT_EQ(kept.frame, seen.frame);
      EXPECT_NEAR(kept.exposure.value(), seen.exposure.value(), 5.1e-4);
      EXPECT_LT((kept.X_WB.p_WB - seen.X_WB.p_WB).cwiseAbs().maxCoeff(), 5.1e-5);
      EXPECT_NEAR(kept.X_WB.roll, seen.X_WB.roll, 5.1e-6);
      EXPECT_NEAR(kept.X_WB.pitch, seen.X_WB.pitch, 5.1e-6);
      EXPECT_NEAR(kept.X_WB.yaw, seen.X_WB.yaw, 5.1e-6);
      ASSERT_EQ(kept.altitude.has_value(), seen.altitude.has_value());
      if (seen.altitude) {
        EXPECT_NEAR(*kept.altitude, *seen.altitude, 5.1e-5);
      }
      ASSERT_EQ(kept.boxes.size(), seen.boxes.size());
      for (std::size_t b = 0; b < seen.boxes.size(); ++b) {
        ExpectSameBox(kept.boxes[b], seen.boxes[b]);
      }
    }
  }
}

TEST(FramesCsvText, IsTheSameWrittenOnceMore) {
  Random random(2, "frames");
  for (int run = 0; run < 100; ++run) {
    const std::string text = FramesToCsv(RandomFrames(random));
    EXPECT_EQ(FramesToCsv(*FramesFromCsv(text)), text);
  }
}

TEST(FramesCsvText, KeepsAClassWhateverItsDetectorCallsIt) {
  for (const char* name : {"dark red", "a,b", "x:y", "two\nlines", "100%", "%20", "", "Ärger", "%",
                           "%2", "tab\there", "sea\rstar"}) {
    ObservedFrame frame;
    frame.boxes = {{.u = 1.0, .v = 2.0, .w = 3.0, .h = 4.0, .confidence = 0.5, .color = name},
                   {.u = 5.0, .v = 6.0, .w = 7.0, .h = 8.0, .confidence = 0.5, .color = "plain"}};
    const auto back = FramesFromCsv(FramesToCsv({frame, frame}));
    ASSERT_TRUE(back) << name;
    ASSERT_EQ(back->size(), 2U) << name;
    ASSERT_EQ((*back)[1].boxes.size(), 2U) << name;
    EXPECT_EQ((*back)[1].boxes[0].color, name);
    EXPECT_EQ((*back)[1].boxes[1].color, "plain");
  }
}

TEST(FramesCsvText, NamesTheLineThatIsNoFrame) {
  ObservedFrame frame;
  frame.boxes = {{.color = "yellow"}};
  const std::string good = FramesToCsv({frame});
  for (const char* line :
       {"1,2,3", "x,0,0,0,0,0,0,0,,", "1,0,0,0,0,0,0,0,high,", "1,0,0,0,0,0,0,0,,1:2:3",
        "1,0,0,0,0,0,0,0,,1:2:3:4:0.5:yellow:x", "1,nan,0,0,0,0,0,0,,", "1,0,0,0,0,0,0,0,,,"}) {
    const auto read = FramesFromCsv(good + line + "\n" + good.substr(good.find('\n') + 1));
    ASSERT_FALSE(read) << line;
    EXPECT_THAT(read.error().text, HasSubstr("line 3")) << line;
  }
}

TEST(FramesCsvText, SurvivesBytesThatSomethingHasSpoilt) {
  Random random(3, "spoilt");
  int refused = 0;
  for (int run = 0; run < 400; ++run) {
    std::string text = FramesToCsv(RandomFrames(random));
    text[random.Index(text.size())] = static_cast<char>(random.Index(256));
    text.resize(text.size() - random.Index(text.size()));
    const auto read = FramesFromCsv(text);
    refused += read ? 0 : 1;
    EXPECT_TRUE(read || !read.error().text.empty());
  }
  EXPECT_GT(refused, 100);
}

TEST(PhasesCsvText, ComesBack) {
  const std::vector<PhaseStart> phases{{0, "DIVE"}, {12, "SURVEY"}, {12, "RETURN"}, {90, "ASCEND"}};
  const auto back = PhasesFromCsv(PhasesToCsv(phases));
  ASSERT_TRUE(back);
  ASSERT_EQ(back->size(), phases.size());
  for (std::size_t i = 0; i < phases.size(); ++i) {
    EXPECT_EQ((*back)[i].frame, phases[i].frame);
    EXPECT_EQ((*back)[i].phase, phases[i].phase);
  }
  EXPECT_TRUE(PhasesFromCsv(PhasesToCsv({}))->empty());
}

}  // namespace
}  // namespace limpet

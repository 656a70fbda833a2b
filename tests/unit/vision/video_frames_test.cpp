// SPDX-License-Identifier: MIT
#include "limpet/vision/video_frames.hpp"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/fake_ffmpeg.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class VideoFramesTest : public ::testing::Test {
 protected:
  std::filesystem::path Video(const std::string& name = "clip.mp4") const {
    std::ofstream(folder_.path() / name) << "a video";
    return folder_.path() / name;
  }
  TemporaryFolder folder_;
  FakeFfmpeg ffmpeg_{folder_.path()};
};

TEST_F(VideoFramesTest, GivesOnePictureAfterTheOther) {
  ffmpeg_.Does(R"(printf 'P6\n2 1\n255\nRGBrgb'; printf 'P6\n1 1\n255\nxyz')");
  VideoFrames frames(Video());
  const std::optional<Image> first = frames.Next(), second = frames.Next();
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->width_px, 2);
  EXPECT_EQ(first->height_px, 1);
  EXPECT_THAT(first->bgr, ElementsAre('B', 'G', 'R', 'b', 'g', 'r'));
  EXPECT_THAT(second->bgr, ElementsAre('z', 'y', 'x'));
  EXPECT_FALSE(frames.Next());
  EXPECT_FALSE(frames.problem()) << frames.problem()->text;
  EXPECT_EQ(frames.count(), 2);
}

TEST_F(VideoFramesTest, KeepsThePicturesUpToWhereFfmpegDied) {
  ffmpeg_.Does(R"(printf 'P6\n1 1\n255\nxyz'; printf 'P6\n2 2\n255\nab'; exit 3)");
  VideoFrames frames(Video());
  EXPECT_TRUE(frames.Next());
  EXPECT_FALSE(frames.Next());
  ASSERT_TRUE(frames.problem());
  EXPECT_THAT(frames.problem()->text,
              HasSubstr("clip.mp4: ffmpeg failed (exit code 3) in the midst of picture 2"));
  EXPECT_FALSE(frames.Next()) << "and stays so";
}

TEST_F(VideoFramesTest, SaysThatFfmpegFailedBetweenTwoPictures) {
  ffmpeg_.Does(R"(printf 'P6\n1 1\n255\nxyz'; exit 1)");
  VideoFrames frames(Video());
  EXPECT_TRUE(frames.Next());
  EXPECT_FALSE(frames.Next());
  ASSERT_TRUE(frames.problem());
  EXPECT_THAT(frames.problem()->text, HasSubstr("ffmpeg failed (exit code 1) after 1 pictures"));
}

TEST_F(VideoFramesTest, TakesNothingElseForPictures) {
  for (const char* script :
       {"printf 'no picture'", R"(printf 'P6\n2 2\n65535\nabcdefghijkl')",
        R"(printf 'P6\n-2 2\n255\nabc')", R"(printf 'P6\n999999999999 2\n255\nabc')",
        R"(printf 'P6\n900000 900000\n255\nabc')", R"(printf 'P6\n0 0\n255\n')", "exit 0"}) {
    ffmpeg_.Does(script);
    VideoFrames frames(Video());
    EXPECT_FALSE(frames.Next()) << script;
    EXPECT_TRUE(frames.problem()) << script;
  }
}

/// Whoever stops reading does not wait for the rest of the video.
TEST_F(VideoFramesTest, EndsFfmpegThatHasMoreToSay) {
  ffmpeg_.Does(R"(while :; do printf 'P6\n1 1\n255\nxyz'; done)");
  VideoFrames frames(Video());
  EXPECT_TRUE(frames.Next());
}

TEST_F(VideoFramesTest, PassesAStrangeNameOnAsItIs) {
  ffmpeg_.Does(R"(printf 'P6\n1 1\n255\nxyz')");
  const std::filesystem::path video = Video("-y $(touch evil); `x` 'a\".mp4");
  VideoFrames frames(video);
  EXPECT_TRUE(frames.Next());
  EXPECT_FALSE(frames.Next());
  EXPECT_THAT(ffmpeg_.Words(), HasSubstr("\n-i\nfile:" + video.string() + "\n-f\nimage2pipe\n"));
}

TEST_F(VideoFramesTest, NamesTheVideoThatIsNotThereAndTheProgramThatIsNot) {
  VideoFrames nothing(folder_.path() / "none.mp4");
  EXPECT_FALSE(nothing.Next());
  EXPECT_THAT(nothing.problem()->text, HasSubstr("none.mp4: no such file"));
  EXPECT_FALSE(CanReadVideos());
  VideoFrames clip(Video());
  EXPECT_FALSE(clip.Next());
  EXPECT_THAT(clip.problem()->text, HasSubstr("clip.mp4: a video, and there is no ffmpeg"));
}

TEST(VideoName, IsKnownByItsExtension) {
  EXPECT_TRUE(IsVideoName("a/dive.MP4"));
  EXPECT_TRUE(IsVideoName("dive.mkv"));
  EXPECT_FALSE(IsVideoName("dive.png"));
  EXPECT_FALSE(IsVideoName("mp4"));
}

}  // namespace
}  // namespace limpet

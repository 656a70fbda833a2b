// SPDX-License-Identifier: MIT
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>

#include "apps/limpet/cli.hpp"
#include "apps/limpet/command_line.hpp"
#include "limpet/vision/image_file.hpp"
#include "limpet/vision/scene_renderer.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

class DetectVerb : public ::testing::Test {
 protected:
  DetectVerb() {
    SceneRenderer renderer({.camera = {},
                            .seabed_depth = [](double, double) { return 7.5; },
                            .visibility_m = 8.0,
                            .seabed_seed = 1,
                            .noise_seed = 2});
    Pose pose;
    pose.p_WB = {0.0, 0.0, 3.5};
    const Sphere ball{{0.4, 0.8, 7.0}, 0.5, "yellow"};
    const Image image = renderer.Render(pose, std::span(&ball, 1), 0);
    std::ofstream file(folder_.path() / "ball.ppm", std::ios::binary);
    file << "P6 " << image.width_px << ' ' << image.height_px << " 255\n";
    for (std::size_t i = 0; i < image.bgr.size(); i += 3) {
      for (const std::size_t color : {2UL, 1UL, 0UL})
        file.put(static_cast<char>(image.bgr[i + color]));
    }
    std::ofstream(folder_.path() / "broken.png") << "no image";
  }
  std::string Path(const std::string& name) const { return (folder_.path() / name).string(); }
  int Run(const std::vector<std::string>& args) {
    std::vector<std::string> words{"detect"};
    words.insert(words.end(), args.begin(), args.end());
    return RunCommandLine(words);
  }
  std::string Csv() const {
    std::ostringstream text;
    text << std::ifstream(folder_.path() / "out.csv").rdbuf();
    return text.str();
  }
  TemporaryFolder folder_;
};

TEST_F(DetectVerb, WritesOneRowPerBox) {
  EXPECT_EQ(Run({Path("ball.ppm"), "--out", Path("out.csv")}), kOk);
  EXPECT_THAT(Csv(),
              StartsWith("image,class,confidence,x,y,w,h\n" + Path("ball.ppm") + ",yellow,"));
}

TEST_F(DetectVerb, NamesAnUnreadableImageAndDoesTheOthers) {
  EXPECT_EQ(Run({Path("broken.png"), Path("ball.ppm"), "--out", Path("out.csv")}), kFailed);
  EXPECT_THAT(Csv(), HasSubstr("ball.ppm,yellow"));
  EXPECT_THAT(Csv(), Not(HasSubstr("broken")));
}

TEST_F(DetectVerb, TakesAFolder) {
  std::filesystem::remove(folder_.path() / "broken.png");
  EXPECT_EQ(Run({folder_.path().string(), "--out", Path("out.csv")}), kOk);
  EXPECT_THAT(Csv(), HasSubstr("ball.ppm,yellow"));
}

TEST_F(DetectVerb, WrongUsageIsTwo) {
  EXPECT_EQ(Run({}), kUsage);
  EXPECT_EQ(Run({Path("ball.ppm")}), kUsage);
  EXPECT_EQ(Run({Path("ball.ppm"), "--out", Path("out.csv"), "--min-confidence", "7"}), kUsage);
  EXPECT_EQ(Run({Path("ball.ppm"), "--otu", Path("out.csv")}), kUsage);
}

TEST_F(DetectVerb, TakesADetectorByNameWithItsParameters) {
  EXPECT_EQ(Run({Path("ball.ppm"), "--out", Path("out.csv"), "--detector", "color_shape", "--set",
                 "least_radius_px=300"}),
            kOk);
  EXPECT_EQ(Csv(), "image,class,confidence,x,y,w,h\n") << "the ball is smaller than that";
  for (const char* wrong : {"least_radius_px=-1", "least_radius_px", "leest_radius_px=3"}) {
    EXPECT_EQ(Run({Path("ball.ppm"), "--out", Path("out.csv"), "--set", wrong}), kUsage) << wrong;
  }
}

TEST_F(DetectVerb, RefusesADetectorThatDoesNotExist) {
  testing::internal::CaptureStderr();
  EXPECT_EQ(Run({Path("ball.ppm"), "--out", Path("out.csv"), "--detector", "color_shap"}), kUsage);
  EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("did you mean `color_shape`?"));
}

TEST_F(DetectVerb, FailsWhereItCannotWrite) {
  EXPECT_EQ(Run({Path("ball.ppm"), "--out", Path("nowhere/out.csv")}), kFailed);
}

TEST_F(DetectVerb, DrawsWhatItFound) {
  ASSERT_EQ(
      Run({Path("ball.ppm"), Path("ball.ppm"), "--out", Path("out.csv"), "--draw", Path("drawn")}),
      kOk);
  const Expected<Image> before = ReadImage(Path("ball.ppm"));
  const Expected<Image> drawn = ReadImage(Path("drawn/ball.png"));
  ASSERT_TRUE(before && drawn);
  EXPECT_NE(drawn->bgr, before->bgr);
  EXPECT_TRUE(ReadImage(Path("drawn/ball-2.png"))) << "one of like names does not hide another";
}

TEST_F(DetectVerb, CharacterisesADetectorInAFileThatAMissionMayName) {
  ASSERT_EQ(Run({"--characterise", "--worlds", "2", "--seed", "7", "--out", Path("own.yaml")}),
            kOk);
  std::ostringstream sheet;
  sheet << std::ifstream(Path("own.yaml")).rdbuf();
  EXPECT_THAT(sheet.str(),
              HasSubstr("# Made by: limpet detect --characterise --detector "
                        "color_shape --colors yellow,orange,green --worlds 2 --seed 7\n"));
  EXPECT_THAT(sheet.str(), HasSubstr("half_range_share: "));
}

TEST_F(DetectVerb, CharacterisesNoGivenImages) {
  EXPECT_EQ(Run({Path("ball.ppm"), "--characterise", "--out", Path("own.yaml")}), kUsage);
  EXPECT_FALSE(std::filesystem::exists(Path("own.yaml")));
}

TEST_F(DetectVerb, CharacterisesNoColourThatDoesNotExist) {
  testing::internal::CaptureStderr();
  EXPECT_EQ(Run({"--characterise", "--colors", "yellow,orang", "--out", Path("own.yaml")}), kUsage);
  EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("did you mean `orange`?"));
}

TEST_F(DetectVerb, HasNoModelOfADetectorThatFindsNothing) {
  testing::internal::CaptureStderr();
  EXPECT_EQ(Run({"--characterise", "--worlds", "2", "--set", "least_radius_px=300", "--out",
                 Path("own.yaml")}),
            kRefused);
  EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("found no ball"));
  EXPECT_FALSE(std::filesystem::exists(Path("own.yaml")));
}

TEST_F(DetectVerb, SaysBeforeItCharacterisesThatItCannotWrite) {
  EXPECT_EQ(Run({"--characterise", "--worlds", "9000", "--out", Path("nowhere/own.yaml")}),
            kFailed);
}

TEST_F(DetectVerb, SaysHowToTakeAVideo) {
  std::ofstream(folder_.path() / "dive.mp4") << "no image";
  ::testing::internal::CaptureStderr();
  EXPECT_EQ(Run({Path("dive.mp4"), "--out", Path("out.csv")}), kFailed);
  EXPECT_THAT(::testing::internal::GetCapturedStderr(), HasSubstr("ffmpeg -i "));
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>

#include "apps/limpet/cli.hpp"
#include "apps/limpet/command_line.hpp"
#include "limpet/vision/image_file.hpp"
#include "limpet/vision/scene_renderer.hpp"
#include "tests/support/fake_ffmpeg.hpp"
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
                            .seabed_depth = [](const Eigen::Vector2d&) { return 7.5; },
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
  /// As Run; what it says on stderr is in err_.
  int Said(const std::vector<std::string>& args) {
    testing::internal::CaptureStderr();
    const int code = Run(args);
    err_ = testing::internal::GetCapturedStderr();
    return code;
  }
  std::string TextIn(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(Path(name)).rdbuf();
    return text.str();
  }
  std::string Csv() const { return TextIn("out.csv"); }
  TemporaryFolder folder_;
  std::string err_;
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
  const std::vector<std::string> words{"--characterise", "--worlds",      "6", "--seed", "7",
                                       "--out",          Path("own.yaml")};
  ASSERT_EQ(Said(words), kOk) << err_;
  std::ostringstream sheet;
  sheet << std::ifstream(Path("own.yaml")).rdbuf();
  EXPECT_THAT(sheet.str(),
              HasSubstr("# Made by: limpet detect --characterise --detector "
                        "color_shape --colors yellow,orange,green --worlds 6 --seed 7\n"));
  EXPECT_THAT(sheet.str(), HasSubstr("DetectorFile = own.yaml\n")) << "as it is called";
  EXPECT_THAT(sheet.str(), HasSubstr("half_range_share: "));
  EXPECT_EQ(Said(words), kRefused) << "what is there stays";
  EXPECT_THAT(err_, HasSubstr("own.yaml: exists; --force writes over it"));
}

TEST_F(DetectVerb, WritesNoFileOfADetectorThatTooFewBallsWereMeasuredOn) {
  EXPECT_EQ(Said({"--characterise", "--worlds", "2", "--seed", "7", "--out", Path("own.yaml")}),
            kRefused);
  EXPECT_THAT(err_, HasSubstr("use more --worlds"));
  EXPECT_THAT(err_, HasSubstr("# found, by range over visibility")) << "what there is, by cell";
  EXPECT_FALSE(std::filesystem::exists(Path("own.yaml")));
}

TEST_F(DetectVerb, CharacterisesIntoAYamlAlone) {
  EXPECT_EQ(Said({"--characterise", "--worlds", "9000", "--out", Path("own.csv")}), kUsage);
  EXPECT_THAT(err_, HasSubstr("a detector's file is a .yaml"));
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

TEST_F(DetectVerb, WritesOverNoPictureThatItReads) {
  const std::string before = TextIn("ball.ppm");
  std::filesystem::create_hard_link(Path("ball.ppm"), Path("link.ppm"));
  for (const std::string table : {"ball.ppm", "./ball.ppm", "link.ppm"}) {
    EXPECT_EQ(Said({Path("ball.ppm"), "--out", Path(table)}), kUsage) << table;
    EXPECT_THAT(err_, HasSubstr("is an image that is read")) << table;
  }
  const Expected<Image> ball = ReadImage(Path("ball.ppm"));
  ASSERT_TRUE(ball);
  ASSERT_FALSE(WriteImage(Path("b.png"), *ball));
  const std::string png = TextIn("b.png");
  EXPECT_EQ(Said({Path("ball.ppm"), Path("b.png"), "--out", Path("out.csv"), "--draw",
                  folder_.path().string()}),
            kUsage);
  EXPECT_THAT(err_, HasSubstr("b.png is an image that is read"));
  EXPECT_EQ(TextIn("ball.ppm"), before);
  EXPECT_EQ(TextIn("b.png"), png);
  EXPECT_FALSE(std::filesystem::exists(Path("out.csv"))) << "nothing was begun";
  EXPECT_FALSE(std::filesystem::exists(Path("ball.png")));
}

TEST_F(DetectVerb, LooksAtTheDrawingsFolderBeforeItOpensTheTable) {
  std::ofstream(Path("drawn")) << "a file";
  EXPECT_EQ(Said({Path("ball.ppm"), "--out", Path("out.csv"), "--draw", Path("drawn")}), kRefused);
  EXPECT_FALSE(std::filesystem::exists(Path("out.csv")));
}

TEST_F(DetectVerb, SaysWhatOfAFolderItPassesOver) {
  std::filesystem::remove(Path("broken.png"));
  std::filesystem::rename(Path("ball.ppm"), Path("ball.pgm"));
  std::ofstream(Path("a.gif")) << "GIF89a";
  std::ofstream(Path("notes.txt")) << "a note";
  std::filesystem::create_directory(Path("dive2"));
  EXPECT_EQ(Said({folder_.path().string(), "--out", Path("out.csv")}), kOk);
  EXPECT_THAT(err_, HasSubstr("2 files passed over, no image that it reads: a.gif and others"));
  EXPECT_THAT(err_, HasSubstr("one folder in it passed over, give each by its name: dive2\n"));
  EXPECT_THAT(Csv(), HasSubstr("ball.pgm,yellow"));
}

TEST_F(DetectVerb, TakesNoHalfWorldsAndNoOptionThatDoesNothing) {
  for (const std::vector<std::string>& wrong :
       std::vector<std::vector<std::string>>{{"--characterise", "--worlds", "2.7"},
                                             {"--characterise", "--seed", "1.5"},
                                             {"--characterise", "--min-confidence", "0.5"},
                                             {"--characterise", "--draw", Path("drawn")},
                                             {Path("ball.ppm"), "--worlds", "3"},
                                             {Path("ball.ppm"), "--colors", "yellow"},
                                             {Path("ball.ppm"), "--seed", "3"},
                                             {Path("ball.ppm"), "--force"}}) {
    std::vector<std::string> words = wrong;
    words.insert(words.end(), {"--out", Path("out.csv")});
    EXPECT_EQ(Said(words), kUsage) << words[1];
    EXPECT_FALSE(std::filesystem::exists(Path("out.csv"))) << words[1];
  }
}

TEST_F(DetectVerb, NamesAPictureThatIsCutShort) {
  const Expected<Image> ball = ReadImage(Path("ball.ppm"));
  ASSERT_TRUE(ball);
  ASSERT_FALSE(WriteImage(Path("half.jpg"), *ball));
  std::filesystem::resize_file(Path("half.jpg"), std::filesystem::file_size(Path("half.jpg")) / 2);
  EXPECT_EQ(Said({Path("half.jpg"), Path("ball.ppm"), "--out", Path("out.csv")}), kFailed);
  EXPECT_THAT(err_, HasSubstr("half.jpg: the image is cut short"));
  EXPECT_THAT(Csv(), HasSubstr("ball.ppm,yellow"));
}

TEST_F(DetectVerb, SaysHowToTakeAVideo) {
  const FakeFfmpeg none(folder_.path());
  std::ofstream(folder_.path() / "dive.mp4") << "no image";
  EXPECT_EQ(Said({Path("dive.mp4"), "--out", Path("out.csv")}), kFailed);
  EXPECT_THAT(err_, HasSubstr("ffmpeg -i "));
  std::filesystem::remove(Path("broken.png"));
  std::filesystem::remove(Path("out.csv"));
  EXPECT_EQ(Said({folder_.path().string(), "--out", Path("out.csv")}), kOk);
  EXPECT_THAT(err_, HasSubstr("one file passed over, no image that it reads: dive.mp4; a video"));
}

TEST_F(DetectVerb, DetectsInEveryPictureOfAVideo) {
  const FakeFfmpeg ffmpeg(folder_.path());
  const std::string ball = "while IFS= read -r line; do :; done; exec /bin/cat " +
                           Path("ball.ppm") + " " + Path("ball.ppm");
  ffmpeg.Does(ball);
  std::filesystem::create_directory(Path("dives"));
  std::ofstream(Path("dives/clip.mp4")) << "a video";
  ASSERT_EQ(Said({Path("dives"), "--out", Path("out.csv"), "--draw", Path("drawn")}), kOk) << err_;
  EXPECT_THAT(Csv(), HasSubstr("dives/clip.mp4#000001,yellow,"));
  EXPECT_THAT(Csv(), HasSubstr("dives/clip.mp4#000002,yellow,"));
  EXPECT_TRUE(ReadImage(Path("drawn/clip_000001.png")));
  EXPECT_TRUE(ReadImage(Path("drawn/clip_000002.png")));
}

TEST_F(DetectVerb, KeepsWhatItFoundBeforeAVideoBrokeOff) {
  const FakeFfmpeg ffmpeg(folder_.path());
  ffmpeg.Does("/bin/cat " + Path("ball.ppm") + "; printf 'P6 640 480 255 abc'; exit 1");
  std::ofstream(Path("clip.mp4")) << "a video";
  EXPECT_EQ(Said({Path("clip.mp4"), Path("ball.ppm"), "--out", Path("out.csv")}), kFailed);
  EXPECT_THAT(err_, HasSubstr("clip.mp4: ffmpeg failed (exit code 1) in the midst of picture 2"));
  EXPECT_THAT(Csv(), HasSubstr("clip.mp4#000001,yellow,"));
  EXPECT_THAT(Csv(), HasSubstr("ball.ppm,yellow,")) << "the others are still done";
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/vision/cut_image.hpp"

#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include "limpet/vision/image_file.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

class CutImage : public ::testing::Test {
 protected:
  /// The bytes of a picture with something in it, as that kind of file.
  std::string BytesOf(const std::string& name) const {
    Image image{64, 48, std::vector<std::uint8_t>(std::size_t{64} * 48 * 3)};
    for (std::size_t i = 0; i < image.bgr.size(); ++i)
      image.bgr[i] = static_cast<std::uint8_t>((i * i) % 251);
    EXPECT_FALSE(WriteImage(Path(name), image));
    std::ifstream in(Path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  [[nodiscard]] std::filesystem::path Path(const std::string& name) const {
    return folder_.path() / name;
  }
  bool IsCut(const std::string& bytes, const std::string& name = "cut.jpg") const {
    std::ofstream(Path(name), std::ios::binary) << bytes;
    return IsCutShort(Path(name));
  }
  TemporaryFolder folder_;
};

TEST_F(CutImage, IsNamedWhereverItWasCut) {
  for (const std::string kind : {"whole.jpg", "whole.png"}) {
    const std::string whole = BytesOf(kind);
    EXPECT_FALSE(IsCut(whole)) << kind;
    for (std::size_t bytes = 8; bytes < whole.size(); ++bytes)
      ASSERT_TRUE(IsCut(whole.substr(0, bytes))) << kind << " of " << bytes << " bytes";
  }
}

TEST_F(CutImage, IsNoneWithMoreBehindItsEnd) {
  const std::string jpeg = BytesOf("whole.jpg"), png = BytesOf("whole.png");
  EXPECT_FALSE(IsCut(jpeg + std::string(70000, '\0'))) << "cameras fill up blocks";
  EXPECT_FALSE(IsCut(jpeg + jpeg.substr(0, 300))) << "and append a second picture";
  EXPECT_FALSE(IsCut(png + "more"));
}

/// The end of the small picture in a camera's Exif block is not the end of the picture.
TEST_F(CutImage, IsNotTakenForWholeByTheEndOfItsThumbnail) {
  const std::string jpeg = BytesOf("whole.jpg"), small = "Exif\xFF\xD8thumbnail\xFF\xD9";
  const std::string block =
      std::string("\xFF\xE1", 2) + '\0' + static_cast<char>(small.size() + 2) + small;
  const std::string with_thumbnail = jpeg.substr(0, 2) + block + jpeg.substr(2);
  EXPECT_FALSE(IsCut(with_thumbnail));
  EXPECT_TRUE(IsCut(with_thumbnail.substr(0, with_thumbnail.size() / 2)));
  EXPECT_TRUE(ReadImage(Path("whole.jpg")));
}

TEST_F(CutImage, OnlyJpegAndPngAreLookedAt) {
  EXPECT_FALSE(IsCut("P6 640 480 255\nhalf"));
  EXPECT_FALSE(IsCut(""));
  EXPECT_FALSE(IsCutShort(Path("none.jpg")));
}

}  // namespace
}  // namespace limpet

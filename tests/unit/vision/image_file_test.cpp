// SPDX-License-Identifier: MIT
#include "limpet/vision/image_file.hpp"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

using ::testing::HasSubstr;

TEST(ImageFile, ThatIsCutShortIsNoPictureAndItsNameIsSaid) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "half.jpg";
  const Image image{64, 48, std::vector<std::uint8_t>(std::size_t{64} * 48 * 3, 90)};
  ASSERT_FALSE(WriteImage(file, image));
  ASSERT_TRUE(ReadImage(file));
  std::filesystem::resize_file(file, std::filesystem::file_size(file) * 2 / 3);
  const Expected<Image> half = ReadImage(file);
  ASSERT_FALSE(half);
  EXPECT_THAT(half.error().text, HasSubstr("half.jpg: the image is cut short"));
}

TEST(ImageFile, ThatSaysItIsHugeIsSaidToBeInWords) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "huge.ppm";
  std::ofstream(file) << "P6 200000 200000 255\nabc";
  const Expected<Image> huge = ReadImage(file);
  ASSERT_FALSE(huge);
  EXPECT_THAT(huge.error().text, HasSubstr("huge.ppm: more pixels than an image may have"));
}

}  // namespace
}  // namespace limpet

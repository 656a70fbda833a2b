// SPDX-License-Identifier: MIT
#include "tests/support/matlab_matrices.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/smoothing/set_file_fixture.hpp"

namespace limpet {
namespace {

using ::testing::HasSubstr;

using MatlabMatricesTest = SetFileTest;

/// A MATLAB 5 file with one matrix [1 3; 2 4] named m.
std::string MatlabFile() {
  const auto word = [](std::uint32_t value) {
    return std::string(reinterpret_cast<const char*>(&value), 4);
  };
  std::string content = word(6) + word(8) + word(6) + word(0);  // flags: doubles
  content += word(5) + word(8) + word(2) + word(2);             // two by two
  content += word((1U << 16U) | 1U) + "m" + std::string(3, '\0');
  content += word(9) + word(32);
  for (const double value : {1.0, 2.0, 3.0, 4.0})
    content += std::string(reinterpret_cast<const char*>(&value), 8);
  return std::string(128, ' ') + word(14) + word(static_cast<std::uint32_t>(content.size())) +
         content;
}

TEST_F(MatlabMatricesTest, AMatlabMatrixIsReadByColumns) {
  const auto matrices = ReadMatlabMatrices(Write("a.mat", MatlabFile()));
  ASSERT_TRUE(matrices) << matrices.error().text;
  const Eigen::Matrix2d expected = (Eigen::Matrix2d() << 1.0, 3.0, 2.0, 4.0).finished();
  EXPECT_EQ(matrices->at("m"), expected);
}
TEST_F(MatlabMatricesTest, AMatlabFileThatIsCutShortIsAnErrorWithItsPlace) {
  const std::string whole = MatlabFile();
  for (std::size_t size = 129; size < whole.size(); ++size) {
    const auto matrices = ReadMatlabMatrices(Write("a.mat", whole.substr(0, size)));
    ASSERT_FALSE(matrices) << size;
    EXPECT_THAT(matrices.error().text, HasSubstr("damaged at byte 128"));
  }
  EXPECT_FALSE(ReadMatlabMatrices(Write("a.mat", "short")));
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/detectors/network_description.hpp"

#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/core/config.hpp"
#include "limpet/detectors/network_detector.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

using testing::HasSubstr;

constexpr const char* kSound =
    "weights: some.onnx\n"
    "colors: [yellow, orange]\n"
    "stride_px: 8\n"
    "size_unit_px: 32\n"
    "input_pixels: 76800\n"
    "confidence_offset: -0.5\n"
    "confidence_per_score: 1.5\n"
    "confidence_per_color: 0.25\n"
    "confidence_per_roundness: 1\n";

class ADescribedNetwork : public testing::Test {
 protected:
  std::filesystem::path Write(const std::string& text) {
    std::ofstream(folder_.path() / "some.onnx") << "no network";
    std::ofstream(folder_.path() / "some.yaml") << text;
    return folder_.path() / "some.yaml";
  }
  std::string ComplaintAbout(const std::string& text) {
    try {
      static_cast<void>(NetworkDescription::Read(Write(text)));
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "none";
  }
  static std::string Without(const std::string& line) {
    std::string text = kSound;
    return text.erase(text.find(line), text.find('\n', text.find(line)) + 1 - text.find(line));
  }
  TemporaryFolder folder_;
};

TEST_F(ADescribedNetwork, IsReadAsWritten) {
  const NetworkDescription read = NetworkDescription::Read(Write(kSound));
  EXPECT_EQ(read.weights, folder_.path() / "some.onnx");
  EXPECT_THAT(read.colors, testing::ElementsAre("yellow", "orange"));
  EXPECT_EQ(read.confidence_per_score, 1.5);
}

TEST_F(ADescribedNetwork, SaysAllOfItsWitnessesOrNothing) {
  EXPECT_FALSE(NetworkDescription::Read(Write(kSound)).witnesses.has_value());
  const std::string started = std::string(kSound) + "witnesses_offset: -2\n";
  EXPECT_THAT(ComplaintAbout(started), HasSubstr("witnesses_per_score: is missing"));
  const std::string all = started +
                          "witnesses_per_score: 1\nwitnesses_per_color: 0.5\n"
                          "witnesses_per_roundness: 2\nwitnesses_shape_found: -0.5\n"
                          "witnesses_per_shape: 0.25\n";
  const NetworkDescription read = NetworkDescription::Read(Write(all));
  ASSERT_TRUE(read.witnesses.has_value());
  EXPECT_EQ(read.witnesses->offset, -2.0);
  EXPECT_EQ(read.witnesses->shape_found, -0.5);
  EXPECT_EQ(read.witnesses->per_shape, 0.25);
}

TEST_F(ADescribedNetwork, NamesFileLineAndKeyOfASlip) {
  const std::string text = std::string(kSound) + "confidence_per_scor: 1\n";
  const std::string complaint = ComplaintAbout(text);
  EXPECT_THAT(complaint, HasSubstr("some.yaml:10"));
  EXPECT_THAT(complaint, HasSubstr("did you mean `confidence_per_score`?"));
  EXPECT_THAT(ComplaintAbout(Without("stride_px")), HasSubstr("stride_px"));
  EXPECT_THAT(ComplaintAbout(Without("stride_px") + "stride_px: 0\n"), HasSubstr("from 1 to 64"));
  EXPECT_THAT(ComplaintAbout(Without("stride_px") + "stride_px: [1\n"), HasSubstr("some.yaml"));
  EXPECT_THAT(ComplaintAbout(Without("colors") + "colors: [yelow]\n"),
              HasSubstr("did you mean `yellow`?"));
  EXPECT_THAT(ComplaintAbout(Without("weights") + "weights: other.onnx\n"),
              HasSubstr("other.onnx"));
  EXPECT_THAT(ComplaintAbout("- a list\n"), HasSubstr("key: value"));
}

TEST_F(ADescribedNetwork, IsRefusedWhereItsWeightsAreNone) {
  NetworkDetector::Params params;
  params.network = Write(kSound).string();
  try {
    const NetworkDetector detector(params);
    FAIL() << "no complaint";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("some.onnx"));
    EXPECT_THAT(error.what(), HasSubstr("OpenCV"));
  }
}

TEST_F(ADescribedNetwork, IsRefusedWhereItHasOtherColorsThanItsWeights) {
  NetworkDescription shipped = NetworkDescription::Read(FindNetwork("balls.yaml"));
  std::filesystem::copy_file(shipped.weights, folder_.path() / "balls.onnx");
  NetworkDetector::Params params;
  params.network =
      Write(Without("weights") + "weights: balls.onnx\n").string();  // of two colours, not eight
  try {
    const NetworkDetector detector(params);
    FAIL() << "no complaint";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("one per colour (2)"));
  }
}

TEST_F(ADescribedNetwork, ThatIsNowhereIsSaidToBeNowhere) {
  NetworkDetector::Params params;
  params.network = "no_such.yaml";
  try {
    const NetworkDetector detector(params);
    FAIL() << "no complaint";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("`no_such.yaml` is not found"));
    EXPECT_THAT(error.what(), HasSubstr("share/networks"));
  }
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "estimation/replay/sensor_stream.hpp"

#include <fstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// zlib reads plain text as it is, so the tests need not compress.
class SensorStreamTest : public ::testing::Test {
 protected:
  Expected<SensorStream> Load(const std::string& rows) {
    std::ofstream(folder_.path() / "meta.csv") << "key,v1,v2\nimage_size,640,360\nopi_radius,0.4\n";
    std::ofstream(folder_.path() / "stream.csv.gz") << rows;
    return LoadSensorStream(folder_.path());
  }
  TemporaryFolder folder_;
};

TEST_F(SensorStreamTest, ReadsEveryKindOfRow) {
  const auto stream = Load(
      "# a comment\nATT,0.0,0.1,0.2,0.3,0.01,0.01,0.02\n"
      "DVL,0.1,1,0.5,0.0,0.1,0.01,0.005,4.0,4.4,4.4,4.4,4.4\nDEP,0.1,3.5,0.02\n"
      "GPS,0.2,1.0,2.0,0.5\nFRM,0.3,0.5,7,1\nDET,0.3,0.5,7,0,300,200,80,80,0.9,1\n");
  ASSERT_TRUE(stream.has_value());
  EXPECT_EQ(stream->rows.size(), 5U);
  EXPECT_EQ(stream->meta.camera.height_px, 360.0);
  EXPECT_EQ(stream->meta.opi_radius, 0.4);
  EXPECT_EQ(std::get<FrameRow>(stream->rows.back()).frame.boxes.front().color, "1");
}

TEST(StreamMetaText, WhatItDoesNotSayOfTheVehicleIsNamed) {
  const auto meta = ParseStreamMeta({.name = "meta.csv",
                                     .lines = {"key,v1", "cam_pos_body,0,0,0", "opi_radius,1"},
                                     .damage = {}});
  ASSERT_TRUE(meta.has_value());
  EXPECT_THAT(meta->unsaid, ElementsAre("cam_R_body_from_cam", "dvl_pos_body"));
}

TEST(StreamMetaText, ALensThatFoldsTheImageIsRefused) {
  const auto meta_of = [](const char* line) {
    return ParseStreamMeta({.name = "meta.csv", .lines = {"key,v1", line}, .damage = {}});
  };
  const auto mild = meta_of("distortion_k1_k2_p1_p2_k3,-0.2,0.04,0.001,0.002,0");
  ASSERT_TRUE(mild.has_value());
  EXPECT_EQ(mild->distortion.k2, 0.04);
  const auto folded = meta_of("distortion_k1_k2_p1_p2_k3,-0.9,0,0,0,0");
  ASSERT_FALSE(folded.has_value());
  EXPECT_THAT(folded.error().text, HasSubstr("meta.csv: distortion_k1_k2_p1_p2_k3: folds"));
}

TEST_F(SensorStreamTest, ReadsADvlRowWithoutLock) {
  const auto stream = Load("DVL,0.1,0,,,,,,,,,,\n");
  ASSERT_TRUE(stream.has_value());
  EXPECT_FALSE(std::get<DvlRow>(stream->rows.front()).v_WD_B.has_value());
}

TEST_F(SensorStreamTest, NamesTheLineThatHasAWordWhereANumberBelongs) {
  const auto stream = Load("DEP,0.1,3.5,0.02\nDEP,0.2,deep,0.02\n");
  ASSERT_FALSE(stream.has_value());
  EXPECT_THAT(stream.error().text, HasSubstr("stream.csv.gz:2: column 3 of DEP is `deep`"));
}

TEST_F(SensorStreamTest, PassesOverADamagedLineOfManyAndSaysSo) {
  std::string text;
  for (int i = 0; i < 300; ++i) {
    text += fmt::format("DEP,{:.1f},3.5,0.02\n", 0.1 * i);
    if (i == 100) text += "D\x80L,xx,1\nFRM,0.3,0.5,7,2\nDET,0.3,0.5,7,0,9,9,8,8,0.9,1\n";
  }
  const auto stream = Load(text);
  ASSERT_TRUE(stream.has_value()) << stream.error().text;
  EXPECT_EQ(stream->rows.size(), 300U) << "a frame that lacks a box is none";
  EXPECT_THAT(stream->left_out, ElementsAre(HasSubstr("stream.csv.gz:102:")));
  EXPECT_THAT(stream->left_out.front(), HasSubstr("2 lines passed over"));
  EXPECT_FALSE(stream->cut.has_value());
}

TEST_F(SensorStreamTest, PassesOverAFrameWhoseLineIsDamagedAndItsBoxes) {
  std::string text;
  for (int i = 0; i < 600; ++i) {
    text += fmt::format("DEP,{:.1f},3.5,0.02\n", 0.1 * i);
    if (i == 100) text += "FRM,\"0.3,0.5,7,1\nDET,0.3,0.5,7,0,9,9,8,8,0.9,1\n";
  }
  const auto stream = Load(text);
  ASSERT_TRUE(stream.has_value()) << stream.error().text;
  EXPECT_EQ(stream->rows.size(), 600U);
  EXPECT_THAT(stream->left_out, ElementsAre(HasSubstr("2 lines passed over")));
}

TEST_F(SensorStreamTest, NamesTheLineWithTooFewColumns) {
  const auto stream = Load("ATT,0.0,0.1\n");
  ASSERT_FALSE(stream.has_value());
  EXPECT_THAT(stream.error().text, HasSubstr(":1: ATT has 3 columns, not 8"));
}

TEST_F(SensorStreamTest, MissesTheBoxesThatAFrameAnnounced) {
  const auto stream = Load("FRM,0.3,0.5,7,2\nDET,0.3,0.5,7,0,300,200,80,80,0.9,1\nDEP,1,2,0.1\n");
  ASSERT_FALSE(stream.has_value());
  EXPECT_THAT(stream.error().text, HasSubstr(":3: a DET of the frame before is missing"));
}

TEST_F(SensorStreamTest, AFrameThatTheEndCutsInTwoIsLeftOutAndSaid) {
  const auto stream = Load("DEP,0.1,3.5,0.02\nFRM,0.3,0.5,7,2\nDET,0.3,0.5,7,0,9,9,8,8,0.9,1\n");
  ASSERT_TRUE(stream.has_value());
  EXPECT_EQ(stream->rows.size(), 1U);
  EXPECT_THAT(stream->cut.value_or(""), HasSubstr("stream.csv.gz: the last frame's DET rows"));
}

TEST_F(SensorStreamTest, ALastLineCutInTwoIsLeftOutAndSaid) {
  const auto stream = Load("DEP,0.1,3.5,0.02\nDEP,0.3,3.");
  ASSERT_TRUE(stream.has_value());
  EXPECT_EQ(stream->rows.size(), 1U);
  EXPECT_THAT(stream->cut.value_or(""), HasSubstr("stream.csv.gz:2: DEP has 3 columns, not 4"));
}

TEST_F(SensorStreamTest, AWholeStreamIsNotCut) {
  const auto stream = Load("DEP,0.1,3.5,0.02\nDEP,0.3,3.5,0.02");
  ASSERT_TRUE(stream.has_value());
  EXPECT_EQ(stream->rows.size(), 2U);
  EXPECT_FALSE(stream->cut.has_value());
}

TEST_F(SensorStreamTest, ReadsWhatTheRowsStateOfTheirNoise) {
  const auto stream = Load(
      "ATT,0.0,0.1,0.2,0.3,0.01,0.03,0.02\nDEP,0.1,3.5,0.02\nDEP,0.2,3.5,0.2\n"
      "DEP,0.3,3.5,0.2\nDVL,0.4,0,,,,,,,,,,\n");
  ASSERT_TRUE(stream.has_value());
  EXPECT_EQ(stream->meta.noise.tilt, 0.03);
  EXPECT_EQ(stream->meta.noise.depth, 0.2);
  EXPECT_EQ(stream->meta.noise.velocity, StatedNoise{}.velocity);
}

TEST_F(SensorStreamTest, CountsRowsThatHoldNoNumberAndGoesOn) {
  const auto stream = Load("DEP,0.1,nan,0.02\nDEP,0.2,3.5,0.02\n");
  ASSERT_TRUE(stream.has_value());
  EXPECT_EQ(stream->refused_rows, 1);
  EXPECT_EQ(stream->rows.size(), 1U);
}

TEST_F(SensorStreamTest, SaysWhichFileCannotBeOpened) {
  const auto stream = LoadSensorStream(folder_.path() / "absent");
  ASSERT_FALSE(stream.has_value());
  EXPECT_THAT(stream.error().text, HasSubstr("meta.csv: cannot be opened"));
}

TEST_F(SensorStreamTest, UsesWhatIsSoundOfAFileCutShortAndSaysWhatIsNot) {
  const std::filesystem::path file = folder_.path() / "stream.csv.gz";
  std::ofstream(folder_.path() / "meta.csv") << "key,v1\nopi_radius,0.4\n";
  gzFile packed = gzopen(file.c_str(), "wb");
  for (int i = 0; i < 2000; ++i) {
    const std::string line = "DEP," + std::to_string(0.1 * i) + ",3.5,0.02\n";
    ASSERT_GT(gzwrite(packed, line.data(), static_cast<unsigned>(line.size())), 0);
  }
  ASSERT_EQ(gzclose(packed), Z_OK);
  std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
  const auto stream = LoadSensorStream(folder_.path());
  ASSERT_TRUE(stream.has_value());
  EXPECT_GT(stream->rows.size(), 100U);
  EXPECT_LT(stream->rows.size(), 2000U);
  EXPECT_THAT(stream->cut.value_or(""), HasSubstr("cut short"));
}

TEST_F(SensorStreamTest, OfAFileWithFlippedBytesReadsWhatComesBeforeThem) {
  const std::filesystem::path file = folder_.path() / "stream.csv.gz";
  std::string text;
  for (int i = 0; i < 20000; ++i) {
    text += "DEP," + std::to_string(0.1 * i) + "," + std::to_string(0.37 * (i * 7919 % 1000)) +
            ",0.02\n";
  }
  static_cast<void>(Load(text));
  std::fstream bytes(file, std::ios::in | std::ios::out | std::ios::binary);
  bytes.seekp(static_cast<std::streamoff>(std::filesystem::file_size(file) / 2));
  bytes << "\x5a\xa5\x5a\xa5";
  bytes.close();
  const auto stream = LoadSensorStream(folder_.path());
  ASSERT_TRUE(stream.has_value()) << stream.error().text;
  EXPECT_GT(stream->rows.size(), 5000U);
  EXPECT_TRUE(stream->cut || !stream->left_out.empty());
}

TEST_F(SensorStreamTest, ReadsFurtherSensorsInOrderOfTime) {
  std::ofstream(folder_.path() / "sources.csv") << "t,variable,value\n2,USBL_FIX,north=1,east=2\n1."
                                                   "5,BEACON_RANGE,31.25\nnan,BEACON_RANGE,1\n";
  const auto stream = Load("DEP,0.1,3.5,0.02\n");
  ASSERT_TRUE(stream.has_value());
  ASSERT_EQ(stream->source_rows.size(), 2U);
  EXPECT_EQ(stream->source_rows[0].variable, "BEACON_RANGE");
  EXPECT_EQ(stream->source_rows[0].value, Value(31.25));
  EXPECT_EQ(stream->source_rows[1].value, Value("north=1,east=2"));
  EXPECT_EQ(stream->refused_rows, 1);
}

TEST_F(SensorStreamTest, ReadsFurtherSensorsInQuotes) {
  std::ofstream(folder_.path() / "sources.csv")
      << "\"t\",\"variable\",\"value\"\n\"2\",\"USBL_FIX\",\"north=1,east=2\"\r\n"
         "3,\"BEACON_RANGE\", \"31.25\"\n4,NOTE,\"a \"\"b\"\"\"\n5,NOTE,c=\"d\",e\n";
  const auto stream = Load("DEP,0.1,3.5,0.02\n");
  ASSERT_TRUE(stream.has_value()) << stream.error().text;
  ASSERT_EQ(stream->source_rows.size(), 4U);
  EXPECT_EQ(stream->source_rows[0].variable, "USBL_FIX");
  EXPECT_EQ(stream->source_rows[0].value, Value("north=1,east=2"));
  EXPECT_EQ(stream->source_rows[1].value, Value(31.25));
  EXPECT_EQ(stream->source_rows[2].value, Value("a \"b\""));
  EXPECT_EQ(stream->source_rows[3].value, Value("c=\"d\",e"));
}

TEST_F(SensorStreamTest, QuotesThatDoNotEndAreAnError) {
  for (const char* line : {"1,NOTE,\"a", "1,\"NOTE,a", "1,NOTE,\"a\"b"}) {
    std::ofstream(folder_.path() / "sources.csv") << line << "\n";
    const auto stream = Load("DEP,0.1,3.5,0.02\n");
    ASSERT_FALSE(stream.has_value()) << line;
    EXPECT_THAT(stream.error().text, HasSubstr("sources.csv:1: "));
    EXPECT_THAT(stream.error().text, HasSubstr("quotes"));
  }
}

/// Two seconds, a frame with two boxes in each.
std::vector<std::string> TwoSeconds() {
  std::vector<std::string> lines;
  for (int i = 0; i < 20; ++i) {
    lines.push_back(fmt::format("ATT,{:.1f},0,0,0,0.005,0.005,0.02\n", 0.1 * i));
    lines.push_back(fmt::format("DVL,{:.1f},0,,,,,,,,,,\n", 0.1 * i));
    if (i % 10 != 0) continue;
    lines.push_back(fmt::format("FRM,{0:.1f},{0:.1f},{1},2\n", 0.1 * i, i));
    for (int box = 0; box < 2; ++box) {
      lines.push_back(
          fmt::format("DET,{0:.1f},{0:.1f},{1},{2},300,200,80,80,0.9,1\n", 0.1 * i, i, box));
    }
  }
  return lines;
}

TEST_F(SensorStreamTest, LinesThatAreWrittenTwiceCountOnceAndAreSaid) {
  std::string once, twice;
  for (const std::string& line : TwoSeconds()) {
    once += line;
    twice += line + line;
  }
  const auto stream = Load(twice);
  ASSERT_TRUE(stream.has_value()) << stream.error().text;
  EXPECT_EQ(stream->rows.size(), Load(once)->rows.size());
  EXPECT_THAT(stream->left_out,
              ElementsAre(HasSubstr("stream.csv.gz:2: came before, word for word; 46 such lines")));
  EXPECT_EQ(std::get<FrameRow>(stream->rows[2]).frame.boxes.size(), 2U);
}

TEST_F(SensorStreamTest, SecondsThatAreWrittenTwiceCountOnceAndNoClockWasSet) {
  const std::vector<std::string> lines = TwoSeconds();
  std::string text;
  for (const std::string& line : lines)
    text += line;
  for (std::size_t i = 23; i < lines.size(); ++i)  // the last second again
    text += lines[i];
  const auto stream = Load(text + "DEP,2.0,3.5,0.02\n");
  ASSERT_TRUE(stream.has_value()) << stream.error().text;
  EXPECT_EQ(stream->rows.size(), 43U);
  EXPECT_THAT(stream->left_out, ElementsAre(HasSubstr("23 such lines were dropped")));
}

TEST_F(SensorStreamTest, NamesTheLineOfAFurtherSensorItCannotRead) {
  std::ofstream(folder_.path() / "sources.csv") << "1,BEACON_RANGE,3\n2,BEACON_RANGE\n";
  const auto stream = Load("DEP,0.1,3.5,0.02\n");
  ASSERT_FALSE(stream.has_value());
  EXPECT_THAT(stream.error().text, HasSubstr("sources.csv:2: "));
}

}  // namespace
}  // namespace limpet

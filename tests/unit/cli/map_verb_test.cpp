// SPDX-License-Identifier: MIT
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "apps/limpet/cli.hpp"
#include "apps/limpet/command_line.hpp"
#include "estimation/mapping/semantic_octree.hpp"
#include "limpet/durable/durable_file.hpp"
#include "limpet/packing/gzip_bytes.hpp"
#include "limpet/session/session_memory.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/cli/change_sessions.hpp"

namespace limpet {
namespace {

using ::testing::HasSubstr;

class MapVerbTest : public ::testing::Test {
 protected:
  void Save(const std::string& map) const {
    SessionMemory memory;
    if (!map.empty()) memory.map["map.ot"] = map;
    OpiBelief opi;
    opi.id = 12;
    opi.object.cov_W = Eigen::Matrix3d::Identity();
    opi.object.color = "yellow";
    memory.objects.opis.push_back(opi);
    for (int i = 0; i < 3; ++i)
      memory.frames.push_back({.frame = i, .exposure = Seconds(i), .X_WB = {}});
    ASSERT_TRUE(SessionWriter(folder_.path() / "session").Commit({}, FilesOf(memory)).has_value());
  }
  static std::string OneVoxel() {
    SemanticOctree octree;
    octree.Set({1.1, 2.1, 3.1}, {.occupied = 0.85F});
    return octree.Serialize();
  }
  int Run(std::vector<std::string> words) {
    ::testing::internal::CaptureStdout();
    ::testing::internal::CaptureStderr();
    words.insert(words.begin(), "map");
    const int code = RunCommandLine(words);
    out_ = ::testing::internal::GetCapturedStdout();
    err_ = ::testing::internal::GetCapturedStderr();
    return code;
  }
  TemporaryFolder folder_;
  std::string session_ = folder_.path().string();
  std::string scene_ = (folder_.path() / "map.3Dscene").string();
  std::string out_, err_;
};

TEST_F(MapVerbTest, WritesASavedSessionsMapAsAScene) {
  Save(OneVoxel());
  ASSERT_EQ(Run({"export", session_, "--3dscene", scene_}), kOk);
  EXPECT_THAT(out_, HasSubstr("map.3Dscene: 1 objects, path of 3 poses\n"));
  const auto read = ReadUnpacked(scene_, 1U << 20U);
  ASSERT_TRUE(read.has_value());
  for (const char* part : {"COpenGLScene", "COctoMapVoxels", "object 12", "CSetOfLines"})
    EXPECT_THAT(read->bytes, HasSubstr(part));
}

TEST_F(MapVerbTest, SaysThatASessionKeptNoVoxels) {
  Save("");
  EXPECT_EQ(Run({"export", session_, "--3dscene", scene_}), kOk);
  EXPECT_THAT(out_, HasSubstr("the session kept no voxels"));
}

TEST_F(MapVerbTest, NamesTheMapThatIsDamaged) {
  Save("# Octomap OcTree file\nid SemanticOcTree\n");
  EXPECT_NE(Run({"export", session_, "--3dscene", scene_}), kOk);
  EXPECT_THAT(err_, HasSubstr("map.ot: "));
  EXPECT_FALSE(std::filesystem::exists(scene_));
}

TEST_F(MapVerbTest, WritesOverNothingUnlessForced) {
  Save(OneVoxel());
  ASSERT_EQ(Run({"export", session_, "--3dscene", scene_}), kOk);
  EXPECT_EQ(Run({"export", session_, "--3dscene", scene_}), kRefused);
  EXPECT_EQ(Run({"export", session_, "--3dscene", scene_, "--force"}), kOk);
}

TEST_F(MapVerbTest, WritesIntoAFileThatHasANameOfItsOwn) {
  Save(OneVoxel());
  EXPECT_EQ(Run({"export", session_, "--format", "csv", "--out", "-"}), kRefused);
  EXPECT_THAT(err_, HasSubstr("-: is no name for a file"));
  EXPECT_FALSE(std::filesystem::exists("-"));
  EXPECT_EQ(Run({"export", session_, "--format", "csv", "--out", session_, "--force"}), kRefused);
  EXPECT_THAT(err_, HasSubstr("is a folder, not a file"));
}

TEST_F(MapVerbTest, ComplainsOfWhatIsNoSessionAndNoCommand) {
  EXPECT_NE(Run({"export", session_, "--3dscene", scene_}), kOk);
  EXPECT_THAT(err_, HasSubstr("no complete session here"));
  EXPECT_EQ(Run({"exprot", session_}), kUsage);
  EXPECT_THAT(err_, HasSubstr("did you mean `export`?"));
  EXPECT_EQ(Run({"--help"}), kOk);
}

TEST_F(MapVerbTest, WritesEveryFormatThatItNames) {
  Save(OneVoxel());
  const auto out = [this](const std::string& name) { return (folder_.path() / name).string(); };
  for (const std::string format : {"ot", "ply", "csv", "asc"}) {
    ASSERT_EQ(Run({"export", session_, "--format", format, "--out", out("map." + format)}), kOk)
        << err_;
    EXPECT_TRUE(std::filesystem::exists(out("map." + format)));
  }
  EXPECT_THAT(*ReadWhole(out("map.asc")), HasSubstr("ncols 1\n"));
  EXPECT_THAT(*ReadWhole(out("map_sigma.asc")), HasSubstr("0.058"));
  EXPECT_THAT(*ReadWhole(out("map.csv")), HasSubstr("\n12,yellow,"));
}

TEST_F(MapVerbTest, TellsWhatTheFileHoldsThatItWrote) {
  Save(OneVoxel());
  const auto told = [this](const std::string& format) {
    const std::string file = (folder_.path() / ("held." + format)).string();
    EXPECT_EQ(Run({"export", session_, "--format", format, "--out", file}), kOk) << err_;
    return out_;
  };
  EXPECT_THAT(told("ot"), HasSubstr("held.ot: 1 voxels of 0.2 m\n"));
  EXPECT_THAT(told("ply"), HasSubstr("held.ply: 1 voxels of 0.2 m\n"));
  EXPECT_THAT(told("csv"), HasSubstr("held.csv: 1 objects\n"));
  EXPECT_THAT(told("asc"), HasSubstr("held.asc: 1 x 1 cells of 0.2 m, 1 of them with a depth\n"));
}

TEST_F(MapVerbTest, OctovisReadsItsColourOctree) {
  Save(OneVoxel());
  const std::string file = (folder_.path() / "map.ot").string();
  ASSERT_EQ(Run({"export", session_, "--format", "ot", "--out", file}), kOk);
  EXPECT_THAT(*ReadWhole(file), HasSubstr("id ColorOcTree"));
}

TEST_F(MapVerbTest, WithoutADatumNothingIsPutOnEarth) {
  Save(OneVoxel());
  const std::string file = (folder_.path() / "o.geojson").string();
  EXPECT_EQ(Run({"export", session_, "--format", "geojson", "--out", file}), kRefused);
  EXPECT_THAT(err_, HasSubstr("LatOrigin"));
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST_F(MapVerbTest, NamesTheNearestFormat) {
  Save(OneVoxel());
  EXPECT_EQ(Run({"export", session_, "--format", "geojsn", "--out", scene_}), kUsage);
  EXPECT_THAT(err_, HasSubstr("did you mean `geojson`?"));
  EXPECT_EQ(Run({"export", session_, "--format", "csv"}), kUsage);
  EXPECT_EQ(Run({"export", session_}), kUsage);
}

TEST_F(MapVerbTest, SaysWhatASessionsMapHolds) {
  Save(OneVoxel());
  ASSERT_EQ(Run({"info", session_, "--json"}), kOk) << err_;
  EXPECT_THAT(out_, HasSubstr("\"occupied_voxels\": 1"));
  EXPECT_THAT(out_, HasSubstr("\"frames\": 3"));
  EXPECT_THAT(out_, HasSubstr("\"datum\": null"));
  ASSERT_EQ(Run({"info", session_}), kOk);
  EXPECT_THAT(out_, HasSubstr("1 occupied, 0 of objects"));
  EXPECT_THAT(out_, HasSubstr("  12 yellow"));
}

/// The grid of `map export --format asc` has both in its sigma.
TEST_F(MapVerbTest, InfoSaysByHowMuchAllDepthsMayBeOffTogether) {
  SessionMemory memory;
  memory.depths =
      "cell_m=0.2,zero_sigma_m=0.07\nnorth,east,beams,down_mm,square_mm2\n"
      "5,0,1,8030,64480900\n6,0,1,8050,64802500\n";
  ASSERT_TRUE(SessionWriter(folder_.path() / "session").Commit({}, FilesOf(memory)).has_value());
  ASSERT_EQ(Run({"info", session_, "--json"}), kOk) << err_;
  EXPECT_THAT(out_, HasSubstr("\"zero_sigma_m\": 0.07"));
  ASSERT_EQ(Run({"info", session_}), kOk);
  EXPECT_THAT(out_, HasSubstr("off together: the depth sensor's zero, sd 0.07 m"));
}

TEST_F(MapVerbTest, InfoNamesWhatIsDamaged) {
  Save("# Octomap OcTree file\nid SemanticOcTree\n");
  EXPECT_EQ(Run({"info", session_}), kFailed);
  EXPECT_THAT(err_, HasSubstr("map.ot: "));
}

TEST_F(MapVerbTest, DiffNeedsTwoSessions) {
  Save(OneVoxel());
  EXPECT_EQ(Run({"diff", session_}), kUsage);
  EXPECT_NE(Run({"diff", session_, (folder_.path() / "none").string()}), kOk);
  EXPECT_THAT(err_, HasSubstr("session B"));
}

class MapDiffOfSessions : public ChangeVerbTest {
 protected:
  std::string Diff(const std::vector<std::string>& options) {
    std::vector<std::string> words{"map", "diff", (folder_.path() / "discovery").string(),
                                   (folder_.path() / "second").string()};
    words.insert(words.end(), options.begin(), options.end());
    ::testing::internal::CaptureStdout();
    EXPECT_EQ(RunCommandLine(words), kOk);
    return ::testing::internal::GetCapturedStdout();
  }
};

TEST_F(MapDiffOfSessions, SaysThatNothingCouldBeComparedWhereNoColumnIsInBoth) {
  FlySession("discovery", {kStays}, {1.0});
  FlySession("second", {kStays}, {1.0});
  EXPECT_THAT(Diff({}), HasSubstr("no column of the seabed is in both (0 in A, 0 in B)"));
  const nlohmann::json depth = nlohmann::json::parse(Diff({"--json"})).at("depth");
  EXPECT_EQ(depth.at("cells"), 0);
  for (const char* key : {"offset_m", "offset_sd_m", "rms_m", "sigma_scale"})
    EXPECT_TRUE(depth.at(key).is_null()) << key;
}

}  // namespace
}  // namespace limpet

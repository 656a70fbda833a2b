// SPDX-License-Identifier: MIT
#include <fstream>
#include <iterator>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/limpet/cli.hpp"
#include "apps/limpet/command_line.hpp"
#include "limpet/core/config.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

using ::testing::HasSubstr;

class PlugVerbTest : public ::testing::Test {
 protected:
  PlugVerbTest() {
    std::filesystem::create_directories(folder_.path() / "lib");
    std::ofstream(folder_.path() / "lib/plug_port.moos") << "ServerPort = $(PORT)\n";
    std::ofstream(in_) << "#include plug_port.moos\n#ifdef SIM\nSim = %(SIM=on)\n#endif\n";
  }
  int Run(std::vector<std::string> options) {
    std::vector<std::string> words{in_.string(), out_.string()};
    words.insert(words.end(), options.begin(), options.end());
    ::testing::internal::CaptureStdout();
    ::testing::internal::CaptureStderr();
    const auto end_capture = [this] {
      printed_ = ::testing::internal::GetCapturedStdout();
      complaints_ = ::testing::internal::GetCapturedStderr();
    };
    words.insert(words.begin(), "plug");
    const int code = RunCommandLine(words);
    end_capture();
    return code;
  }
  [[nodiscard]] std::string Result() const {
    std::ifstream in(out_);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  }

  TemporaryFolder folder_;
  std::filesystem::path in_ = folder_.path() / "meta.moos";
  std::filesystem::path out_ = folder_.path() / "targ.moos";
  std::string path_ = "--path=" + (folder_.path() / "lib").string();
  std::string printed_;
  std::string complaints_;
};

TEST_F(PlugVerbTest, ExpandsAsNsplugDoes) {
  EXPECT_EQ(Run({path_, "PORT=9001", "SIM=yes"}), kOk);
  EXPECT_EQ(Result(), "ServerPort = 9001\n\nSim = YES\n\n");
  EXPECT_THAT(printed_, HasSubstr("4 lines")) << "a line about success";
}

TEST_F(PlugVerbTest, IsSilentWhenForced) {
  EXPECT_EQ(Run({"-f", "-p", (folder_.path() / "lib").string(), "PORT=1"}), kOk);
  EXPECT_EQ(printed_, "");
}

TEST_F(PlugVerbTest, WritesOverNothingUnlessForced) {
  std::ofstream(out_) << "precious";
  EXPECT_EQ(Run({path_, "PORT=1"}), kRefused);
  EXPECT_EQ(Result(), "precious");
  EXPECT_EQ(Run({path_, "PORT=1", "--force"}), kOk);
  EXPECT_EQ(Result(), "ServerPort = 1\n\n\n");
}

TEST_F(PlugVerbTest, NeverWritesOverItsInput) {
  out_ = in_;
  EXPECT_EQ(Run({path_, "PORT=1", "-f"}), kRefused);
}

TEST_F(PlugVerbTest, WarnsOfAnUndefinedMacroWithFileAndLine) {
  EXPECT_EQ(Run({path_}), kOk);
  EXPECT_THAT(complaints_, HasSubstr("plug_port.moos:1: $(PORT): undefined macro"));
  EXPECT_THAT(Result(), HasSubstr("ServerPort = $(PORT)\n"));
}

TEST_F(PlugVerbTest, WritesNothingWhenStrictAndUndefined) {
  EXPECT_EQ(Run({path_, "-s"}), kUsage);
  EXPECT_FALSE(std::filesystem::exists(out_));
}

TEST_F(PlugVerbTest, AMacroNamedAloneIsDefinedAndOneSetToNothingIsNot) {
  std::ofstream(in_) << "#ifdef M\nyes\n#endif\n#ifndef M\nno\n#endif\n[$(M)$(M:=d)]\n";
  EXPECT_EQ(Run({"-f", "M"}), kOk);
  EXPECT_EQ(Result(), "yes\n[d]\n\n");
  EXPECT_EQ(Run({"-f", "M="}), kOk);
  EXPECT_EQ(Result(), "no\n[d]\n\n");
}

TEST_F(PlugVerbTest, TakesSectionsWhoseMarkersHaveNoBlank) {
  std::ofstream(folder_.path() / "lib/parts.moos") << "<tag><a>\nA = 1\n<tag><b>\nB = 2\n";
  std::ofstream(in_) << "#include parts.moos <a>\nC = 3";
  EXPECT_EQ(Run({path_, "-f"}), kOk);
  EXPECT_EQ(Result(), "A = 1\nC = 3\n");
  EXPECT_EQ(Run({path_, "-f", "--tag=none"}), kOk);
  EXPECT_THAT(complaints_, HasSubstr("no section `none`"));
}

TEST_F(PlugVerbTest, AMacroThatGrowsByItselfIsRefusedWithItsLineAndWritesNothing) {
  std::ofstream(in_) << "#define A $(A)$(A)\nx = $(A)\n";
  EXPECT_EQ(Run({"-f"}), kUsage);
  EXPECT_THAT(complaints_, HasSubstr("meta.moos:2"));
  EXPECT_FALSE(std::filesystem::exists(out_));
}

TEST_F(PlugVerbTest, PrintsToTheTerminalWhenAsked) {
  EXPECT_EQ(Run({path_, "-t", "PORT=7"}), kOk);
  EXPECT_THAT(printed_, HasSubstr("ServerPort = 7\n"));
  EXPECT_FALSE(std::filesystem::exists(out_));
}

TEST_F(PlugVerbTest, TakesTheXFileIfThereIsOne) {
  std::ofstream(in_.string() + "x") << "Own = 1\n";
  EXPECT_EQ(Run({"-x"}), kOk);
  EXPECT_EQ(Result(), "Own = 1\n\n");
}

TEST_F(PlugVerbTest, WritesNothingWhenNobodyCanBeAsked) {
  EXPECT_EQ(Run({path_, "-i"}), kRefused);
  EXPECT_FALSE(std::filesystem::exists(out_));
}

TEST_F(PlugVerbTest, TakesShortOptionsTogetherAndFoldersWithOrWithoutEqualsSign) {
  const std::string folder = (folder_.path() / "lib").string();
  EXPECT_EQ(Run({"-p", folder, "-tf", "PORT=7"}), kOk);
  EXPECT_THAT(printed_, HasSubstr("ServerPort = 7\n"));
  EXPECT_EQ(Run({"--path", folder, "-t", "PORT=8"}), kOk);
  EXPECT_THAT(printed_, HasSubstr("ServerPort = 8\n"));
}

TEST_F(PlugVerbTest, NamesTheNearestOption) {
  EXPECT_EQ(Run({"--stirct"}), kUsage);
  EXPECT_EQ(complaints_, "limpet: unknown option --stirct; did you mean --strict?\n");
}

}  // namespace
}  // namespace limpet

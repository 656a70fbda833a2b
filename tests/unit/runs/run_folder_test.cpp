// SPDX-License-Identifier: MIT
#include "limpet/runs/run_folder.hpp"

#include <csignal>
#include <fstream>
#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "limpet/console/command_output.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class RunFolderTest : public testing::Test {
 protected:
  [[nodiscard]] fs::path At(const std::string& name) const { return folder_.path() / name; }
  void Put(const std::string& name) const {
    fs::create_directories(At(name).parent_path());
    std::ofstream(At(name)) << "precious";
  }
  /// A run of two sessions with a figure.
  void MakeRun() const {
    RunFolder run(folder_.path(), RunFolder::Use::kNewRun);
    for (const std::string session : {"discovery", "change"}) {
      const FilledFolder filled(run.written(), session);
      Put(session + "/" + session + ".alog");
      Put(session + "/session/g000001/map.bin");
    }
    run.Write({{"report.json", "{}"}, {"figures/discovery_track.svg", "<svg/>"}});
  }
  static std::string RefusalOf(const std::function<void()>& act) {
    try {
      act();
    } catch (const Refusal& refusal) {
      return refusal.what();
    }
    return "no refusal";
  }
  TemporaryFolder folder_;
};

TEST_F(RunFolderTest, MakesRoomByRemovingWhatTheEarlierRunWrote) {
  MakeRun();
  Put("figures/mine.svg");
  RunFolder run(folder_.path(), RunFolder::Use::kNewRun);
  run.MakeRoomFor({"change"}, {"discovery"});
  EXPECT_TRUE(fs::exists(At("discovery/discovery.alog")));
  EXPECT_FALSE(fs::exists(At("change")));
  EXPECT_FALSE(fs::exists(At("report.json")));
  EXPECT_FALSE(fs::exists(At("figures/discovery_track.svg")));
  EXPECT_TRUE(fs::exists(At("figures/mine.svg")));
}

TEST_F(RunFolderTest, NamesTheStrangerInTheWayAndTouchesNothing) {
  MakeRun();
  Put("change/session/g000001/mine.bin");
  RunFolder run(folder_.path(), RunFolder::Use::kNewRun);
  EXPECT_THAT(RefusalOf([&] {
                run.MakeRoomFor({"discovery", "change"}, {});
              }),
              HasSubstr("change/session/g000001/mine.bin"));
  EXPECT_TRUE(fs::exists(At("discovery/discovery.alog")));
  EXPECT_TRUE(fs::exists(At("report.json")));
}

TEST_F(RunFolderTest, RemovesNothingThroughALink) {
  MakeRun();
  const TemporaryFolder elsewhere;
  std::ofstream(elsewhere.path() / "discovery.alog") << "precious";
  fs::remove_all(At("discovery"));
  fs::create_directory_symlink(elsewhere.path(), At("discovery"));
  RunFolder run(folder_.path(), RunFolder::Use::kNewRun);
  EXPECT_THAT(RefusalOf([&] { run.MakeRoomFor({"discovery"}, {}); }), HasSubstr("discovery"));
  EXPECT_TRUE(fs::exists(elsewhere.path() / "discovery.alog"));
  fs::remove_all(At("figures"));
  fs::create_directory_symlink(elsewhere.path(), At("figures"));
  EXPECT_THAT(RefusalOf([&] {
                run.Write({{"figures/discovery_track.svg", "x"}});
              }),
              HasSubstr("figures"));
  EXPECT_EQ(std::distance(fs::directory_iterator(elsewhere.path()), {}), 1);
}

TEST_F(RunFolderTest, SetsASessionAsideThatACrashCutShort) {
  {
    RunFolder run(folder_.path(), RunFolder::Use::kNewRun);
    run.written().Begin("discovery");  // and never ended
    Put("discovery/discovery.alog");
  }
  RunFolder run(folder_.path(), RunFolder::Use::kNewRun);
  testing::internal::CaptureStderr();
  run.MakeRoomFor({"discovery"}, {});
  EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("discovery.cut-1"));
  EXPECT_FALSE(fs::exists(At("discovery")));
  EXPECT_TRUE(fs::exists(At("discovery.cut-1/discovery.alog")));
}

TEST_F(RunFolderTest, RefusesAFolderThatNeverHeldARun) {
  Put("thesis.tex");
  EXPECT_THAT(RefusalOf([&] { RunFolder(folder_.path(), RunFolder::Use::kNewRun); }),
              HasSubstr("thesis.tex"));
  EXPECT_FALSE(fs::exists(At(".lock")));
}

TEST_F(RunFolderTest, LeavesNoHalfWrittenFile) {
  MakeRun();
  for (const auto& entry : fs::recursive_directory_iterator(folder_.path())) {
    EXPECT_NE(entry.path().extension(), ".new");
  }
  EXPECT_THAT(WrittenFiles(folder_.path()).FilesIn("report.json"),
              ElementsAre(fs::path("report.json")));
  EXPECT_THAT(WrittenFiles(folder_.path()).FilesIn("report.json.new"), IsEmpty());
}

TEST_F(RunFolderTest, WritesOverNoFileOfSomebodyElse) {
  Put("report.html");
  Put("report.json.new");
  RunFolder run(folder_.path(), RunFolder::Use::kReport);
  EXPECT_THAT(RefusalOf([&] { run.Write({{"report.html", "x"}}); }), HasSubstr("report.html"));
  EXPECT_THAT(RefusalOf([&] { run.Write({{"report.json", "x"}}); }), HasSubstr("report.json.new"));
}

TEST_F(RunFolderTest, TakesNoListThatNamesFilesOutside) {
  std::ofstream(At(WrittenFiles::kFile))
      << R"({"format": "limpet-written-1", "begun": [], "files": ["../../x"]})";
  EXPECT_THAT(RefusalOf([&] { WrittenFiles{folder_.path()}; }), HasSubstr("../../x"));
}

TEST_F(RunFolderTest, IsHeldByOneProcessAndFreeOnceThatIsGone) {
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    const FolderLock held(folder_.path());
    static_cast<void>(::write(ready[1], "x", 1) + 0);
    ::pause();
    ::_exit(0);
  }
  char byte = 0;
  ASSERT_EQ(::read(ready[0], &byte, 1), 1);
  const std::string refusal = RefusalOf([&] { FolderLock{folder_.path()}; });
  EXPECT_THAT(refusal, HasSubstr("in use by another run"));
  EXPECT_THAT(refusal, HasSubstr(std::to_string(child)));
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  EXPECT_EQ(RefusalOf([&] { FolderLock{folder_.path()}; }), "no refusal");
}

}  // namespace
}  // namespace limpet

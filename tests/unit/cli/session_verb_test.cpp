// SPDX-License-Identifier: MIT
#include <chrono>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/limpet/cli.hpp"
#include "apps/limpet/command_line.hpp"
#include "apps/pSession/session_app.hpp"
#include "estimation/mapping/saved_map.hpp"
#include "limpet/app/mail_journal.hpp"
#include "limpet/session/saved_session.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/test_link.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

/// A pSession that lives, notes what it hears, and is there no more: nothing ends it.
class CutSession {
 public:
  CutSession(const fs::path& run, Seconds begin) : journal_(Folder(run) / "pSession.mail", false) {
    link_.time = begin;
    AppContext context;
    context.name = "pSession";
    context.link = &link_;
    context.mission_folder = run.parent_path() / "table1";
    context.run_folder = run;
    context.session = "discovery";
    context.seed = 7;
    context.globals = {{"LatOrigin", "42.5", {}}};
    context.blocks = {{.name = "pMap",
                       .where = {},
                       .entries = {{"camera_fov_across_deg", "80", {}},
                                   {"camera_fov_along_deg", "60", {}},
                                   {"camera_width_px", "640", {}},
                                   {"camera_height_px", "480", {}},
                                   {"object_radius_m", "0.5", {}}}}};
    app_ = std::make_unique<SessionApp>(context, SessionApp::Params{});
  }
  void Tick() {
    journal_.NoteTick(link_.time);
    journal_.Flush();
    app_->Tick(link_.time);
  }
  template <class T>
  void Hear(const Topic<T>& topic, const T& value) {
    const auto message =
        std::make_shared<const Message>(Message{.name = topic.name,
                                                .value = TopicCodec<T>::Encode(value),
                                                .time = link_.time,
                                                .source = "test",
                                                .source_aux = "",
                                                .community = ""});
    journal_.NoteMail(*message, link_.time);
    journal_.Flush();
    app_->Deliver(message);
  }
  void SeeAt(double north) {
    link_.time += Seconds(1.0);
    ObservedFrame frame;
    frame.exposure = link_.time, frame.X_WB.p_WB = {north, 0, 3};
    Hear(topics::kNavCameraFrame, frame);
  }
  [[nodiscard]] Seconds now() const { return link_.time; }

 private:
  static fs::path Folder(const fs::path& run) {
    fs::create_directories(run);
    return run;
  }
  TestLink link_;
  MailJournal journal_;
  std::unique_ptr<SessionApp> app_;
};

class SessionVerbTest : public ::testing::Test {
 protected:
  /// Saved after its first frame; of the second there is the journal alone.
  Seconds DiveAndLosePower() {
    CutSession session(run_, Seconds(1000.0));
    session.Hear(topics::kSurveyArea, SurveyArea{});
    session.SeeAt(1.0);
    session.Tick();
    session.SeeAt(2.0);
    return session.now();
  }
  int Run(std::vector<std::string> words) {
    ::testing::internal::CaptureStdout();
    ::testing::internal::CaptureStderr();
    words.insert(words.begin(), "session");
    const int code = RunCommandLine(words);
    out_ = ::testing::internal::GetCapturedStdout();
    err_ = ::testing::internal::GetCapturedStderr();
    return code;
  }
  [[nodiscard]] SavedSession Saved() const { return LoadSavedSession(run_, "session"); }

  TemporaryFolder folder_;
  fs::path run_ = folder_.path() / "discovery";
  std::string out_, err_;
};

TEST_F(SessionVerbTest, RecoversASessionToTheLastSecondBeforeThePowerWasCut) {
  const Seconds end = DiveAndLosePower();
  ASSERT_EQ(Saved().memory.frames.size(), 1U);
  ASSERT_EQ(Run({"recover", run_.string()}), kOk) << err_;
  EXPECT_THAT(out_, HasSubstr("3 messages gone through, 1.0 s more than it had saved; 2 frames"));
  const SavedSession saved = Saved();
  ASSERT_EQ(saved.memory.frames.size(), 2U);
  EXPECT_EQ(saved.memory.frames[1].X_WB.p_WB.x(), 2.0);
  EXPECT_EQ(saved.facts.saved_at, end.value());
  EXPECT_EQ(saved.facts.cause, "recovered");
}

TEST_F(SessionVerbTest, KeepsWhatTheSessionWasOf) {
  DiveAndLosePower();
  const SavedSession before = Saved();
  ASSERT_EQ(Run({"recover", (run_ / "session").string()}), kOk) << err_;
  const SavedSession after = Saved();
  EXPECT_EQ(after.facts.mission, "table1");
  EXPECT_EQ(after.facts.session, "discovery");
  EXPECT_EQ(after.facts.seed, 7U);
  EXPECT_EQ(after.facts.lat_origin, "42.5");
  EXPECT_EQ(after.memory.mission, before.memory.mission);
}

TEST_F(SessionVerbTest, TakesTheMapThatPMapMakesOfItsOwnJournal) {
  DiveAndLosePower();
  EXPECT_TRUE(Saved().memory.map.empty());
  {
    MailJournal journal(run_ / "pMap.mail", false);
    const Message area{.name = topics::kSurveyArea.name,
                       .value = TopicCodec<SurveyArea>::Encode({.north_max = 5.0, .east_max = 5.0}),
                       .time = Seconds(1000.0),
                       .source = "pSurvey",
                       .source_aux = "",
                       .community = ""};
    journal.NoteMail(area, Seconds(1000.0));
    Message ping = area;
    ping.name = topics::kNavBeams.name;
    ping.value = TopicCodec<PosedBeams>::Encode(
        {.down = 3.5, .b1 = 4.4, .b2 = 4.4, .b3 = 4.4, .b4 = 4.4, .sd_down = {}});
    journal.NoteMail(ping, Seconds(1001.0));
    journal.NoteTick(Seconds(1002.5));
  }
  ASSERT_EQ(Run({"recover", run_.string()}), kOk) << err_;
  EXPECT_GT(OctreeOf(Saved().memory.map)->nodes(), 0U);
  EXPECT_EQ(Saved().memory.frames.size(), 2U);
  EXPECT_FALSE(fs::exists(run_ / "pMap.mail"));
}

TEST_F(SessionVerbTest, SaysWhyTheMapStaysAsItWas) {
  DiveAndLosePower();
  MailJournal(run_ / "pMap.mail", false).NoteTick(Seconds(1002.5));
  StoredSession stored = *LoadSession(run_);
  stored.files["mission/as_run.moos"] = "ProcessConfig = pMap\n{\n  no_such_key = 1\n}\n";
  ASSERT_TRUE(SessionWriter(run_ / "session").Commit(stored.facts, stored.files));
  ASSERT_EQ(Run({"recover", run_.string()}), kOk) << err_;
  EXPECT_THAT(err_,
              AllOf(HasSubstr("the map stays as it was last saved"), HasSubstr("no_such_key")));
  EXPECT_EQ(Saved().memory.frames.size(), 2U);
}

TEST_F(SessionVerbTest, HasNothingToDoTwice) {
  DiveAndLosePower();
  ASSERT_EQ(Run({"recover", run_.string()}), kOk);
  EXPECT_EQ(Run({"recover", run_.string()}), kOk);
  EXPECT_THAT(out_, HasSubstr("ended orderly, nothing to recover"));
}

TEST_F(SessionVerbTest, RecoversWhatIsWholeOfATornJournal) {
  DiveAndLosePower();
  const fs::path journal = run_ / "pSession.mail";
  fs::resize_file(journal, fs::file_size(journal) - 5);
  ASSERT_EQ(Run({"recover", run_.string()}), kOk) << err_;
  EXPECT_EQ(Saved().memory.frames.size(), 1U);
}

TEST_F(SessionVerbTest, SetsAsideAFormerSessionThatTheCutOneHadNotYet) {
  {
    CutSession former(run_, Seconds(500.0));
    former.Hear(topics::kSurveyArea, SurveyArea{});
    former.SeeAt(5.0);
    former.Tick();
  }
  {
    CutSession session(run_, Seconds(1000.0));
    session.Tick();
    session.Hear(topics::kSurveyArea, SurveyArea{});
    session.SeeAt(1.0);
  }
  ASSERT_EQ(Run({"recover", run_.string()}), kOk) << err_;
  EXPECT_EQ(Saved().memory.frames.at(0).X_WB.p_WB.x(), 1.0);
  const SavedSession aside = LoadSavedSession(run_ / "session-former-1", "former");
  EXPECT_EQ(aside.memory.frames.at(0).X_WB.p_WB.x(), 5.0);
}

TEST_F(SessionVerbTest, RefusesOneThatIsStillUnderWay) {
  DiveAndLosePower();
  std::jthread writer([this](const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      std::ofstream(run_ / "pSession.mail", std::ios::app) << "tick";
      std::this_thread::sleep_for(std::chrono::milliseconds(200));
    }
  });
  EXPECT_EQ(Run({"recover", run_.string()}), kRefused);
  EXPECT_THAT(err_, HasSubstr("end the mission first"));
}

TEST_F(SessionVerbTest, SaysThatAJournalHoldsNothing) {
  DiveAndLosePower();
  std::ofstream(run_ / "pSession.mail") << "no journal";
  EXPECT_EQ(Run({"recover", run_.string()}), kFailed);
  EXPECT_THAT(err_, HasSubstr("pSession.mail: holds nothing that is whole"));
  EXPECT_TRUE(fs::exists(run_ / "pSession.mail"));
}

TEST_F(SessionVerbTest, NamesWhatIsNoSession) {
  EXPECT_EQ(Run({"recover", folder_.path().string()}), kUsage);
  EXPECT_THAT(err_, HasSubstr(folder_.path().string()));
  EXPECT_EQ(Run({"mend", "x"}), kUsage);
  EXPECT_EQ(Run({}), kUsage);
  EXPECT_THAT(out_, HasSubstr("usage: limpet session recover"));
}

}  // namespace
}  // namespace limpet

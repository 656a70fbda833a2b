// SPDX-License-Identifier: MIT
// pSession in a folder that holds a session already: a former one, or its own of a former life.
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "apps/pSession/session_app.hpp"
#include "limpet/session/saved_session.hpp"
#include "tests/unit/pSession/session_app_fixture.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

class SessionAppAgain : public SessionAppTest {
 protected:
  /// A dive that was saved: deployed, with one frame.
  void Dive(SessionApp& app, double north) {
    link_.Send(app, topics::kSurveyArea, SurveyArea{});
    ObservedFrame frame;
    frame.exposure = link_.time, frame.X_WB.p_WB = {north, 0, 1};
    link_.Send(app, topics::kNavCameraFrame, frame);
  }
  double SavedNorth(const fs::path& session) {
    const Expected<StoredSession> stored = LoadSession(session);
    EXPECT_TRUE(stored) << stored.error().text;
    return MemoryOf(stored->files)->frames.at(0).X_WB.p_WB.x();
  }
  fs::path Run() const { return folder_.path() / "discovery"; }
  void FlyOnce() {
    SessionApp app(Context("discovery"), {});
    app.Tick(link_.time);
    Dive(app, 1.0);
    app.Finish(link_.time + Seconds(1.0));
  }
};

TEST_F(SessionAppAgain, NeverSavesOverAFormerSessionBeforeItIsDeployed) {
  FlyOnce();
  SessionApp app(Context("discovery"), {});
  app.Tick(link_.time);
  ObservedFrame frame;  // the camera sees the surface before anybody deploys
  frame.exposure = link_.time, frame.X_WB.p_WB = {7, 0, 0};
  link_.Send(app, topics::kNavCameraFrame, frame);
  app.Finish(link_.time + Seconds(100.0));
  EXPECT_EQ(SavedNorth(Run()), 1.0);
  EXPECT_TRUE(app.warnings().contains("FORMER_SESSION"));
}

TEST_F(SessionAppAgain, KilledBeforeItWasDeployedItSavesOverNoFormerSessionEither) {
  FlyOnce();
  link_.time += Seconds(100.0);
  link_.replays = true;
  AppContext context = Context("discovery");
  context.is_restarted = true;
  SessionApp app(context, {});
  app.Tick(link_.time);
  link_.replays = false;
  app.Tick(link_.time + Seconds(90.0));
  app.Finish(link_.time + Seconds(100.0));
  EXPECT_EQ(SavedNorth(Run()), 1.0);
}

TEST_F(SessionAppAgain, WarnsThatTheSessionItComparesWithWasCutShort) {
  FlyOnce();
  std::ofstream(Run() / "pSession.mail") << "heard";
  const SessionApp app(Context("change", Run()), {});
  EXPECT_TRUE(app.warnings().contains("FORMER_SESSION_CUT"));
}

TEST_F(SessionAppAgain, SetsAFormerSessionAsideOnceItHasFlownItself) {
  FlyOnce();
  SessionApp app(Context("discovery"), {});
  app.Tick(link_.time);
  Dive(app, 2.0);
  app.Finish(link_.time + Seconds(1.0));
  EXPECT_EQ(SavedNorth(Run()), 2.0);
  EXPECT_EQ(SavedNorth(Run() / "session-former-1"), 1.0);
  EXPECT_TRUE(app.warnings().contains("FORMER_SESSION_ASIDE"));
  EXPECT_FALSE(app.warnings().contains("FORMER_SESSION"));
}

TEST_F(SessionAppAgain, SaysThatItCannotGoOnFromWhatItHadSaved) {
  FlyOnce();
  for (const auto& entry : fs::recursive_directory_iterator(Run())) {
    if (entry.is_regular_file()) std::ofstream(entry.path()) << "damaged";
  }
  AppContext context = Context("discovery");
  context.is_restarted = true;
  const SessionApp app(context, {});
  EXPECT_TRUE(app.warnings().contains("SESSION_NOT_RESUMED"));
}

TEST_F(SessionAppAgain, StartedAgainWithoutItsMailItGoesOnFromWhatItHadSaved) {
  FlyOnce();
  AppContext context = Context("discovery");
  context.is_restarted = true;
  SessionApp app(context, {});
  app.Tick(link_.time);
  EXPECT_EQ(SavedNorth(Run()), 1.0);
  EXPECT_GT(LoadSession(Run())->generation, 2) << "numbers go on";
  EXPECT_FALSE(fs::exists(Run() / "session-former-1"));
}

TEST_F(SessionAppAgain, BroughtToItsEndItSetsAsideWhatItCannotRead) {
  FlyOnce();
  StoredSession stored = *LoadSession(Run());
  stored.files["objects.json"] = "no objects";
  ASSERT_TRUE(SessionWriter(Run() / "session").Commit(stored.facts, stored.files));
  link_.replays = true;
  AppContext context = Context("discovery");
  context.ends_cut_life = true;
  SessionApp app(context, {});
  Dive(app, 2.0);
  link_.replays = false;
  app.Finish(link_.time + Seconds(1.0));
  EXPECT_EQ(SavedNorth(Run()), 2.0);
  EXPECT_TRUE(fs::exists(Run() / "session-former-1"));
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/console/scope_screen.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// A community of five variables at MOOS time 100.
VariableTable SmallTable() {
  VariableTable table;
  const auto write = [&table](const std::string& name, Value value, double time,
                              const std::string& source, const std::string& aux = "") {
    table.Hear({.name = name,
                .value = std::move(value),
                .time = Seconds(time),
                .source = source,
                .source_aux = aux,
                .community = "alpha",
                .id = 1},
               Seconds(time));
  };
  for (int i = 0; i <= 20; ++i) {
    write("NAV_X", 3.0 + i, 90.0 + 0.5 * i, "pNav");
  }
  write("DEPLOY", std::string("true"), 4.0, "pAutoPoke");
  write("MODE", std::string("ACTIVE:SURVEYING"), 60.0, "pHelm", "HELM_MODE");
  write("EVIL", std::string("\033[2J\033]0;owned\007"), 70.0, "pE\nvil");
  write("CAMERA_FRAME", Binary(921'600, std::byte{0x4c}), 99.8, "uSimCamera");
  return table;
}

ScopeScene SceneAt(double now) {
  return {.moment = {.now = Seconds(now), .warp = 5.0, .keeps_utf8 = true},
          .community = "alpha",
          .place = "localhost:9000",
          .trouble = ""};
}

class ScopeScreenTest : public ::testing::Test {
 protected:
  std::string Draw(ScreenSize size = {.columns = 80, .lines = 9}) {
    return PlainText(screen_.Draw(table_, SceneAt(100.0), size));
  }
  void Type(std::string_view text) {
    for (const char c : text) {
      screen_.Press({Key::Code::kCharacter, c});
    }
  }
  VariableTable table_ = SmallTable();
  ScopeScreen screen_{{}};
};

TEST_F(ScopeScreenTest, FitsEightyColumns) {
  EXPECT_EQ(Draw(),
            R"(alpha at localhost:9000  warp 5                                 5 of 5 variables
VARIABLE      SOURCE           AGE      Hz  T VALUE
CAMERA_FRAME  uSimCamera       0.2       -  B [921.6 kB] 4c4c4c4c 4c4c4c4c 4c4c~
DEPLOY        pAutoPoke       96.0       -  S true
EVIL          pE\nvil         30.0       -  S \x1b[2J\x1b]0;owned\x07
MODE          pHelm:HELM_~    40.0       -  S ACTIVE:SURVEYING
NAV_X         pNav             0.0    2.00  D 23

q quit  s sort:name  r reverse  / filter  c changed  space pause  h history
)");
}

TEST_F(ScopeScreenTest, UsesTheRoomOfAWideTerminal) {
  EXPECT_EQ(Draw({.columns = 120, .lines = 4}),
            "alpha at localhost:9000  warp 5                                                       "
            "                  5 of 5 variables\n"
            "VARIABLE      SOURCE              AGE      Hz     HEARD  T VALUE\n"
            "CAMERA_FRAME  uSimCamera          0.2       -         1  B [921.6 kB] 4c4c4c4c "
            "4c4c4c4c 4c4c4c4c 4c4c4c4c ...\n"
            "q quit  s sort:name  r reverse  / filter  c changed  space pause  h history\n");
}

TEST_F(ScopeScreenTest, NeverDrawsBeyondTheScreen) {
  Type("/nav");
  for (const std::size_t columns : {1U, 5U, 20U, 40U, 79U, 200U}) {
    for (const std::size_t lines : {1U, 2U, 3U, 4U, 50U}) {
      const Frame frame =
          screen_.Draw(table_, SceneAt(100.0), {.columns = columns, .lines = lines});
      EXPECT_EQ(frame.size(), lines);
      for (const FrameLine& line : frame) {
        EXPECT_LE(line.columns(), columns) << line.PlainText();
      }
    }
  }
}

TEST_F(ScopeScreenTest, LetsNoForeignByteReachTheTerminal) {
  std::string painted;
  for (const FrameLine& line : screen_.Draw(table_, SceneAt(100.0), {.columns = 80, .lines = 9})) {
    painted += Painted(line, true);
  }
  EXPECT_THAT(painted, Not(HasSubstr("\033[2J")));
  EXPECT_THAT(painted, Not(HasSubstr("\007")));
}

TEST_F(ScopeScreenTest, SortsInTurn) {
  Type("ss");
  EXPECT_THAT(Draw(), HasSubstr("s sort:rate"));
  Type("ssr");
  EXPECT_THAT(Draw(), HasSubstr("s sort:name (reversed)"));
}

TEST_F(ScopeScreenTest, FiltersWhileOneTypes) {
  Type("/m");
  EXPECT_THAT(Draw(), HasSubstr("2 of 5 variables"));
  EXPECT_THAT(Draw(), HasSubstr("filter: m_"));
  Type("o");
  EXPECT_THAT(Draw(), HasSubstr("1 of 5 variables"));
  screen_.Press({Key::Code::kBackspace});
  screen_.Press({Key::Code::kEnter});
  EXPECT_THAT(Draw(), HasSubstr("/ filter:m  c changed"));
  Type("/xq");
  screen_.Press({Key::Code::kEscape});
  EXPECT_THAT(Draw(), HasSubstr("2 of 5 variables")) << "Esc goes back to the former filter";
  EXPECT_FALSE(screen_.wants_to_quit()) << "q was a letter of the filter";
}

TEST_F(ScopeScreenTest, SaysWhyItIsEmpty) {
  Type("/nothing");
  EXPECT_THAT(Draw(), HasSubstr("nothing passes the filter; Esc clears it"));
  table_ = {};
  screen_ = ScopeScreen({});
  EXPECT_THAT(Draw(), HasSubstr("nothing heard yet"));
}

TEST_F(ScopeScreenTest, ShowsOnlyWhatChanges) {
  Type("c");
  EXPECT_THAT(Draw(), HasSubstr("1 of 5 variables"));
}

TEST_F(ScopeScreenTest, ScrollsToTheCursor) {
  screen_.Press({Key::Code::kEnd});
  screen_.Press({Key::Code::kEnd});
  const std::string frame = Draw({.columns = 80, .lines = 5});
  EXPECT_THAT(frame, HasSubstr("MODE"));
  EXPECT_THAT(frame, HasSubstr("NAV_X"));
  EXPECT_THAT(frame, Not(HasSubstr("DEPLOY")));
}

TEST_F(ScopeScreenTest, KeepsTheCursorOnItsVariableWhenOthersComeBefore) {
  screen_.Press({Key::Code::kDown});
  screen_.Press({Key::Code::kDown});
  Draw();
  table_.Hear({.name = "AAA",
               .value = 1.0,
               .time = Seconds(100),
               .source = "p",
               .source_aux = "",
               .community = ""},
              Seconds(100));
  const Frame frame = screen_.Draw(table_, SceneAt(100.0), {.columns = 80, .lines = 12});
  EXPECT_EQ(frame[4].spans().at(0).ink, Ink::kSelected);
  EXPECT_THAT(frame[4].PlainText(), HasSubstr("DEPLOY"));
}

TEST_F(ScopeScreenTest, ShowsTheHistoryOfTheVariableUnderTheCursor) {
  screen_.Press({Key::Code::kEnd});
  screen_.Press({Key::Code::kEnd});
  Draw();
  screen_.Press({Key::Code::kEnter});
  EXPECT_EQ(Draw({.columns = 60, .lines = 6}),
            R"(alpha at localhost:9000  warp 5      NAV_X: 21 kept, 2.00 Hz
   AGE    STEP s  SOURCE        T VALUE
   0.0     0.500  pNav          D 23
   0.5     0.500  pNav          D 22
   1.0     0.500  pNav          D 21
q quit  Esc back  space pause  arrows scroll
)");
  screen_.Press({Key::Code::kEnd});
  EXPECT_THAT(Draw({.columns = 60, .lines = 6}), HasSubstr("  10.0            pNav"));
  screen_.Press({Key::Code::kEscape});
  EXPECT_THAT(Draw(), HasSubstr("5 of 5 variables"));
}

TEST_F(ScopeScreenTest, BeginsWithTheHistoryAskedFor) {
  screen_ = ScopeScreen({.history_of = "LATER"});
  EXPECT_THAT(Draw(), HasSubstr("nothing heard of it yet"));
}

TEST_F(ScopeScreenTest, SaysWhenItIsPausedOrAlone) {
  Type(" ");
  EXPECT_TRUE(screen_.is_paused());
  ScopeScene scene = SceneAt(100.0);
  scene.trouble = "Connection refused";
  const std::string frame = PlainText(screen_.Draw(table_, scene, {.columns = 90, .lines = 5}));
  EXPECT_THAT(frame, HasSubstr("NO CONNECTION: Connection refused PAUSED"));
}

TEST_F(ScopeScreenTest, QuitsWithQ) {
  Type("q");
  EXPECT_TRUE(screen_.wants_to_quit());
}

TEST(ScopeColumns, NamesTheCommunityOnlyIfThereAreSeveral) {
  VariableTable table;
  for (const char* community : {"alpha", "shore"}) {
    table.Hear({.name = std::string("OF_") + community,
                .value = 1.0,
                .time = Seconds(1),
                .source = "p",
                .source_aux = "",
                .community = community,
                .id = 1},
               Seconds(1));
  }
  const auto rows = Arranged(table, {}, ScopeSort::kName, false, Seconds(1));
  EXPECT_THAT(ScopeColumns(rows, 120, true).Head().PlainText(), HasSubstr("COMMUNITY"));
  EXPECT_THAT(ScopeColumns({rows[0]}, 120, true).Head().PlainText(), Not(HasSubstr("COMMUNITY")));
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/sharing/output_book.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

class OutputBookTest : public ::testing::Test {
 protected:
  void Add(std::string_view line, double at = 0.0) {
    const auto outputs = ParseShareOutputs(line, {});
    ASSERT_TRUE(outputs.has_value()) << outputs.error().text;
    for (const ShareOutput& output : *outputs) {
      book_.Add(output, Seconds(at));
    }
  }
  /// Names under which a write goes out.
  std::vector<std::string> Write(const std::string& name, double at = 0.0,
                                 const std::string& app = "pApp") {
    std::vector<std::string> names;
    const Message message{.name = name,
                          .value = 1.0,
                          .time = Seconds(at),
                          .source = app,
                          .source_aux = {},
                          .community = {}};
    for (const OutputBook::Due& due : book_.TakeDue(message, Seconds(at))) {
      names.push_back(due.dest);
    }
    return names;
  }
  OutputBook book_;
};

TEST_F(OutputBookTest, SendsAVariableToEachOfItsRoutes) {
  Add("src_name=X,dest_name=Y,route=a:1 & multicast_8");
  Add("X->Z:b:2");
  EXPECT_THAT(Write("X"), ElementsAre("Y", "Y", "Z"));
  EXPECT_THAT(Write("OTHER"), IsEmpty());
}

TEST_F(OutputBookTest, DropsWhatComesTooSoon) {
  Add("src_name=FAST,route=a:1,frequency=2");
  EXPECT_THAT(Write("FAST", 10.0), ElementsAre("FAST"));
  EXPECT_THAT(Write("FAST", 10.3), IsEmpty());
  EXPECT_THAT(Write("FAST", 10.5), ElementsAre("FAST"));
}

TEST_F(OutputBookTest, EndsARouteAfterItsDuration) {
  Add("src_name=X,route=a:1,duration=60", 100.0);
  EXPECT_THAT(Write("X", 160.0), ElementsAre("X"));
  EXPECT_THAT(Write("X", 160.1), IsEmpty());
}

TEST_F(OutputBookTest, SendsOnceWithDurationZero) {
  Add("src_name=X,route=a:1,duration=0");
  EXPECT_THAT(Write("X", 5.0), ElementsAre("X"));
  EXPECT_THAT(Write("X", 6.0), IsEmpty());
}

TEST_F(OutputBookTest, EndsARouteAfterItsShares) {
  Add("src_name=X,route=a:1,max_shares=2");
  EXPECT_THAT(Write("X"), ElementsAre("X"));
  EXPECT_THAT(Write("X"), ElementsAre("X"));
  EXPECT_THAT(Write("X"), IsEmpty());
}

TEST_F(OutputBookTest, StartsAnEqualRouteAnew) {
  Add("src_name=X,route=a:1,max_shares=1");
  EXPECT_THAT(Write("X"), ElementsAre("X"));
  Add("src_name=X,route=a:1,max_shares=1");
  EXPECT_THAT(Write("X"), ElementsAre("X"));
}

TEST_F(OutputBookTest, PutsThePrefixBeforeWhatAPatternMatches) {
  Add("NAV_*->V_:a:1");
  EXPECT_THAT(Write("NAV_X"), ElementsAre("V_NAV_X"));
  EXPECT_THAT(Write("NAVX"), IsEmpty());
}

TEST_F(OutputBookTest, NamesByTheStarAlone) {
  Add("src_name=MY_*,dest_name=^,route=a:1");
  Add("src_name=*_LOCAL,dest_name=^,route=a:1");
  EXPECT_THAT(Write("MY_DEPTH"), ElementsAre("DEPTH"));
  EXPECT_THAT(Write("NODE_REPORT_LOCAL"), ElementsAre("NODE_REPORT"));
  EXPECT_THAT(Write("MY_"), IsEmpty()) << "nothing has no name";
}

TEST_F(OutputBookTest, AsksWhoWroteWhatAPatternMatches) {
  Add("src_name=*:pNav,route=a:1");
  EXPECT_THAT(Write("X", 0.0, "pOther"), IsEmpty());
  EXPECT_THAT(Write("X", 0.0, "pNav"), ElementsAre("X"));
  EXPECT_THAT(Write("X", 0.0, "pOther"), ElementsAre("X")) << "it has become a fixed route";
}

TEST_F(OutputBookTest, TellsItsRoutesAsMoosDoes) {
  Add("src_name=X,dest_name=Y,route=localhost:9021");
  Add("S->localhost:9021 & S2:multicast_8");
  Add("src_name=BIN,route=multicast_8");
  Add("NAV_*->V_:localhost:9021");
  Add("src_name=FAST,route=localhost:9021,frequency=2");
  Write("NAV_DEPTH");
  EXPECT_EQ(book_.Summary(Seconds(0.0)),
            "BIN->BIN:224.1.1.11:24468:multicast_8, FAST->FAST:localhost:9021, "
            "NAV_DEPTH->V_NAV_DEPTH:localhost:9021, S->S:localhost:9021 & "
            "S2:224.1.1.11:24468:multicast_8, X->Y:localhost:9021");
}

TEST_F(OutputBookTest, TellsNamedFromMatched) {
  Add("X->a:1");
  Add("NAV_*->a:1");
  Write("NAV_X");
  EXPECT_TRUE(book_.IsNamed("X"));
  EXPECT_FALSE(book_.IsNamed("NAV_X"));
  EXPECT_TRUE(book_.IsMatched("NAV_X"));
  EXPECT_FALSE(book_.IsMatched("X"));
}

TEST_F(OutputBookTest, IsBounded) {
  ShareOutput output = ParseShareOutputs("X->a:1", {})->front();
  for (std::size_t i = 0; i < OutputBook::kMostRoutes; ++i) {
    output.source = "X" + std::to_string(i);
    ASSERT_EQ(book_.Add(output, {}), OutputBook::Added::kNew);
  }
  output.source = "LAST";
  EXPECT_EQ(book_.Add(output, {}), OutputBook::Added::kRefused);
}

}  // namespace
}  // namespace limpet

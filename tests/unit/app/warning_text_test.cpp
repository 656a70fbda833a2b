// SPDX-License-Identifier: MIT
#include "limpet/app/warning_text.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

using Told = std::map<std::string, ToldWarning>;

TEST(WarningText, ComesApartAsItWasPutTogether) {
  const std::string text =
      EncodeWarnings({{"DVL_STALE", {Severity::kWarning, "no bottom lock: 3 s", Seconds(1.0)}},
                      {"NAV_LOST", {Severity::kAlarm, "nothing heard (yet)", Seconds(2.0)}}});
  EXPECT_EQ(text,
            "DVL_STALE (warning): no bottom lock: 3 s; NAV_LOST (alarm): nothing heard (yet)");
  EXPECT_EQ(DecodeWarnings(text), (Told{{"DVL_STALE", {Severity::kWarning, "no bottom lock: 3 s"}},
                                        {"NAV_LOST", {Severity::kAlarm, "nothing heard (yet)"}}}));
}

TEST(WarningText, ATextWithASemicolonStaysOneWarning) {
  const std::string text =
      EncodeWarnings({{"COVERAGE_STALLED", {Severity::kNote, "not grown; GOING: home", {}}}});
  EXPECT_EQ(DecodeWarnings(text),
            (Told{{"COVERAGE_STALLED", {Severity::kNote, "not grown, GOING: home"}}}));
}

TEST(WarningText, SaysNoneForNone) {
  EXPECT_EQ(EncodeWarnings({}), "none");
  EXPECT_TRUE(DecodeWarnings("none").empty());
  EXPECT_TRUE(DecodeWarnings("").empty());
}

TEST(WarningText, TakesWarningsOfAppsThatKnowNoSeverity) {
  EXPECT_EQ(DecodeWarnings("OLD: as before; ODD (thing): text"),
            (Told{{"OLD", {Severity::kWarning, "as before"}},
                  {"ODD (thing)", {Severity::kWarning, "text"}}}));
}

TEST(WarningText, TakesWhatIsNoListForAnId) {
  EXPECT_EQ(DecodeWarnings("nonsense"), (Told{{"nonsense", {Severity::kWarning, ""}}}));
}

TEST(WarningText, ItsVariableNamesTheApp) {
  EXPECT_EQ(WarningsVariable("pNav"), "PNAV_WARNINGS");
  EXPECT_TRUE(CarriesWarnings("PNAV_WARNINGS"));
  EXPECT_FALSE(CarriesWarnings("PNAV_STATUS"));
  EXPECT_EQ(AppOfWarnings("PNAV_WARNINGS"), "PNAV");
}

}  // namespace
}  // namespace limpet

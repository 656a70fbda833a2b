// SPDX-License-Identifier: MIT
#include "limpet/site/site_text.hpp"

#include <algorithm>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

using testing::HasSubstr;
using testing::Not;

/// `outline` as pts: x (east), y (north) [m].
Site SiteWithin(const std::string& outline, double north, double east) {
  return {.name = "made_up",
          .area = {.north_max = north, .east_max = east, .margin = 5.0, .outline = outline},
          .start_W = {},
          .wanted_m2 = north * east,
          .path_m = 500.0,
          .speed_mps = 0.5};
}

Site Square() { return SiteWithin("0,0:40,0:40,40:0,40", 40.0, 40.0); }

std::size_t WidestLine(const std::string& text) {
  std::size_t widest = 0, width = 0;
  for (const char letter : text) {
    width = letter == '\n' ? 0 : width + 1;
    widest = std::max(widest, width);
  }
  return widest;
}

TEST(SiteText, ExplainsTheLettersThatOccurAndNoOthers) {
  Site site = Square();
  EXPECT_THAT(SiteText(site, 40),
              HasSubstr("\n: ground to be seen, . the rest of the operating region\n"));
  site.area.keep_out = "{10,10:20,10:20,20:10,20}";
  site.area.transit = "-20,-20";
  site.start_W.emplace(-30.0, -30.0);
  EXPECT_THAT(SiteText(site, 40),
              HasSubstr("\n: ground to be seen, . the rest of the operating region, # keep-out "
                        "zone, o way point of the transit, S start and home\n"));
}

TEST(SiteText, EndsWithTheSummary) {
  const Site site = Square();
  EXPECT_TRUE(SiteText(site, 40).ends_with("\n" + site.Summary() + "\n"));
}

TEST(SiteText, HasNorthUpAndEastRight) {
  Site site = Square();
  site.start_W.emplace(80.0, 80.0);
  const std::string text = SiteText(site, 40);
  const std::string first_line = text.substr(0, text.find('\n'));
  EXPECT_TRUE(first_line.ends_with("S")) << text;
}

TEST(SiteText, IsAsWideAsItsColumnsAtMostAndHasFiftyRowsWhateverTheShape) {
  for (const auto& [north, east] : {std::pair(40.0, 40.0), {5.0, 900.0}, {900.0, 5.0}}) {
    const Site site = SiteWithin("0,0:" + std::to_string(east) + ",0:" + std::to_string(east) +
                                     "," + std::to_string(north) + ":0," + std::to_string(north),
                                 north, east);
    const std::string text = SiteText(site, 60);
    const std::string map = text.substr(0, text.find(": ground"));
    EXPECT_LE(WidestLine(map), 61U) << text;
    EXPECT_LE(std::ranges::count(map, '\n'), 51) << text;
    EXPECT_THAT(map, HasSubstr(":")) << text;
  }
}

TEST(SiteText, ShowsWhatIsNarrowerThanALetter) {
  Site site = SiteWithin("0,0:1200,0:1200,800:0,800", 800.0, 1200.0);
  site.area.keep_out = "{100,400:1100,400:1100,401:100,401}";
  EXPECT_THAT(SiteText(site, 60), HasSubstr("::####################"));
}

TEST(SiteText, AZoneFarOutsideIsSaidAndNotDrawn) {
  Site site = Square();
  site.area.keep_out = "{-9000,300:9000,300:9000,301:-9000,301}";
  const std::string text = SiteText(site, 40);
  EXPECT_THAT(text, Not(HasSubstr("#")));
  EXPECT_THAT(text, HasSubstr("; 1 keep-out zone beyond the drawing\n")) << "but said";
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/site/site_figure.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

using testing::HasSubstr;
using testing::Not;

Site PlainSquare() {
  return {.name = "made_up",
          .area = {.north_max = 40.0, .east_max = 40.0, .margin = 5.0},
          .start_W = {},
          .wanted_m2 = 1600.0,
          .path_m = 500.0,
          .speed_mps = 0.5};
}

std::size_t CountOf(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++count;
  return count;
}

TEST(SiteFigure, NamesTheMissionAndSaysWhatItTakes) {
  const std::string svg = SiteSvg(PlainSquare());
  EXPECT_THAT(svg, HasSubstr("What made_up surveys"));
  EXPECT_THAT(svg, HasSubstr(PlainSquare().Summary()));
}

TEST(SiteFigure, ExplainsWhatIsDrawnAndNothingElse) {
  Site site = PlainSquare();
  const std::string plain = SiteSvg(site);
  EXPECT_THAT(plain, HasSubstr("operating region"));
  for (const char* absent : {"keep-out zone", "transit", "start and home"})
    EXPECT_THAT(plain, Not(HasSubstr(absent)));
  site.area.keep_out = "{10,10:20,10:20,20:10,20}";
  site.area.transit = "-20,-20";
  site.start_W.emplace(-30.0, -30.0);
  const std::string whole = SiteSvg(site);
  for (const char* drawn : {"keep-out zone", "transit", "start and home"})
    EXPECT_THAT(whole, HasSubstr(drawn));
}

TEST(SiteFigure, AZoneFarOutsideIsSaidAndNotExplained) {
  Site site = PlainSquare();
  site.area.keep_out = "{-9000,300:9000,300:9000,301:-9000,301}";
  const std::string svg = SiteSvg(site);
  EXPECT_THAT(svg, HasSubstr("; 1 keep-out zone beyond the drawing"));
  EXPECT_THAT(svg, Not(HasSubstr(">keep-out zone")));
}

TEST(SiteFigure, WithoutAMarginThereIsNoRegionBeyondTheArea) {
  Site site = PlainSquare();
  site.area.margin = 0.0;
  EXPECT_THAT(SiteSvg(site), Not(HasSubstr("operating region")));
}

TEST(SiteFigure, TheBorderBeyondANarrowBayIsInPieces) {
  Site site = PlainSquare();
  site.area.outline = "0,0:40,0:40,40:20,40:0,20";
  const std::size_t without_bay = CountOf(SiteSvg(site), "<path");
  site.area.outline = "0,0:40,0:40,40:22,40:22,20:18,20:18,40:0,40";
  EXPECT_EQ(CountOf(SiteSvg(site), "<path"), without_bay + 1) << "5 m do not fit into its 4 m";
}

}  // namespace
}  // namespace limpet

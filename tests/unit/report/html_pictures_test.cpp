// SPDX-License-Identifier: MIT
#include "limpet/report/html_pictures.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

using testing::HasSubstr;
using testing::Not;

PicturedObject Ball() {
  return {.id = 3,
          .color = "yellow",
          .decided = Status::kNew,
          .truth = "OPI 5",
          .chips = {{.exposure = Seconds(1100.0),
                     .box = {.confidence = 0.875, .color = "yellow"},
                     .jpeg = "abc"}}};
}

TEST(PicturesOfObjects, StandInThePageItself) {
  const std::string page = PicturesOf({Ball()}, Seconds(1000.0));
  EXPECT_THAT(page, HasSubstr("src=\"data:image/jpeg;base64,YWJj\""));
  EXPECT_THAT(page, HasSubstr("yellow 0.88, after 100 s"));
  EXPECT_THAT(page, HasSubstr("<b>OPI 5 (id 3, yellow)</b> new"));
}

TEST(PicturesOfObjects, NameNobodysTruthWhereThereIsNone) {
  PicturedObject ball = Ball();
  ball.truth.clear();
  EXPECT_THAT(PicturesOf({ball}, Seconds(0.0)), HasSubstr("<b>id 3, yellow</b>"));
}

TEST(PicturesOfObjects, AreNotSpokenOfWithoutAny) { EXPECT_EQ(PicturesOf({}, Seconds(0.0)), ""); }

TEST(PicturesOfObjects, TakeAClassForTextAlone) {
  PicturedObject ball = Ball();
  ball.color = "<script>";
  ball.chips.front().box.color = "\"><script>";
  EXPECT_THAT(PicturesOf({ball}, Seconds(0.0)), Not(HasSubstr("<script>")));
}

}  // namespace
}  // namespace limpet

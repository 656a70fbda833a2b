// SPDX-License-Identifier: MIT
#include "limpet/shapes/shape.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/shapes/shape_board.hpp"

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(Shape, PointIsWrittenAsViewersWriteIt) {
  const Shape home{.label = "alpha_home",
                   .form = PointShape{{12.345, -0.001}},
                   .style = {.vertex_color = "dodger_blue", .vertex_size = 4.0}};
  EXPECT_EQ(VariableOf(home), "VIEW_POINT");
  EXPECT_EQ(EncodeShape(home),
            "x=12.35,y=0,label=alpha_home,vertex_color=dodger_blue,vertex_size=4");
}

TEST(Shape, LinesHaveOneDecimalAndNoTrailingZeros) {
  const Shape path{.label = "alpha_path",
                   .form = SeglistShape{{{0, 0}, {10.06, -3.0}, {20.52, 7.25}}},
                   .style = {.edge_color = "white", .edge_size = 1.0}};
  EXPECT_EQ(EncodeShape(path),
            "pts={0,0:10.1,-3:20.5,7.2},label=alpha_path,edge_color=white,edge_size=1");
}

TEST(Shape, PolygonCircleAndMarkerAreWrittenAsViewersWriteThem) {
  EXPECT_EQ(EncodeShape({.label = "a", .form = PolygonShape{{{-18, -15}, {18, -15}, {18, 15}}}}),
            "pts={-18,-15:18,-15:18,15},label=a");
  EXPECT_EQ(EncodeShape({.label = "c", .form = CircleShape{{1, 4}, 0.256}}),
            "x=1,y=4,radius=0.26,label=c");
  EXPECT_EQ(EncodeShape(
                {.label = "opi_3",
                 .form =
                     MarkerShape{
                         .at = {1, 4}, .width = 1.5, .type = "diamond", .primary_color = "green"}}),
            "x=1,y=4,width=1.5,primary_color=green,type=diamond,label=opi_3");
}

TEST(Shape, AnErasedOneKeepsItsPlaceSoThatViewersCanReadIt) {
  EXPECT_EQ(EncodeShape({.label = "c", .form = CircleShape{{1, 4}, 2}, .is_active = false}),
            "x=1,y=4,radius=2,active=false,label=c");
}

TEST(Shape, ALabelCannotBreakTheText) {
  EXPECT_EQ(EncodeShape({.label = "a,b={c}\n\"d\"", .form = PointShape{}}),
            "x=0,y=0,label=a_b__c___d_");
}

TEST(Shape, NorthIsYAndEastIsX) { EXPECT_EQ(MapPointOf({3.0, 7.0}), (MapPoint{7.0, 3.0})); }

/// A shape whose numbers survive the rounding of its text.
Shape RandomShape(Random& random) {
  const auto number = [&random](double step) {
    return step * (static_cast<double>(random.Index(40001)) - 20000.0);
  };
  const auto place = [&] { return MapPoint{number(0.01), number(0.01)}; };
  std::vector<MapPoint> line;
  for (auto i = 1 + random.Index(30); i > 0; --i) {
    line.push_back({number(0.1), number(0.1)});
  }
  Shape shape{.label = "shape_" + std::to_string(random.Index(100)), .form = PointShape{}};
  switch (random.Index(5)) {
    case 0:
      shape.form = PointShape{place()};
      break;
    case 1:
      shape.form = SeglistShape{line};
      break;
    case 2:
      shape.form = PolygonShape{line};
      break;
    case 3:
      shape.form = CircleShape{place(), number(0.01)};
      break;
    default:
      shape.form = MarkerShape{
          .at = place(), .width = number(0.01), .type = "square", .primary_color = "red"};
  }
  if (random.Chance(0.5)) {
    shape.style = {
        .msg = "said", .edge_color = "white", .vertex_size = 2.0, .fill_transparency = 0.25};
  }
  shape.is_active = random.Chance(0.75);
  return shape;
}

TEST(Shape, ComesBackFromItsText) {
  Random random(1, "shapes");
  for (int i = 0; i < 500; ++i) {
    const Shape shape = RandomShape(random);
    const std::string text = EncodeShape(shape);
    const auto back = DecodeShape(VariableOf(shape), text);
    ASSERT_TRUE(back) << text;
    EXPECT_EQ(EncodeShape(*back), text);
    EXPECT_EQ(back->form.index(), shape.form.index());
    EXPECT_EQ(back->style, shape.style);
    EXPECT_EQ(back->is_active, shape.is_active);
  }
}

TEST(Shape, WithoutItsGeometryIsNone) {
  EXPECT_FALSE(DecodeShape("VIEW_POINT", "x=1,label=a"));
  EXPECT_FALSE(DecodeShape("VIEW_SEGLIST", "pts={1,2:3},label=a"));
  EXPECT_FALSE(DecodeShape("VIEW_CIRCLE", "x=1,y=2"));
  EXPECT_FALSE(DecodeShape("VIEW_GRID", "x=1,y=2"));
}

class ShapeBoardTest : public ::testing::Test {
 protected:
  std::vector<std::string> posts_;
  ShapeBoard board_{[this](const std::string& variable, const std::string& text) {
    posts_.push_back(variable + " " + text);
  }};
};

TEST_F(ShapeBoardTest, PostsAShapeOnlyWhenItChanges) {
  board_.Draw({.label = "a", .form = PointShape{{1, 2}}});
  board_.Draw({.label = "a", .form = PointShape{{1, 2.001}}});
  board_.Draw({.label = "a", .form = PointShape{{1, 3}}});
  EXPECT_THAT(posts_, ElementsAre("VIEW_POINT x=1,y=2,label=a", "VIEW_POINT x=1,y=3,label=a"));
}

TEST_F(ShapeBoardTest, ErasesWhatIsGoneAndNothingElse) {
  board_.Draw({.label = "home", .form = PointShape{{0, 0}}});
  board_.Replace("opi_", {{.label = "opi_1", .form = PointShape{{1, 1}}},
                          {.label = "opi_2", .form = PointShape{{2, 2}}}});
  posts_.clear();
  board_.Replace("opi_", {{.label = "opi_2", .form = PointShape{{2, 2}}}});
  EXPECT_THAT(posts_, ElementsAre("VIEW_POINT x=1,y=1,active=false,label=opi_1"));
  posts_.clear();
  board_.Replace("opi_", {{.label = "opi_2", .form = PointShape{{2, 2}}}});
  EXPECT_THAT(posts_, IsEmpty());
}

}  // namespace
}  // namespace limpet

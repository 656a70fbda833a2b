// SPDX-License-Identifier: MIT
// What every figure of a report must hold: each mark where it belongs, each name, no broken number.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <set>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/core/units.hpp"
#include "limpet/figures/figures.hpp"
#include "limpet/figures/map_axes.hpp"
#include "limpet/figures/map_symbols.hpp"
#include "limpet/objects/status_posterior.hpp"
#include "tests/support/synthetic_session.hpp"
#include "tests/unit/figures/svg_reader.hpp"

namespace limpet {
namespace {

using ::testing::AnyOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// A change session over Table 1 whose every object is right; made once, it is a long survey.
struct DrawnSession {
  explicit DrawnSession(double error_m = 0.2)
      : record([&] {
          SyntheticSession session;
          session.name = "change";
          session.lane_spacing_m = 5.0;
          session.opis = RightBeliefs(scenario, "change", error_m);
          return RecordOf(session);
        }()),
        score(ScoreSession(record, scenario, settings)) {}
  [[nodiscard]] FigureSource source() const { return {record, score, settings, scenario}; }

  Scenario scenario = Table1Scenario();
  ReportSettings settings = Table1Settings();
  SessionRecord record;
  SessionScore score;
};

const DrawnSession& Drawn() {
  static const DrawnSession session;
  return session;
}

std::size_t CirclesAt(const std::vector<SvgElement>& elements, const SvgCanvas::Point& at,
                      double radius) {
  return static_cast<std::size_t>(std::ranges::count_if(elements, [&](const SvgElement& e) {
    return e.name == "circle" && std::abs(e.Number("cx") - at.x()) < 0.02 &&
           std::abs(e.Number("cy") - at.y()) < 0.02 && std::abs(e.Number("r") - radius) < 0.02;
  }));
}

std::vector<std::string> TextsIn(const std::vector<SvgElement>& elements) {
  std::vector<std::string> texts;
  for (const SvgElement& element : elements) {
    if (element.name == "text") texts.push_back(element.text);
  }
  return texts;
}

TEST(EveryFigure, IsSoundSvgWithoutABrokenNumber) {
  const std::set<std::string> lengths{
      "x",  "y",  "x1", "y1",    "x2",     "y2",           "cx",      "cy",
      "rx", "ry", "r",  "width", "height", "stroke-width", "opacity", "font-size"};
  for (const Figure& figure : FiguresOf(Drawn().source())) {
    SCOPED_TRACE(figure.file);
    const std::vector<SvgElement> elements = ReadSvg(figure.svg);
    EXPECT_GT(elements.size(), 20U);
    EXPECT_EQ(elements.at(0).name, "svg");
    for (const SvgElement& element : elements) {
      for (const auto& [name, value] : element.attributes) {
        if (lengths.contains(name)) {
          EXPECT_TRUE(ParseNumber(value)) << name << "=" << value;
        }
        if (name == "d" || name == "transform") {
          EXPECT_THAT(value, Not(AnyOf(HasSubstr("nan"), HasSubstr("inf"))));
        }
        if (name == "r" || name == "rx" || name == "ry" || name == "width" || name == "height") {
          EXPECT_GE(element.Number(name), 0.0);
        }
      }
    }
  }
}

TEST(EveryFigure, KeepsItsTextsInsideItsPicture) {
  for (const Figure& figure : FiguresOf(Drawn().source())) {
    const std::vector<SvgElement> elements = ReadSvg(figure.svg);
    const double width = elements.at(0).Number("width"), height = elements.at(0).Number("height");
    for (const SvgElement& element : elements) {
      if (element.name != "text") continue;
      EXPECT_GE(element.Number("x"), 0.0) << figure.file << ": " << element.text;
      EXPECT_LE(element.Number("x"), width) << figure.file << ": " << element.text;
      EXPECT_GE(element.Number("y"), 0.0) << figure.file << ": " << element.text;
      EXPECT_LE(element.Number("y"), height) << figure.file << ": " << element.text;
    }
  }
}

/// The corners of the box around all that a path draws.
std::array<SvgCanvas::Point, 2> BoxOfPath(const std::string& data) {
  std::array<SvgCanvas::Point, 2> box{SvgCanvas::Point::Constant(1e9),
                                      SvgCanvas::Point::Constant(-1e9)};
  for (const char* at = data.c_str(); *at != '\0';) {
    char* end = nullptr;
    const double x = std::strtod(at + 1, &end), y = std::strtod(end, &end);
    box = {box[0].cwiseMin(SvgCanvas::Point(x, y)), box[1].cwiseMax(SvgCanvas::Point(x, y))};
    at = end;
  }
  return box;
}

TEST(TrackFigure, ShowsAllOfTheWayAndItsLegendAlthoughTheAreaIsNarrowAndFarOff) {
  SessionRecord record = Drawn().record;
  record.area = SurveyArea{.north_min = 20.0, .north_max = 24.0, .east_min = 0.0, .east_max = 90.0};
  const Figure figure = TrackFigure({record, Drawn().score, Drawn().settings, Drawn().scenario});
  const std::vector<SvgElement> elements = ReadSvg(figure.svg);
  const auto clip = std::ranges::find(elements, "clipPath", &SvgElement::name) + 1;
  ASSERT_EQ(clip->name, "rect");
  const auto track = std::ranges::find(elements, "path", &SvgElement::name);
  ASSERT_NE(track, elements.end());
  const auto [low, high] = BoxOfPath(track->attributes.at("d"));
  EXPECT_GE(low.x(), clip->Number("x"));
  EXPECT_GE(low.y(), clip->Number("y"));
  EXPECT_LE(high.x(), clip->Number("x") + clip->Number("width"));
  EXPECT_LE(high.y(), clip->Number("y") + clip->Number("height"));
  for (const SvgElement& element : elements) {
    if (element.name != "text") continue;
    EXPECT_LE(element.Number("y"), elements.at(0).Number("height")) << element.text;
  }
}

TEST(EveryFigure, HasAFileOfItsOwnATitleAndACaption) {
  std::set<std::string> files;
  for (const Figure& figure : FiguresOf(Drawn().source())) {
    EXPECT_TRUE(files.insert(figure.file).second) << figure.file;
    EXPECT_TRUE(figure.file.starts_with("change_") && figure.file.ends_with(".svg"));
    EXPECT_TRUE(figure.caption.ends_with('.')) << figure.caption;
    const auto elements = ReadSvg(figure.svg);
    const auto title = std::ranges::find(elements, "title", &SvgElement::name);
    ASSERT_NE(title, elements.end());
    EXPECT_THAT(title->text, Not(IsEmpty())) << "what screen readers say";
  }
  EXPECT_EQ(files.size(), 8U) << "track, status, objects, close-ups, beliefs, coverage, depth, nav";
}

TEST(EveryFigure, IsTheSameDrawnTwice) {
  const auto once = FiguresOf(Drawn().source()), twice = FiguresOf(Drawn().source());
  for (std::size_t i = 0; i < once.size(); ++i)
    EXPECT_EQ(once[i].svg, twice[i].svg);
}

TEST(EveryFigure, ShowsAMissionsNameAsTextWhateverItIs) {
  const DrawnSession& drawn = Drawn();
  ReportSettings settings = drawn.settings;
  settings.mission = "<script>\"&";
  for (const Figure& figure : FiguresOf({drawn.record, drawn.score, settings, drawn.scenario})) {
    const auto elements = ReadSvg(figure.svg);
    EXPECT_EQ(std::ranges::count(elements, "script", &SvgElement::name), 0) << figure.file;
  }
}

TEST(ObjectsFigure, HasARingOfTrueSizeAroundEveryTrueObject) {
  const DrawnSession& drawn = Drawn();
  const MapAxes map(AreaOf(drawn.record), "t", "s");
  const auto elements = ReadSvg(ObjectsFigure(drawn.source()).svg);
  int there = 0;
  for (const ScenarioOpi& opi : drawn.scenario.opis) {
    const auto place = opi.Place("change");
    if (!place) continue;
    ++there;
    EXPECT_EQ(CirclesAt(elements, map.At(place->head<2>()), opi.radius_m * map.pixels_per_metre()),
              1U)
        << opi.name;
  }
  EXPECT_EQ(there, 3);
}

TEST(ObjectsFigure, PutsEachClusterWhereTheMapHasItAndNamesItsObject) {
  const DrawnSession& drawn = Drawn();
  const MapAxes map(AreaOf(drawn.record), "t", "s");
  const auto elements = ReadSvg(ObjectsFigure(drawn.source()).svg);
  const auto texts = TextsIn(elements);
  for (const OpiScore& opi : drawn.score.opis.found) {
    EXPECT_THAT(texts, Contains(opi.truth));
    const Eigen::Vector3d& centroid_W = opi.belief.centroid_W;
    EXPECT_EQ(CirclesAt(elements, map.At(centroid_W.head<2>()), 2.6), 1U);
  }
  EXPECT_EQ(drawn.score.opis.found.size(), 3U);
  EXPECT_THAT(texts, Contains("Objects found: 3 of 3, 0 invented"));
}

TEST(ChangeFigure, NamesEveryObjectWithWhatWasDecidedOfIt) {
  const DrawnSession& drawn = Drawn();
  const auto elements = ReadSvg(ChangeFigure(drawn.source()).svg);
  const auto texts = TextsIn(elements);
  ASSERT_EQ(drawn.score.opis.changes.size(), 5U);
  for (const ChangeScore& change : drawn.score.opis.changes) {
    EXPECT_THAT(texts, Contains(*change.truth));
    EXPECT_THAT(texts, Contains(HasSubstr(std::string(NameOf(change.decided)))));
  }
  EXPECT_THAT(texts, Contains("What changed: 5 of 5 statuses right"));
}

TEST(ChangeFigure, RingsADecisionThatIsWrong) {
  const DrawnSession& drawn = Drawn();
  SessionScore wrong = drawn.score;
  wrong.opis.changes[0].decided = Status::kRemoved;
  const MapAxes map(AreaOf(drawn.record), "t", "s");
  const auto elements =
      ReadSvg(ChangeFigure({drawn.record, wrong, drawn.settings, drawn.scenario}).svg);
  const Eigen::Vector3d place = *wrong.opis.changes[0].p_W;
  EXPECT_EQ(CirclesAt(elements, map.At(place.head<2>()), 14.0), 1U);
  EXPECT_THAT(TextsIn(elements), Contains(HasSubstr("wrong: confirmed")));
  EXPECT_THAT(TextsIn(elements), Contains("What changed: 4 of 5 statuses right"));
}

TEST(ChangeFigure, TellsNotInspectedFromUncertain) {
  const auto texts = TextsIn(ReadSvg(ChangeFigure(Drawn().source()).svg));
  EXPECT_THAT(texts, Contains(HasSubstr("uncertain: ")));
  EXPECT_THAT(texts, Contains(HasSubstr("not inspected: ")));
}

TEST(CloseUpFigure, HasAPanelForEachObjectThatWasFound) {
  const DrawnSession& drawn = Drawn();
  const auto texts = TextsIn(ReadSvg(CloseUpFigure(drawn.source()).svg));
  EXPECT_EQ(std::ranges::count(texts, "1 m"), 3);
  for (const OpiScore& opi : drawn.score.opis.found) {
    EXPECT_THAT(texts, Contains(opi.truth));
    EXPECT_THAT(texts, Contains(fmt::format("{:.2f} m off", opi.error_m)));
  }
}

TEST(Figures, OfASessionWithoutASurveyShowWhatThereIs) {
  const SessionRecord record("discovery");
  const ReportSettings settings = Table1Settings();
  const Scenario scenario = Table1Scenario();
  const SessionScore score = ScoreSession(record, scenario, settings);
  for (const Figure& figure : FiguresOf({record, score, settings, scenario})) {
    EXPECT_THAT(figure.svg, Not(AnyOf(HasSubstr("nan"), HasSubstr("inf")))) << figure.file;
    EXPECT_THAT(ReadSvg(figure.svg), Not(IsEmpty()));
  }
}

TEST(MapSymbols, TellStatusesApartByShapeToo) {
  std::set<std::string> shapes;
  for (const Status status : {Status::kConfirmed, Status::kRemoved, Status::kNew, Status::kMoved,
                              Status::kUncertain, Status::kNotInspected}) {
    SvgCanvas canvas({40.0, 40.0}, "one symbol");
    DrawStatus(canvas, {20.0, 20.0}, status);
    std::string shape;
    for (const SvgElement& element : ReadSvg(canvas.Finish())) {
      const auto d = element.attributes.find("d");
      shape += element.name + (d == element.attributes.end() ? "" : d->second);
    }
    EXPECT_TRUE(shapes.insert(shape).second) << NameOf(status) << " looks like another one";
  }
}

TEST(MapSymbols, ACovariancesEllipseHasItsAxesAndItsTurn) {
  Random random(1, "ellipses");
  for (int run = 0; run < 200; ++run) {
    const double major = random.Uniform(0.5, 2.0), minor = random.Uniform(0.1, 0.4);
    const double bearing = random.Uniform(-1.5, 1.5);  // of the major axis, from north
    const double c = std::cos(bearing), s = std::sin(bearing);
    const std::array<double, 3> cov{major * major * c * c + minor * minor * s * s,
                                    (major * major - minor * minor) * c * s,
                                    major * major * s * s + minor * minor * c * c};
    SvgCanvas canvas({100.0, 100.0}, "ellipse");
    DrawCovariance(canvas, {50.0, 50.0}, 10.0, cov, {.stroke = palette::kBlue});
    const SvgElement ellipse = ReadSvg(canvas.Finish()).back();
    EXPECT_NEAR(ellipse.Number("rx"), 10.0 * major, 0.011);
    EXPECT_NEAR(ellipse.Number("ry"), 10.0 * minor, 0.011);
    double turn = 0.0;
    ASSERT_EQ(std::sscanf(ellipse.attributes.at("transform").c_str(),
                          "translate(50 50) rotate(%lf)", &turn),
              1);
    // North is up: what points to the bearing b is turned b - 90 degrees from the x axis.
    EXPECT_NEAR(std::remainder(turn - (DegreesFromRadians(bearing) - 90.0), 180.0), 0.0, 0.02);
  }
}

}  // namespace
}  // namespace limpet

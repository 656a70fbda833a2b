// SPDX-License-Identifier: MIT
// A small area that is no rectangle, with a zone to keep out of, from a start outside: it is
// covered, the vehicle stays where it may be, and comes home.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "limpet/planning/region.hpp"
#include "limpet/runs/run_settings.hpp"
#include "limpet/runs/session_runner.hpp"
#include "limpet/scoring/coverage_score.hpp"
#include "limpet/topics/survey_phase.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMission = R"(ServerHost   = localhost
ServerPort   = 9000
Community    = limpet
MOOSTimeWarp = 1
LatOrigin    = 43.7210
LongOrigin   = 10.2830
#define AREA pts={-14,-12:14,-12:14,2:0,2:0,12:-14,12}
#define KEEP_OUT pts={-5,-4:-3,-4:-3,-2:-5,-2}
#define TRANSIT pts={19,-3}
#define BAND 0.5
survey_altitude_m = 4
object_radius_m   = 0.5
#include plug_survey.moos
)";

constexpr const char* kScenario = R"(
seabed:  {depth_m: 7.5, slope_deg: 0, slope_toward_deg: 0, roughness_m: 0.05, seed: 1}
water:   {visibility_m: 8, current_north_mps: 0, current_east_mps: 0}
start:   {north_m: 8, east_m: 18, heading_deg: 180}
opis:
  - {name: OPI 1, color: yellow, radius_m: 0.5, discovery: [-3, 6, 7.3], change: [-3, 6, 7.3]}
camera:  boxes
sensors: {dvl_dropout_per_min: 0, dvl_outlier_share: 0, yaw_bias_deg_per_h: 1, heading_sigma_deg: 0.5, gps_sigma_m: 0.4, false_detections_per_image: 0.01}
)";

/// A mission folder with these two files and table1's behaviors.
void WriteMission(const fs::path& folder) {
  fs::create_directories(folder);
  std::ofstream(folder / "mission.moos") << kMission;
  std::ofstream(folder / "mission.bhv") << "#include plug_survey.bhv\n";
  std::ofstream(folder / "scenario.yaml") << kScenario;
}

/// How far the true way is outside the region once it has been inside, until it leaves for home,
/// and how near it comes to a zone, or how deep into it [m].
struct Trespass {
  double outside = 0.0;
  double in_zone = -1e9;
};

Trespass TrespassOf(const SessionRecord& record, const SurveyArea& area) {
  const Region region(area);
  const SurveyShape shape = *SurveyShape::Of(area);
  const double home = record.PhaseStart(SurveyPhase::kReturn).value_or(Seconds(1e9)).value();
  Trespass worst;
  bool has_entered = false;
  for (std::size_t i = 0; i < record.truth.size(); ++i) {
    const PlanePoint at(record.truth.north(i), record.truth.east(i));
    for (const SimplePolygon& zone : shape.zones()) {
      worst.in_zone = std::max(worst.in_zone, zone.Depth(at));
    }
    const double outside = region.Outside({at.x(), at.y(), 0.0});
    has_entered = has_entered || outside <= 0.0;
    if (has_entered && record.truth.time(i) < home)
      worst.outside = std::max(worst.outside, outside);
  }
  return worst;
}

TEST(ShapedArea, IsCoveredFromInsideItsRegionAndOutsideItsZones) {
  const TemporaryFolder folder;
  const fs::path mission_folder = folder.path() / "mission";
  WriteMission(mission_folder);
  MissionFile mission = LoadMission(mission_folder / "mission.moos");
  ApplySetting(mission, "pSurvey.align_s=60");
  ApplySetting(mission, "pSurvey.last_fix_s=5");
  const SessionPlan plan{.session = "discovery",
                         .mission_folder = mission_folder,
                         .run_folder = folder.path() / "discovery",
                         .prior_folder = {},
                         .seed = 5};
  SessionRecord record("discovery");
  const SessionOutcome outcome =
      RunSession(mission, plan, [&record](const Message& message) { record.Collect(message); });
  EXPECT_EQ(outcome.ended, "home") << outcome.cut.value_or("");
  ASSERT_TRUE(record.area);
  ASSERT_FALSE(record.truth.empty());
  const std::size_t last = record.truth.size() - 1;
  EXPECT_LT(std::hypot(record.truth.north(last) - 8.0, record.truth.east(last) - 18.0), 3.0);

  const Trespass worst = TrespassOf(record, *record.area);
  // Navigation knows the place to some decimetres; the plan keeps half a metre.
  EXPECT_LT(worst.outside, 0.5);
  EXPECT_LT(worst.in_zone, 0.0);

  const Scenario scenario = LoadScenario(mission_folder / "scenario.yaml");
  const ReportSettings settings = SettingsOf(mission, scenario);
  const CoverageScore score =
      ScoreCoverage(FramesOfSurvey(record, settings), *record.area, scenario, settings, {});
  EXPECT_GT(score.covered, 0.95);
  EXPECT_GT(score.detected_band, 0.95);
}

}  // namespace
}  // namespace limpet

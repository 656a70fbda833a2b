// SPDX-License-Identifier: MIT
#include "limpet/scoring/fence_score.hpp"

#include <algorithm>
#include <cstddef>

#include "limpet/planning/region.hpp"
#include "limpet/survey/survey_shape.hpp"
#include "limpet/topics/survey_phase.hpp"

namespace limpet {
namespace {

/// Where the vehicle is under way through the area; then it may leave it for home.
class SurveyPhases {
 public:
  explicit SurveyPhases(const SessionRecord& record) : phases_(record.phases) {}

  /// REQUIRES: times that do not go back.
  [[nodiscard]] bool AreAt(double time) {
    while (next_ < phases_.size() && phases_[next_].time.value() <= time) {
      is_surveying_ = phases_[next_].value == NameOf(SurveyPhase::kSurvey);
      ++next_;
    }
    return is_surveying_;
  }

 private:
  const std::vector<Stamped<std::string>>& phases_;
  std::size_t next_ = 0;
  bool is_surveying_ = false;
};

}  // namespace

std::optional<FenceScore> ScoreFences(const SessionRecord& record) {
  if (!record.area) return std::nullopt;
  const Expected<SurveyShape> shape = SurveyShape::Of(*record.area);
  if (!shape) return std::nullopt;
  SurveyArea without_zones = *record.area;
  without_zones.keep_out.reset();
  const Region region(without_zones);
  FenceScore score;
  SurveyPhases surveys(record);
  bool was_inside = false;
  for (std::size_t i = 0; i < record.truth.size(); ++i) {
    const PlanePoint at(record.truth.north(i), record.truth.east(i));
    for (const SimplePolygon& zone : shape->zones())
      score.inside_zone_m = std::max(score.inside_zone_m, zone.Depth(at));
    if (!surveys.AreAt(record.truth.time(i))) continue;
    const double outside = region.Outside({.north = at.x(), .east = at.y(), .yaw = 0.0});
    was_inside = was_inside || outside <= 0.0;
    if (was_inside) score.outside_region_m = std::max(score.outside_region_m, outside);
  }
  return score;
}

}  // namespace limpet

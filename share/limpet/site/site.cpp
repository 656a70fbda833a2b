// SPDX-License-Identifier: MIT
#include "limpet/site/site.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "limpet/preflight/survey_facts.hpp"

namespace limpet {

namespace fs = std::filesystem;

std::string Site::Summary() const {
  std::string text =
      fmt::format("{:.0f} m2 to be seen; lanes and turns of about {:.0f} m", wanted_m2, path_m);
  if (speed_mps > 0.0) text += fmt::format(", {:.0f} s at {:g} m/s", path_m / speed_mps, speed_mps);
  if (const std::ptrdiff_t beyond = ZonesBeyond(*this); beyond > 0)
    text += fmt::format("; {} keep-out zone{} beyond the drawing", beyond, beyond > 1 ? "s" : "");
  return text;
}

void SiteBox::Take(const PlanePoint& at) {
  low_W = low_W.cwiseMin(at);
  high_W = high_W.cwiseMax(at);
}

double SiteBox::room() const { return std::max(1.0, 0.02 * (high_W - low_W).maxCoeff()); }

SiteBox BoxAround(const Site& site) {
  const SurveyShape shape = *SurveyShape::Of(site.area);
  SiteBox box{shape.outline().low(), shape.outline().high()};
  if (shape.region()) {
    box.Take(shape.region()->low());
    box.Take(shape.region()->high());
  } else {
    const PlanePoint margin(shape.margin(), shape.margin());
    box.Take(box.low_W - margin);
    box.Take(box.high_W + margin);
  }
  for (const PlanePoint& at : shape.transit())
    box.Take(at);
  if (site.start_W) box.Take(*site.start_W);
  return box;
}

std::ptrdiff_t ZonesBeyond(const Site& site) {
  const SurveyShape shape = *SurveyShape::Of(site.area);
  const SiteBox box = BoxAround(site);
  const PlanePoint room(box.room(), box.room());
  const PlanePoint low = box.low_W - room, high = box.high_W + room;
  return std::ranges::count_if(shape.zones(), [&](const SimplePolygon& zone) {
    return (zone.high().array() < low.array()).any() || (zone.low().array() > high.array()).any();
  });
}

std::optional<Site> SiteOf(const fs::path& path, const MissionChange& change) {
  const fs::path file = MissionFileAt(path);
  if (file.extension() != ".moos" || !fs::exists(file)) return std::nullopt;
  try {
    MissionFile mission = LoadMission(file);
    if (change) change(mission);
    const MissionReading reading(mission, file.parent_path());
    const std::optional<SurveyFacts> facts = ReadSurveyFacts(reading);
    if (!facts || facts->problem || facts->wanted_m2 <= 0.0) return std::nullopt;
    Site site{.name = fs::weakly_canonical(file).parent_path().filename().string(),
              .area = facts->area,
              .start_W = {},
              .wanted_m2 = facts->wanted_m2,
              .path_m = EstimatePath(*facts, reading.Find("pSurvey", "coverage_kind")->text,
                                     reading.Find("pSurvey", "coverage_target")->number())
                            .total(),
              .speed_mps = facts->speed.number()};
    if (reading.scenario()) {
      site.start_W.emplace(reading.scenario()->start.north_m, reading.scenario()->start.east_m);
    }
    return site;
  } catch (const ConfigError&) {
    return std::nullopt;  // the check says what is wrong
  }
}

}  // namespace limpet

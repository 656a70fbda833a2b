// SPDX-License-Identifier: MIT
#include "limpet/scoring/unseen_places.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

#include "limpet/planning/region_fences.hpp"
#include "limpet/planning/room.hpp"
#include "limpet/survey/survey_shape.hpp"

namespace limpet {
namespace {

/// Cells where something is so, and whether one of them is near a place.
class Places {
 public:
  Places(const FreeSpace& space, std::vector<std::uint8_t> is_one)
      : raster_(space.raster()), is_one_(std::move(is_one)) {}

  [[nodiscard]] bool HasWithin(double distance, const PlanePoint& at) const {
    const double reach = distance + raster_.slack();
    const PlanePoint middle = (at - raster_.origin_W) / raster_.cell_m;
    const int span = static_cast<int>(std::ceil(reach / raster_.cell_m));
    const auto range = [span](double coordinate, int count) {
      const int cell = static_cast<int>(std::lround(coordinate));
      return std::pair{std::clamp(cell - span, 0, count), std::clamp(cell + span + 1, 0, count)};
    };
    const auto [row_begin, row_end] = range(middle.x(), raster_.rows);
    const auto [column_begin, column_end] = range(middle.y(), raster_.columns);
    for (int row = row_begin; row < row_end; ++row) {
      for (int column = column_begin; column < column_end; ++column) {
        const auto cell =
            static_cast<std::size_t>(row) * static_cast<std::size_t>(raster_.columns) +
            static_cast<std::size_t>(column);
        if (is_one_[cell] != 0 && (raster_.Center(cell) - at).norm() <= reach) return true;
      }
    }
    return false;
  }

 private:
  FreeSpace::Raster raster_;
  std::vector<std::uint8_t> is_one_;
};

FreeSpace SpaceOf(const SurveyShape& shape, bool heeds_zones) {
  std::vector<Fence> fences{HoldingFence(shape, Meters(shape.margin()), Meters(0.0))};
  if (heeds_zones) std::ranges::move(ZoneFences(shape, Meters(0.0)), std::back_inserter(fences));
  return FreeSpace(std::move(fences));
}

}  // namespace

/// Where the vehicle may be at all, and the centres of its turns.
struct UnseenCounter::Reachable {
  Reachable(const FreeSpace& space, double turning_radius)
      : free(space, FreeCells(space)), turns(space, RoomToTurn(space, turning_radius)) {}

  static std::vector<std::uint8_t> FreeCells(const FreeSpace& space) {
    std::vector<std::uint8_t> cells;
    for (const float clearance : space.raster().clearance)
      cells.push_back(clearance >= 0.0F ? 1 : 0);
    return cells;
  }
  Places free, turns;
};

const char* NameOf(WhyUnseen why) {
  constexpr std::array kNames{"zone",          "clearance",   "turn",
                              "too_few_looks", "not_reached", "obstacle"};
  return kNames[static_cast<std::size_t>(why)];
}

WhyUnseen UnseenScore::main_reason() const {
  return static_cast<WhyUnseen>(std::ranges::max_element(band_by_reason) - band_by_reason.begin());
}

UnseenCounter::UnseenCounter(const SurveyArea& area, const ReportSettings& settings)
    : altitude_(settings.altitude_m),
      half_across_(settings.camera_geometry.half_across()),
      turning_radius_(settings.turning_radius_m) {
  const auto shape = SurveyShape::Of(area);
  if (!shape) return;
  with_zones_ = std::make_unique<const Reachable>(SpaceOf(*shape, true), turning_radius_);
  if (!shape->zones().empty()) {
    without_zones_ = std::make_unique<const Reachable>(SpaceOf(*shape, false), turning_radius_);
  }
}

UnseenCounter::~UnseenCounter() = default;

WhyUnseen UnseenCounter::WhyOf(const UnseenPlace& place) const {
  if (place.was_hidden && !place.was_seen) return WhyUnseen::kObstacle;
  if (!with_zones_) return WhyUnseen::kNotReached;
  const double sight = std::max(altitude_ - place.height_m, 0.0) * half_across_;
  const double reach = turning_radius_ + sight;
  if (with_zones_->turns.HasWithin(reach, place.at_W)) {
    return place.was_seen ? WhyUnseen::kTooFewLooks : WhyUnseen::kNotReached;
  }
  if (without_zones_ && without_zones_->turns.HasWithin(reach, place.at_W)) {
    return WhyUnseen::kZone;
  }
  return with_zones_->free.HasWithin(sight, place.at_W) ? WhyUnseen::kTurn : WhyUnseen::kClearance;
}

void UnseenCounter::Add(const UnseenPlace& place) {
  ++counts_[static_cast<std::size_t>(WhyOf(place))];
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "apps/pMap/obstacle_notices.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace limpet {
namespace {

std::string NoticeName(const Obstacle& obstacle) { return fmt::format("ob_{}", obstacle.id); }

std::string AlertOf(const Obstacle& obstacle) {
  std::string points;
  for (const auto& [north, east] : obstacle.outline) {
    points += fmt::format("{}{:.2f},{:.2f}", points.empty() ? "" : ":", east, north);
  }
  const std::string name = NoticeName(obstacle);
  return fmt::format("name={}#poly=pts={{{}}},label={}#id={}", name, points, name, name);
}

std::string FoundText(const Obstacle& obstacle) {
  double north = 0.0, east = 0.0;
  for (const auto& [corner_north, corner_east] : obstacle.outline) {
    north += corner_north / static_cast<double>(obstacle.outline.size());
    east += corner_east / static_cast<double>(obstacle.outline.size());
  }
  return fmt::format("{} stands about {:.1f} north, {:.1f} east, up to {:.1f} m deep",
                     NoticeName(obstacle), north, east, std::max(0.0, obstacle.top));
}

}  // namespace

ObstacleNotices::News ObstacleNotices::Of(const std::vector<Obstacle>& obstacles) {
  News news;
  for (const Obstacle& obstacle : obstacles) {
    const auto former = std::ranges::find(told_, obstacle.id, &Obstacle::id);
    if (former == told_.end()) news.found.push_back(FoundText(obstacle));
    if (former == told_.end() || former->outline != obstacle.outline) {
      news.alerts.push_back(AlertOf(obstacle));
    }
  }
  for (const Obstacle& told : told_) {
    if (std::ranges::find(obstacles, told.id, &Obstacle::id) == obstacles.end()) {
      news.resolved.push_back(NoticeName(told));
    }
  }
  told_ = obstacles;
  return news;
}

}  // namespace limpet

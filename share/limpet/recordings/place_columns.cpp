// SPDX-License-Identifier: MIT
#include "limpet/recordings/place_columns.hpp"

#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>

#include <Eigen/Core>
#include <fmt/format.h>

namespace limpet {
namespace {

std::optional<Eigen::Vector2d> PlaceOf(const std::string& line) {
  std::istringstream words(line);
  double east = 0.0, north = 0.0;
  std::string more;
  if (!(words >> east >> north) || words >> more) return std::nullopt;
  if (!std::isfinite(east) || !std::isfinite(north)) return std::nullopt;
  return Eigen::Vector2d(north, east);
}

}  // namespace

std::string PlaceColumnsText(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::optional<Eigen::Vector2d> last;
  std::size_t places = 0;
  double path_m = 0.0;
  for (std::string line; std::getline(in, line);) {
    const std::optional<Eigen::Vector2d> place = PlaceOf(line);
    if (!place) return "";
    if (last) path_m += (*place - *last).norm();
    last = place;
    ++places;
  }
  if (places < 2) return "";
  return fmt::format(
      "{}: two columns of {} numbers: if they are NAV_X and NAV_Y, a path of {:.1f} m; missing are "
      "time, heading, speed, depth and all sensors: no track can be reckoned",
      file.filename().string(), places, path_m);
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "estimation/mapping/obstacle_outline.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <utility>

#include <Eigen/Geometry>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace limpet {
namespace {

using Cells = std::vector<EchoCells::Cell>;

/// Cells that gaps as beams leave them between echoes do not part.
std::vector<Cells> Connected(const Cells& cells, double reach) {
  if (cells.empty()) return {};  // OpenCV 4.6 refers to the first
  std::vector<int> labels;
  const int count =
      cv::partition(cells, labels, [reach](const EchoCells::Cell& a, const EchoCells::Cell& b) {
        return (a.p_W - b.p_W).head<2>().norm() <= reach;
      });
  std::vector<Cells> groups(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < cells.size(); ++i) {
    groups[static_cast<std::size_t>(labels[i])].push_back(cells[i]);
  }
  return groups;
}

bool IsLong(const Cells& group) {
  Eigen::AlignedBox2d box;
  for (const EchoCells::Cell& cell : group) {
    box.extend(cell.p_W.head<2>());
  }
  return box.sizes().maxCoeff() > kLongestGroup;
}

/// By the squares of half that length that they lie in: fixed, so that pieces stay what they are as
/// more of a wall comes into sight.
std::vector<Cells> BySquares(const Cells& group) {
  std::map<std::pair<double, double>, Cells> squares;
  const auto square = [](double at) { return std::floor(2.0 * at / kLongestGroup); };
  for (const EchoCells::Cell& cell : group) {
    squares[{square(cell.p_W.x()), square(cell.p_W.y())}].push_back(cell);
  }
  std::vector<Cells> pieces;
  for (auto& [key, piece] : squares) {
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

}  // namespace

std::vector<Cells> GroupsOf(const Cells& cells, double cell_m) {
  constexpr double kGap = 3.0;  // cells
  std::vector<Cells> groups;
  for (Cells& group : Connected(cells, kGap * cell_m)) {
    if (!IsLong(group)) {
      groups.push_back(std::move(group));
    } else {
      std::ranges::move(BySquares(group), std::back_inserter(groups));
    }
  }
  return groups;
}

std::vector<std::array<double, 2>> OutlineOf(const Cells& group, double around) {
  constexpr double kOutlineTolerance = 0.1;  // [m]; whoever keeps off pays for each corner
  // OpenCV reckons in floats: near their own place, not the datum's.
  const Eigen::Vector2d origin = group.front().p_W.head<2>();
  std::vector<cv::Point2f> around_echoes, hull, outline;
  for (const EchoCells::Cell& cell : group) {
    const Eigen::Vector2d off = cell.p_W.head<2>() - origin;
    for (const double to_north : {-around, around}) {
      for (const double to_east : {-around, around}) {
        around_echoes.emplace_back(static_cast<float>(off.x() + to_north),
                                   static_cast<float>(off.y() + to_east));
      }
    }
  }
  cv::convexHull(around_echoes, hull);
  cv::approxPolyDP(hull, outline, kOutlineTolerance, true);
  std::vector<std::array<double, 2>> corners;
  for (const cv::Point2f& corner : outline) {
    corners.push_back(
        {origin.x() + static_cast<double>(corner.x), origin.y() + static_cast<double>(corner.y)});
  }
  return corners;
}

double Outside(const std::vector<std::array<double, 2>>& outline, const Eigen::Vector2d& p_W) {
  std::vector<cv::Point2f> corners;
  for (const auto& [corner_north, corner_east] : outline) {
    corners.emplace_back(static_cast<float>(corner_north - p_W.x()),
                         static_cast<float>(corner_east - p_W.y()));
  }
  return std::max(0.0, -cv::pointPolygonTest(corners, cv::Point2f(0.0F, 0.0F), true));
}

}  // namespace limpet

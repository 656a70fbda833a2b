// SPDX-License-Identifier: MIT
#include "limpet/detectors/network_cells.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace limpet {
namespace {

/// Channels before those of the colours.
enum Channel { kScore, kAcross, kDown, kWidth, kHeight, kFirstColor };

/// The planes of a network's output.
class Cells {
 public:
  Cells(const cv::Mat& output, const NetworkDescription& network)
      : output_(output), network_(network), rows_(output.size[2]), columns_(output.size[3]) {}

  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] double At(int channel, int row, int column) const {
    return static_cast<double>(
        output_.ptr<float>(0, channel)[static_cast<std::ptrdiff_t>(row) * columns_ + column]);
  }
  [[nodiscard]] NetworkFinding FindingAt(int row, int column) const {
    const auto size = [&](int channel) {
      return network_.size_unit_px * std::exp(std::clamp(At(channel, row, column), -4.0, 4.0));
    };
    const double u = (column + 0.5 + At(kAcross, row, column)) * network_.stride_px;
    const double v = (row + 0.5 + At(kDown, row, column)) * network_.stride_px;
    const double across = 0.5 * size(kWidth), down = 0.5 * size(kHeight);
    NetworkFinding finding{.rect = {u - across, v - down, u + across, v + down},
                           .score_logit = At(kScore, row, column)};
    SetColor(row, column, finding);
    return finding;
  }

 private:
  void SetColor(int row, int column, NetworkFinding& finding) const {
    const auto logit = [&](std::size_t color) {
      return At(kFirstColor + static_cast<int>(color), row, column);
    };
    for (std::size_t color = 1; color < network_.colors.size(); ++color) {
      if (logit(color) > logit(finding.color)) finding.color = color;
    }
    // log p / (1 - p) of a softmax: against the sum of all others.
    double others = 0.0;
    for (std::size_t color = 0; color < network_.colors.size(); ++color) {
      if (color != finding.color) others += std::exp(logit(color) - logit(finding.color));
    }
    finding.color_logit = -std::log(std::max(others, 1e-9));
  }

  const cv::Mat& output_;
  const NetworkDescription& network_;
  int rows_, columns_;
};

}  // namespace

std::vector<NetworkFinding> ReadCells(const cv::Mat& cells, const NetworkDescription& network,
                                      const FindingLimits& limits) {
  const Cells grid(cells, network);
  std::vector<NetworkFinding> findings;
  for (int row = 0; row < grid.rows(); ++row) {
    for (int column = 0; column < grid.columns(); ++column) {
      if (grid.At(kScore, row, column) >= limits.least_logit) {
        findings.push_back(grid.FindingAt(row, column));
      }
    }
  }
  std::ranges::stable_sort(findings, std::ranges::greater(), &NetworkFinding::score_logit);
  std::vector<NetworkFinding> kept;
  for (const NetworkFinding& finding : findings) {
    const bool repeats = std::ranges::any_of(kept, [&](const NetworkFinding& other) {
      return Overlap(finding.rect, other.rect) > limits.most_overlap;
    });
    if (!repeats) kept.push_back(finding);
  }
  return kept;
}

NetworkFinding StrongestAt(const cv::Mat& cells, const NetworkDescription& network,
                           const PixelRect& place) {
  const Cells grid(cells, network);
  const double stride = network.stride_px;
  const auto cell_of = [stride](double pixel, int count) {
    return std::clamp(static_cast<int>(pixel / stride), 0, count - 1);
  };
  constexpr double kInner = 0.25;  // of the width to either side of the middle
  const double across = kInner * place.width();
  const double down = kInner * place.height();
  const int last_row = cell_of(place.center_v() + down, grid.rows());
  const int last_column = cell_of(place.center_u() + across, grid.columns());
  std::optional<NetworkFinding> best;
  for (int row = cell_of(place.center_v() - down, grid.rows()); row <= last_row; ++row) {
    for (int column = cell_of(place.center_u() - across, grid.columns()); column <= last_column;
         ++column) {
      if (!best || grid.At(kScore, row, column) > best->score_logit) {
        best = grid.FindingAt(row, column);
      }
    }
  }
  return *best;
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/helm/motion_grid_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Core>

#include "limpet/core/frames.hpp"

namespace limpet {
namespace {

constexpr std::size_t kCourse = IndexOf(MotionVariable::kCourse);
constexpr double kTie = 1e-9;  // of all weights: rounding must not decide

/// `sums` += weight * values. Unrolled by the compiler into vector instructions.
void AddTo(std::vector<double>& sums, double weight, std::span<const float> values) {
  double* sum = sums.data();
  for (std::size_t i = 0; i < values.size(); ++i) {
    sum[i] += weight * static_cast<double>(values[i]);
  }
}

double TotalWeight(const MotionPreferences& preferences) {
  double total = 0.0;
  for (const WeightedTable& weighted : preferences.tables) {
    total += weighted.weight;
  }
  for (const auto& peaks : preferences.peaks) {
    for (const WeightedPeak& weighted : peaks) {
      total += weighted.weight;
    }
  }
  return total;
}

}  // namespace

MotionGridSearch::MotionGridSearch(const MotionDomain& domain) {
  for (const MotionVariable variable : kMotionVariables) {
    std::vector<double>& coordinates = coordinates_.at(IndexOf(variable));
    const std::optional<MotionAxis>& axis = domain.axis(variable);
    for (int i = 0; axis && i < axis->points; ++i) {
      coordinates.push_back(variable == MotionVariable::kCourse ? WrapAngle(axis->At(i))
                                                                : axis->At(i));
    }
    if (coordinates.empty()) coordinates.push_back(0.0);
    peak_sums_.at(IndexOf(variable)).resize(coordinates.size());
  }
  row_.reserve(std::max({peak_sums_[0].size(), peak_sums_[1].size(), peak_sums_[2].size()}));
  row_best_.reserve(peak_sums_[0].size() * peak_sums_[1].size());
  course_best_.reserve(peak_sums_[0].size());
}

double MotionGridSearch::Distance(std::size_t variable, std::size_t point, double reference) const {
  const double difference = std::abs(coordinates_.at(variable)[point] - reference);
  constexpr double kTurn = 2.0 * std::numbers::pi;
  return variable == kCourse ? std::min(difference, kTurn - difference) : difference;
}

void MotionGridSearch::SumPeaks(const MotionPreferences& preferences) {
  for (std::size_t variable = 0; variable < peak_sums_.size(); ++variable) {
    std::vector<double>& sums = peak_sums_.at(variable);
    std::ranges::fill(sums, 0.0);
    if (!is_joined_.at(variable)) continue;
    for (const auto& [peak, weight] : preferences.peaks.at(variable)) {
      const double summit = variable == kCourse ? WrapAngle(peak.summit) : peak.summit;
      for (std::size_t i = 0; i < sums.size(); ++i) {
        sums[i] += weight * PeakValue(peak, Distance(variable, i, summit));
      }
    }
  }
}

double MotionGridSearch::SumRow(const MotionPreferences& preferences,
                                const std::array<std::size_t, 2>& outer) {
  double base = 0.0;
  for (std::size_t variable = 0; variable < inner_; ++variable) {
    base += peak_sums_.at(variable)[outer.at(variable)];
  }
  const auto values_at = [&](const MotionTable& table) {
    std::size_t offset = 0;
    for (std::size_t variable = 0; variable < inner_; ++variable) {
      offset += table.stride(kMotionVariables.at(variable)) * outer.at(variable);
    }
    return table.values().subspan(offset);
  };
  const MotionVariable inner = kMotionVariables.at(inner_);
  for (const auto& [table, weight] : preferences.tables) {
    if (!table->Covers(inner)) base += weight * static_cast<double>(values_at(*table).front());
  }
  const std::vector<double>& along = peak_sums_.at(inner_);
  for (std::size_t i = 0; i < row_.size(); ++i) {
    row_[i] = base + along[i];
  }
  for (const auto& [table, weight] : preferences.tables) {
    if (table->Covers(inner)) AddTo(row_, weight, values_at(*table).first(row_.size()));
  }
  return Eigen::Map<const Eigen::VectorXd>(row_.data(), static_cast<Eigen::Index>(row_.size()))
      .maxCoeff();
}

std::size_t MotionGridSearch::Nearest(std::size_t variable, double reference,
                                      std::span<const double> sums, double least) const {
  constexpr double kRounding = 1e-9;  // to either side of the reference are distances alike
  std::size_t nearest = 0;
  double distance = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < sums.size(); ++i) {
    if (sums[i] < least) continue;
    if (const double own = Distance(variable, i, reference); own < distance - kRounding) {
      nearest = i;
      distance = own;
    }
  }
  return nearest;
}

bool MotionGridSearch::Join(std::span<const WeightedTable> tables) {
  for (const MotionVariable variable : kMotionVariables) {
    const std::size_t index = IndexOf(variable);
    is_joined_.at(index) = std::ranges::any_of(
        tables, [variable](const auto& weighted) { return weighted.table->Covers(variable); });
    if (is_joined_.at(index)) inner_ = index;
  }
  return std::ranges::find(is_joined_, true) != is_joined_.end();
}

std::array<std::size_t, 3> MotionGridSearch::BestPoint(const MotionPreferences& preferences,
                                                       const std::array<double, 3>& reference) {
  const auto points = [this](std::size_t variable) {
    return is_joined_.at(variable) ? coordinates_.at(variable).size() : 1;
  };
  const std::size_t courses = inner_ > 0 ? points(0) : 1, speeds = inner_ > 1 ? points(1) : 1;
  row_.resize(points(inner_));
  row_best_.resize(courses * speeds);
  for (std::size_t row = 0; row < row_best_.size(); ++row) {
    row_best_[row] = SumRow(preferences, {row / speeds, row % speeds});
  }
  const double least = *std::ranges::max_element(row_best_) - kTie * TotalWeight(preferences);
  const std::span<const double> best_of(row_best_);
  // Of the points that are as good as the best: the nearest course, at it the nearest speed, ...
  course_best_.resize(courses);
  for (std::size_t course = 0; course < courses; ++course) {
    course_best_[course] = *std::ranges::max_element(best_of.subspan(course * speeds, speeds));
  }
  std::array<std::size_t, 3> best{};
  if (inner_ > 0) best[0] = Nearest(0, reference[0], course_best_, least);
  if (inner_ > 1)
    best[1] = Nearest(1, reference[1], best_of.subspan(best[0] * speeds, speeds), least);
  static_cast<void>(SumRow(preferences, {best[0], best[1]}));
  best.at(inner_) = Nearest(inner_, reference.at(inner_), row_, least);
  return best;
}

std::array<std::optional<double>, 3> MotionGridSearch::Maximise(
    const MotionPreferences& preferences, const std::array<double, 3>& reference) {
  std::array<std::optional<double>, 3> chosen;
  if (!Join(preferences.tables)) return chosen;
  SumPeaks(preferences);
  const std::array<std::size_t, 3> best = BestPoint(preferences, reference);
  for (std::size_t variable = 0; variable < chosen.size(); ++variable) {
    if (is_joined_.at(variable)) chosen.at(variable) = coordinates_.at(variable)[best.at(variable)];
  }
  return chosen;
}

}  // namespace limpet

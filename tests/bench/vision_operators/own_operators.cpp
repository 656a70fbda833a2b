// SPDX-License-Identifier: MIT
#include "tests/bench/vision_operators/own_operators.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include <Eigen/Cholesky>

namespace limpet::own {
namespace {

/// A horizontal run of pixels; `parent` points to an earlier run of the same region, or to itself.
struct Run {
  int row = 0, left = 0, right = 0;
  std::size_t parent = 0;
};

std::size_t Root(std::vector<Run>& runs, std::size_t index) {
  while (runs[index].parent != index) {
    runs[index].parent = runs[runs[index].parent].parent;
    index = runs[index].parent;
  }
  return index;
}

/// Joins the run at `index` with those of the row above that touch it; `above` is moved on to the
/// first that may touch the next run.
void JoinAbove(std::vector<Run>& runs, std::size_t index, std::size_t& above,
               std::size_t above_end) {
  while (above < above_end && runs[above].right < runs[index].left) {
    ++above;
  }
  for (std::size_t i = above; i < above_end && runs[i].left <= runs[index].right; ++i) {
    const std::size_t a = Root(runs, i);
    const std::size_t b = Root(runs, index);
    runs[std::max(a, b)].parent = std::min(a, b);
  }
}

std::vector<Run> RunsOf(const Plane& plane, int level) {
  std::vector<Run> runs;
  std::size_t above = 0;
  std::size_t above_end = 0;
  for (int row = 0; row < plane.height; ++row) {
    const std::int16_t* value =
        plane.values.data() + static_cast<std::ptrdiff_t>(row) * plane.width;
    const std::size_t begin = runs.size();
    for (int column = 0; column < plane.width; ++column) {
      if (value[column] < level) {
        continue;
      }
      const int left = column;
      while (column < plane.width && value[column] >= level) {
        ++column;
      }
      runs.push_back({row, left, column, runs.size()});
      JoinAbove(runs, runs.size() - 1, above, above_end);
    }
    above = begin;
    above_end = runs.size();
  }
  return runs;
}

void Add(const Run& run, Region& region) {
  const double count = run.right - run.left;
  const double middle = 0.5 * (run.left + run.right);
  const double v = run.row + 0.5;
  region.n += count;
  region.x += count * middle;
  region.y += count * v;
  region.xx += count * (middle * middle + count * count / 12.0);
  region.xy += count * middle * v;
  region.yy += count * (v * v + 1.0 / 12.0);
}

/// Squared distance of a colour from the scene's usual ones.
class UsualColors {
 public:
  UsualColors(const Image& image, double noise) {
    for (const double limit : {1e9, 9.0, 9.0}) {
      double count = 0.0;
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
      for (std::size_t i = 0; i < image.bgr.size() / 3; i += 7) {
        const Eigen::Vector3d color = ColorOf(&image.bgr[3 * i]);
        if (Distance2(color) < limit) {
          count += 1.0;
          sum += color;
          squares += color * color.transpose();
        }
      }
      mean_ = sum / count;
      const Eigen::Matrix3d covariance =
          squares / count - mean_ * mean_.transpose() + noise * noise * Eigen::Matrix3d::Identity();
      whiten_ = covariance.llt().matrixL().solve(Eigen::Matrix3d::Identity().eval());
    }
  }
  [[nodiscard]] static Eigen::Vector3d ColorOf(const std::uint8_t* bgr) {
    return {static_cast<double>(bgr[0]), static_cast<double>(bgr[1]), static_cast<double>(bgr[2])};
  }
  [[nodiscard]] double Distance2(const Eigen::Vector3d& color) const {
    return (whiten_ * (color - mean_)).squaredNorm();
  }

 private:
  Eigen::Vector3d mean_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d whiten_ = Eigen::Matrix3d::Zero();
};

}  // namespace

void Reduce(const Image& image, Image& reduced) {
  constexpr int kFactor = 4;
  reduced.width_px = image.width_px / kFactor;
  reduced.height_px = image.height_px / kFactor;
  reduced.bgr.resize(3 * static_cast<std::size_t>(reduced.width_px) *
                     static_cast<std::size_t>(reduced.height_px));
  std::uint8_t* out = reduced.bgr.data();
  for (int row = 0; row < reduced.height_px; ++row) {
    for (int column = 0; column < reduced.width_px; ++column, out += 3) {
      std::array<int, 3> sum{8, 8, 8};
      for (int dy = 0; dy < kFactor; ++dy) {
        const std::uint8_t* pixel = image.view().pixel(kFactor * column, kFactor * row + dy);
        for (int dx = 0; dx < kFactor; ++dx, pixel += 3) {
          sum[0] += pixel[0];
          sum[1] += pixel[1];
          sum[2] += pixel[2];
        }
      }
      for (std::size_t c = 0; c < 3; ++c) {
        out[c] = static_cast<std::uint8_t>(sum[c] / (kFactor * kFactor));
      }
    }
  }
}

void FillPlanes(const Image& image, double noise, std::array<Plane, 4>& planes) {
  const std::size_t pixels = image.bgr.size() / 3;
  for (Plane& plane : planes) {
    plane.width = image.width_px;
    plane.height = image.height_px;
    plane.values.resize(pixels);
  }
  const UsualColors usual(image, noise);
  for (std::size_t i = 0; i < pixels; ++i) {
    const float blue = image.bgr[3 * i];
    const float green = image.bgr[3 * i + 1];
    const float red = image.bgr[3 * i + 2];
    const float scale = 2048.0F / (blue + green + red + 48.0F);
    planes[0].values[i] = static_cast<std::int16_t>((0.5F * (red + green) - blue) * scale);
    planes[1].values[i] = static_cast<std::int16_t>((red - green) * scale);
    planes[2].values[i] = static_cast<std::int16_t>((green - 0.5F * (red + blue)) * scale);
    const double distance2 = usual.Distance2(UsualColors::ColorOf(&image.bgr[3 * i]));
    planes[3].values[i] = static_cast<std::int16_t>(std::min(16.0 * std::sqrt(distance2), 3e4));
  }
}

std::array<int, 3> QuantilesAndMost(const Plane& plane) {
  const auto quantile = [&plane](double share) {
    std::vector<std::int16_t> sample;
    sample.reserve(plane.values.size() / 3 + 1);
    for (std::size_t i = 0; i < plane.values.size(); i += 3) {
      sample.push_back(plane.values[i]);
    }
    const auto at = sample.begin() +
                    static_cast<std::ptrdiff_t>(share * static_cast<double>(sample.size() - 1));
    std::ranges::nth_element(sample, at);
    return static_cast<int>(*at);
  };
  return {quantile(0.16), quantile(0.5), *std::ranges::max_element(plane.values)};
}

void FindRegions(const Plane& plane, int level, double least_area, std::vector<Region>& regions) {
  std::vector<Run> runs = RunsOf(plane, level);
  std::vector<Region> sums(runs.size());
  for (std::size_t i = 0; i < runs.size(); ++i) {
    Add(runs[i], sums[Root(runs, i)]);
  }
  std::ranges::copy_if(sums, std::back_inserter(regions),
                       [least_area](const Region& region) { return region.n >= least_area; });
}

void SampleRays(const ImageView& image, const Ellipse& ellipse, const Eigen::Vector3d& weights,
                std::vector<double>& profiles) {
  profiles.clear();
  for (int ray = 0; ray < kRays; ++ray) {
    const double angle = 2.0 * std::numbers::pi * ray / kRays;
    const double cosine = std::cos(angle);
    const double sine = std::sin(angle);
    for (int step = 0; step < kSteps; ++step) {
      const Eigen::Vector2d p = ellipse.At({cosine, sine}, 0.55 + (step + 0.5) / kSteps);
      const std::uint8_t* pixel = image.pixel(static_cast<int>(p.x()), static_cast<int>(p.y()));
      profiles.push_back(weights.dot(Eigen::Vector3d(pixel[0], pixel[1], pixel[2])));
    }
  }
}

}  // namespace limpet::own

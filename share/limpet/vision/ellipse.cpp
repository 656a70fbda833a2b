// SPDX-License-Identifier: MIT
#include "limpet/vision/ellipse.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace limpet {
namespace {

using Vector5 = Eigen::Matrix<double, 5, 1>;
using Matrix5 = Eigen::Matrix<double, 5, 5>;

}  // namespace

Ellipse Ellipse::OfMoments(const Eigen::Vector2d& center, const Eigen::Matrix2d& covariance) {
  // A filled ellipse has a quarter of its squared semi-axes as variance.
  const double xx = 4.0 * covariance(0, 0);
  const double xy = 4.0 * covariance(0, 1);
  const double yy = 4.0 * covariance(1, 1);
  const double l = std::sqrt(std::max(xx, 1e-12));
  Ellipse ellipse;
  ellipse.center = center;
  ellipse.axes << l, 0.0, xy / l, std::sqrt(std::max(yy - xy * xy / (l * l), 1e-12));
  return ellipse;
}

double Ellipse::Scale(const Eigen::Vector2d& point) const {
  return (axes.inverse() * (point - center)).norm();
}

double Ellipse::MeanRadius() const { return std::sqrt(std::abs(axes.determinant())); }

double Ellipse::Elongation() const {
  const Eigen::Matrix2d squared = axes * axes.transpose();
  const double half_trace = 0.5 * squared.trace();
  const double root = std::sqrt(std::max(half_trace * half_trace - squared.determinant(), 0.0));
  return std::sqrt((half_trace + root) / std::max(half_trace - root, 1e-12));
}

PixelRect Ellipse::VisiblePart(int width_px, int height_px) const {
  const double half_width = axes.row(0).norm();
  const double half_height = axes.row(1).norm();
  const PixelRect frame{0.0, 0.0, static_cast<double>(width_px), static_cast<double>(height_px)};
  const PixelRect outline{center.x() - half_width, center.y() - half_height,
                          center.x() + half_width, center.y() + half_height};
  // Rows and columns inside the image, by what the outline spans there: at a corner the visible
  // part is narrower than the clipped outline.
  const Eigen::Matrix2d shape = axes * axes.transpose();
  const auto span = [&shape](double offset, int fixed) {
    const int free = 1 - fixed;
    const double across = shape(free, fixed) / shape(fixed, fixed) * offset;
    const double left_over = 1.0 - offset * offset / shape(fixed, fixed);
    const double half =
        std::sqrt(std::max(left_over, 0.0) * shape.determinant() / shape(fixed, fixed));
    return std::pair(across - half, across + half);
  };
  PixelRect rows = Intersection(outline, frame);
  constexpr int kSteps = 48;
  double left = frame.right, right = frame.left, top = frame.bottom, bottom = frame.top;
  for (int i = 0; i <= kSteps; ++i) {
    const double v = rows.top + i * rows.height() / kSteps;
    const auto [u0, u1] = span(v - center.y(), 1);
    left = std::min(left, center.x() + u0);
    right = std::max(right, center.x() + u1);
    const double u = rows.left + i * rows.width() / kSteps;
    const auto [v0, v1] = span(u - center.x(), 0);
    top = std::min(top, center.y() + v0);
    bottom = std::max(bottom, center.y() + v1);
  }
  // Sampled rows and columns miss an inner extreme by a hair; there the outline is exact.
  const auto settle = [](double sampled, double exact) {
    return std::abs(sampled - exact) < 0.7 ? exact : sampled;
  };
  return Intersection({settle(left, outline.left), settle(top, outline.top),
                       settle(right, outline.right), settle(bottom, outline.bottom)},
                      frame);
}

std::optional<Ellipse> FitEllipse(std::span<const Eigen::Vector2d> points, const Ellipse& guess) {
  if (points.size() < 8) {
    return std::nullopt;
  }
  // A x^2 + B xy + C y^2 + D x + E y = 1 in the guess's coordinates; a weak pull towards the unit
  // circle holds what a short arc leaves open.
  const Eigen::Matrix2d to_unit = guess.axes.inverse();
  const double pull = 0.002 * static_cast<double>(points.size());
  Matrix5 normal = pull * Matrix5::Identity();
  Vector5 right = Vector5::Zero();
  right(0) = pull;
  right(2) = pull;
  for (const Eigen::Vector2d& point : points) {
    const Eigen::Vector2d p = to_unit * (point - guess.center);
    Vector5 row;
    row << p.x() * p.x(), p.x() * p.y(), p.y() * p.y(), p.x(), p.y();
    normal += row * row.transpose();
    right += row;
  }
  const Vector5 conic = normal.ldlt().solve(right);
  Eigen::Matrix2d quadratic;
  quadratic << conic(0), 0.5 * conic(1), 0.5 * conic(1), conic(2);
  if (quadratic.determinant() <= 0.05 || quadratic.trace() <= 0.0) {
    return std::nullopt;
  }
  const Eigen::Vector2d linear(conic(3), conic(4));
  const Eigen::Vector2d center = -0.5 * (quadratic.inverse() * linear);
  const double size = 1.0 + center.dot(quadratic * center);
  if (size <= 0.0) {
    return std::nullopt;
  }
  const Eigen::Matrix2d shape = size * quadratic.inverse();
  return Ellipse::OfMoments(guess.center + guess.axes * center,
                            0.25 * (guess.axes * shape * guess.axes.transpose()));
}

}  // namespace limpet

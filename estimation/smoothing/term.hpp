// SPDX-License-Identifier: MIT
// A factor on the chain's variables, free of its type: what the solvers see.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <utility>

#include <Eigen/Core>

#include "estimation/smoothing/jacobians.hpp"
#include "estimation/smoothing/loss.hpp"
#include "estimation/smoothing/nav_vector.hpp"

namespace limpet {

/// Border variables that one term depends on, at most.
inline constexpr std::size_t kMostBorders = 4;

/// Where a term is linearised. A term reads only what it depends on.
struct TermPoint {
  const NavVector* previous = nullptr;
  const NavVector* pose = nullptr;
  /// Landmarks and slow errors of the sensors, in the order of the term's slots.
  std::array<const Eigen::Vector3d*, kMostBorders> border{};
};

/// Whitened, reweighted residual and Jacobians of a term; only the first `rows` rows count, and
/// only the Jacobians of what the term depends on.
struct LinearTerm {
  int rows = 0;
  Eigen::Matrix<double, 6, 1> r;
  Eigen::Matrix<double, 6, 6> J_previous, J_pose;
  std::array<Eigen::Matrix<double, 6, 3>, kMostBorders> J_border;  ///< in the order of the slots
  double cost = 0.0;
};

/// A factor with its loss, bound to a kind of variables: a pose, or a step between neighbouring
/// poses, either with border variables (a landmark, slow errors of the sensors) or without; or
/// border variables alone. A factor's Evaluate takes the variables, then where each derivative is
/// to go; beside a pose and several border variables, where all of them are to go.
class Term {
 public:
  template <class F>
  [[nodiscard]] static Term OnPose(F factor, Loss loss = Loss::LeastSquares()) {
    return Term({}, [factor, loss](const TermPoint& at, LinearTerm& out) {
      typename F::Jacobian J;
      const double weight = Store(factor.Evaluate(*at.pose, &J), loss, out);
      out.J_pose.topRows<F::kDim>() = weight * J;
    });
  }
  template <class F>
  [[nodiscard]] static Term OnStep(F factor, Loss loss = Loss::LeastSquares()) {
    return Term({}, [factor, loss](const TermPoint& at, LinearTerm& out) {
      typename F::Jacobian J_previous, J_pose;
      const double weight =
          Store(factor.Evaluate(*at.previous, *at.pose, &J_previous, &J_pose), loss, out);
      out.J_previous.topRows<F::kDim>() = weight * J_previous;
      out.J_pose.topRows<F::kDim>() = weight * J_pose;
    });
  }
  /// A step whose sensors' slow errors are these border variables.
  template <class F, std::size_t N>
  [[nodiscard]] static Term OnStep(F factor, const std::array<int, N>& slots,
                                   Loss loss = Loss::LeastSquares()) {
    return Term(slots, [factor, loss](const TermPoint& at, LinearTerm& out) {
      StepJacobians<F::kDim, N> J;
      const auto evaluate = [&]<std::size_t... I>(std::index_sequence<I...>) {
        if constexpr (N > 1) {
          return factor.Evaluate(*at.previous, *at.pose, *at.border[I]..., &J);
        } else {
          return factor.Evaluate(*at.previous, *at.pose, *at.border[I]..., &J.previous, &J.pose,
                                 &J.border[I]...);
        }
      };
      const double weight = Store(evaluate(std::make_index_sequence<N>()), loss, out);
      out.J_previous.topRows<F::kDim>() = weight * J.previous;
      out.J_pose.topRows<F::kDim>() = weight * J.pose;
      StoreBorders<F>(J.border, weight, out);
    });
  }
  /// A pose and border variables: a landmark and what else bears on how it is seen.
  template <class F, std::size_t N>
  [[nodiscard]] static Term OnObservation(F factor, const std::array<int, N>& slots,
                                          Loss loss = Loss::LeastSquares()) {
    return Term(slots, [factor, loss](const TermPoint& at, LinearTerm& out) {
      ObservationJacobians<F::kDim, N> J;
      const auto evaluate = [&]<std::size_t... I>(std::index_sequence<I...>) {
        if constexpr (N > 1) {
          return factor.Evaluate(*at.pose, *at.border[I]..., &J);
        } else {
          return factor.Evaluate(*at.pose, *at.border[I]..., &J.pose, &J.border[I]...);
        }
      };
      const double weight = Store(evaluate(std::make_index_sequence<N>()), loss, out);
      out.J_pose.topRows<F::kDim>() = weight * J.pose;
      StoreBorders<F>(J.border, weight, out);
    });
  }
  template <class F>
  [[nodiscard]] static Term OnObservation(F factor, int slot, Loss loss = Loss::LeastSquares()) {
    return OnObservation(std::move(factor), std::array{slot}, loss);
  }
  /// Border variables alone.
  template <class F, std::size_t N>
  [[nodiscard]] static Term OnBorder(F factor, const std::array<int, N>& slots,
                                     Loss loss = Loss::LeastSquares()) {
    return Term(slots, [factor, loss](const TermPoint& at, LinearTerm& out) {
      BorderJacobians<F, N> J;
      const auto evaluate = [&]<std::size_t... I>(std::index_sequence<I...>) {
        return factor.Evaluate(*at.border[I]..., &J[I]...);
      };
      const double weight = Store(evaluate(std::make_index_sequence<N>()), loss, out);
      StoreBorders<F>(J, weight, out);
    });
  }
  template <class F>
  [[nodiscard]] static Term OnBorder(F factor, int slot, Loss loss = Loss::LeastSquares()) {
    return OnBorder(std::move(factor), std::array{slot}, loss);
  }

  void Linearize(const TermPoint& at, LinearTerm& out) const { linearize_(at, out); }
  /// Slots of the border variables that the term depends on.
  [[nodiscard]] std::span<const int> slots() const { return std::span(slots_).first(slot_count_); }
  [[nodiscard]] bool DependsOn(int slot) const { return std::ranges::count(slots(), slot) > 0; }

 private:
  using Linearizer = std::function<void(const TermPoint&, LinearTerm&)>;
  template <class F, std::size_t N>
  using BorderJacobians = std::array<typename F::BorderJacobian, N>;

  Term(std::span<const int> slots, Linearizer linearize)
      : linearize_(std::move(linearize)), slot_count_(slots.size()) {
    std::ranges::copy(slots, slots_.begin());
  }

  /// The factor's weight under the loss.
  template <class Residual>
  static double Store(const Residual& r, Loss loss, LinearTerm& out) {
    constexpr int kRows = Residual::RowsAtCompileTime;
    const double norm = r.norm();
    const double weight = loss.SqrtWeight(norm);
    out.rows = kRows;
    out.r.template head<kRows>() = weight * r;
    out.cost = loss.Cost(norm);
    return weight;
  }
  template <class F, std::size_t N>
  static void StoreBorders(const BorderJacobians<F, N>& J, double weight, LinearTerm& out) {
    static_assert(N <= kMostBorders);
    for (std::size_t i = 0; i < N; ++i)
      out.J_border[i].template topRows<F::kDim>() = weight * J[i];
  }

  Linearizer linearize_;
  std::array<int, kMostBorders> slots_{};
  std::size_t slot_count_;
};

}  // namespace limpet

// SPDX-License-Identifier: MIT
// A factor on the chain's variables, free of its type: what the solvers see.
#pragma once

#include <functional>
#include <optional>
#include <utility>

#include <Eigen/Core>

#include "estimation/smoothing/loss.hpp"
#include "estimation/smoothing/nav_vector.hpp"

namespace limpet {

/// Where a term is linearised. A term reads only what it depends on.
struct TermPoint {
  const NavVector* previous = nullptr;
  const NavVector* pose = nullptr;
  const Eigen::Vector3d* border = nullptr;  ///< a landmark, or slow errors of the sensors
  const Eigen::Vector3d* second = nullptr;
};

/// Whitened, reweighted residual and Jacobians of a term; only the first `rows` rows count, and
/// only the Jacobians of what the term depends on.
struct LinearTerm {
  int rows = 0;
  Eigen::Matrix<double, 6, 1> r;
  Eigen::Matrix<double, 6, 6> J_previous, J_pose;
  Eigen::Matrix<double, 6, 3> J_border, J_second;
  double cost = 0.0;
};

/// A factor with its loss, bound to a kind of variables: a pose; a step between neighbouring poses,
/// with or without slow errors of the sensors; a pose and a landmark; border variables alone.
class Term {
 public:
  template <class F>
  [[nodiscard]] static Term OnPose(F factor, Loss loss = Loss::LeastSquares()) {
    return Term([factor, loss](const TermPoint& at, LinearTerm& out) {
      typename F::Jacobian J;
      Store(factor.Evaluate(*at.pose, &J), loss, out, J, out.J_pose);
    });
  }
  template <class F>
  [[nodiscard]] static Term OnStep(F factor, Loss loss = Loss::LeastSquares()) {
    return Term([factor, loss](const TermPoint& at, LinearTerm& out) {
      typename F::Jacobian J_previous, J_pose;
      const double weight = Store(factor.Evaluate(*at.previous, *at.pose, &J_previous, &J_pose),
                                  loss, out, J_pose, out.J_pose);
      out.J_previous.topRows<F::kDim>() = weight * J_previous;
    });
  }
  /// A step whose sensors' slow errors are the border variable `slot`.
  template <class F>
  [[nodiscard]] static Term OnStep(F factor, int slot, Loss loss = Loss::LeastSquares()) {
    Term term([factor, loss](const TermPoint& at, LinearTerm& out) {
      typename F::Jacobian J_previous, J_pose;
      typename F::BorderJacobian J_errors;
      const double weight = Store(
          factor.Evaluate(*at.previous, *at.pose, *at.border, &J_previous, &J_pose, &J_errors),
          loss, out, J_pose, out.J_pose);
      out.J_previous.topRows<F::kDim>() = weight * J_previous;
      out.J_border.template topRows<F::kDim>() = weight * J_errors;
    });
    term.border_ = slot;
    return term;
  }
  template <class F>
  [[nodiscard]] static Term OnObservation(F factor, int slot, Loss loss = Loss::LeastSquares()) {
    Term term([factor, loss](const TermPoint& at, LinearTerm& out) {
      typename F::Jacobian J_pose;
      typename F::BorderJacobian J_landmark;
      const double weight = Store(factor.Evaluate(*at.pose, *at.border, &J_pose, &J_landmark), loss,
                                  out, J_pose, out.J_pose);
      out.J_border.template topRows<F::kDim>() = weight * J_landmark;
    });
    term.border_ = slot;
    return term;
  }
  template <class F>
  [[nodiscard]] static Term OnBorder(F factor, int slot, Loss loss = Loss::LeastSquares()) {
    Term term([factor, loss](const TermPoint& at, LinearTerm& out) {
      typename F::BorderJacobian J;
      Store(factor.Evaluate(*at.border, &J), loss, out, J, out.J_border);
    });
    term.border_ = slot;
    return term;
  }
  /// On two border variables.
  template <class F>
  [[nodiscard]] static Term OnBorderPair(F factor, int slot, int second,
                                         Loss loss = Loss::LeastSquares()) {
    Term term([factor, loss](const TermPoint& at, LinearTerm& out) {
      typename F::BorderJacobian J, J_second;
      const double weight =
          Store(factor.Evaluate(*at.border, *at.second, &J, &J_second), loss, out, J, out.J_border);
      out.J_second.template topRows<F::kDim>() = weight * J_second;
    });
    term.border_ = slot;
    term.second_ = second;
    return term;
  }

  void Linearize(const TermPoint& at, LinearTerm& out) const { linearize_(at, out); }
  /// Slot of the border variable that the term depends on, if any.
  [[nodiscard]] std::optional<int> border() const { return border_; }
  /// The other one, of a term on two.
  [[nodiscard]] std::optional<int> second() const { return second_; }

 private:
  using Linearizer = std::function<void(const TermPoint&, LinearTerm&)>;
  explicit Term(Linearizer linearize) : linearize_(std::move(linearize)) {}

  template <class Residual, class Jacobian, class Target>
  static double Store(const Residual& r, Loss loss, LinearTerm& out, const Jacobian& J,
                      Target& target) {
    constexpr int kRows = Residual::RowsAtCompileTime;
    const double norm = r.norm();
    const double weight = loss.SqrtWeight(norm);
    out.rows = kRows;
    out.r.template head<kRows>() = weight * r;
    target.template topRows<kRows>() = weight * J;
    out.cost = loss.Cost(norm);
    return weight;
  }

  Linearizer linearize_;
  std::optional<int> border_, second_;
};

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "estimation/smoothing/arrow_elimination.hpp"

#include <algorithm>
#include <cmath>

namespace limpet {
namespace {

constexpr double kSmallestPivot = 1e-12;  // share of the diagonal below which nothing observes it
constexpr double kHeldPivot = 1e12;       // what holds it
constexpr double kUnknownVariance = 1e8;  // reported for it

std::size_t Index(int row, int column, int rows) {
  return static_cast<std::size_t>(column) * static_cast<std::size_t>(rows) +
         static_cast<std::size_t>(row);
}

/// In-place Cholesky of a lower triangle; calls `hold(i)` for a pivot that is not positive.
template <class Hold>
void Factorize(double* A, int n, Hold hold) {
  for (int j = 0; j < n; ++j) {
    const double original = A[Index(j, j, n)];
    double pivot = original;
    for (int k = 0; k < j; ++k) {
      pivot -= A[Index(j, k, n)] * A[Index(j, k, n)];
    }
    if (!(pivot > kSmallestPivot * std::max(original, 1e-6))) {
      hold(j);
      pivot = kHeldPivot * kHeldPivot;
    }
    const double inverse = 1.0 / std::sqrt(pivot);
    A[Index(j, j, n)] = std::sqrt(pivot);
    for (int k = 0; k < j; ++k) {
      const double factor = A[Index(j, k, n)];
      for (int i = j + 1; i < n; ++i) {
        A[Index(i, j, n)] -= A[Index(i, k, n)] * factor;
      }
    }
    for (int i = j + 1; i < n; ++i) {
      A[Index(i, j, n)] *= inverse;
    }
  }
}

/// x <- L^-1 x.
void ForwardSolve(const double* L, int n, double* x) {
  for (int j = 0; j < n; ++j) {
    x[j] /= L[Index(j, j, n)];
    for (int i = j + 1; i < n; ++i) {
      x[i] -= L[Index(i, j, n)] * x[j];
    }
  }
}

/// x <- L^-T x.
void BackwardSolve(const double* L, int n, double* x) {
  for (int j = n - 1; j >= 0; --j) {
    for (int i = j + 1; i < n; ++i) {
      x[j] -= L[Index(i, j, n)] * x[i];
    }
    x[j] /= L[Index(j, j, n)];
  }
}

}  // namespace

ArrowMessage::ArrowMessage() : A(36, 0.0), g(6, 0.0) {}

void ArrowMessage::GrowBorder(int border_columns) {
  if (border_columns <= border) {
    return;
  }
  const int old_size = size();
  const std::vector<double> old = std::move(A);
  border = border_columns;
  A.assign(static_cast<std::size_t>(size()) * static_cast<std::size_t>(size()), 0.0);
  g.resize(static_cast<std::size_t>(size()), 0.0);
  for (int column = 0; column < old_size; ++column) {
    for (int row = column; row < old_size; ++row) {
      at(row, column) = old[Index(row, column, old_size)];
    }
  }
}

void ArrowMessage::AddPoseTerm(const LinearTerm& term, int slot) {
  for (int j = 0; j < 6; ++j) {
    for (int k = 0; k < term.rows; ++k) {
      const double J_kj = term.J_pose(k, j);
      for (int i = j; i < 6; ++i) {
        at(i, j) += term.J_pose(k, i) * J_kj;
      }
      g[static_cast<std::size_t>(j)] -= J_kj * term.r(k);
    }
  }
  if (slot < 0) {
    return;
  }
  AddLandmarkTerm(term, slot);
  const int first = 6 + 3 * slot;
  for (int j = 0; j < 6; ++j) {
    for (int k = 0; k < term.rows; ++k) {
      for (int i = 0; i < 3; ++i) {
        at(first + i, j) += term.J_landmark(k, i) * term.J_pose(k, j);
      }
    }
  }
}

void ArrowMessage::AddLandmarkTerm(const LinearTerm& term, int slot) {
  GrowBorder(3 * (slot + 1));
  const int first = 6 + 3 * slot;
  for (int j = 0; j < 3; ++j) {
    for (int k = 0; k < term.rows; ++k) {
      const double J_kj = term.J_landmark(k, j);
      for (int i = j; i < 3; ++i) {
        at(first + i, first + j) += term.J_landmark(k, i) * J_kj;
      }
      g[static_cast<std::size_t>(first + j)] -= J_kj * term.r(k);
    }
  }
}

ArrowConditional EliminateHead(ArrowMessage& message, const LinearTerm& step) {
  const int n = message.size();
  Eigen::Matrix<double, 6, 6> next_next = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 6> head_next = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 1> g_next = Eigen::Matrix<double, 6, 1>::Zero();
  ArrowConditional out;
  for (int j = 0; j < 6; ++j) {
    for (int i = j; i < 6; ++i) {
      out.L[Index(i, j, 6)] = message.at(i, j);
    }
    out.d[static_cast<std::size_t>(j)] = message.g[static_cast<std::size_t>(j)];
  }
  for (int k = 0; k < step.rows; ++k) {
    for (int j = 0; j < 6; ++j) {
      for (int i = j; i < 6; ++i) {
        out.L[Index(i, j, 6)] += step.J_previous(k, i) * step.J_previous(k, j);
      }
      for (int i = 0; i < 6; ++i) {
        head_next(i, j) += step.J_previous(k, i) * step.J_pose(k, j);
        next_next(i, j) += step.J_pose(k, i) * step.J_pose(k, j);
      }
      out.d[static_cast<std::size_t>(j)] -= step.J_previous(k, j) * step.r(k);
      g_next(j) -= step.J_pose(k, j) * step.r(k);
    }
  }
  Factorize(out.L.data(), 6, [&out](int i) { out.held |= 1 << i; });
  ForwardSolve(out.L.data(), 6, out.d.data());

  out.W.resize(static_cast<std::size_t>(6 * n));
  double* W = out.W.data();
  std::copy(head_next.data(), head_next.data() + 36, W);
  for (int c = 6; c < n; ++c) {
    for (int i = 0; i < 6; ++i) {
      W[6 * c + i] = message.at(c, i);
    }
  }
  for (int c = 0; c < n; ++c) {
    ForwardSolve(out.L.data(), 6, W + 6 * c);
  }

  for (int c = 0; c < n; ++c) {
    const double* w = W + 6 * c;
    double* column = &message.A[Index(0, c, n)];
    if (c < 6) {
      for (int i = c; i < n; ++i) {
        column[i] = i < 6 ? next_next(i, c) : 0.0;
      }
      message.g[static_cast<std::size_t>(c)] = g_next(c);
    }
    for (int i = c; i < n; ++i) {
      const double* v = W + 6 * i;
      column[i] -=
          w[0] * v[0] + w[1] * v[1] + w[2] * v[2] + w[3] * v[3] + w[4] * v[4] + w[5] * v[5];
    }
    for (std::size_t k = 0; k < 6; ++k) {
      message.g[static_cast<std::size_t>(c)] -= w[k] * out.d[k];
    }
  }
  return out;
}

NavVector BackSubstitute(const ArrowConditional& conditional, const NavVector& next,
                         const std::vector<double>& border) {
  NavVector x(conditional.d.data());
  const double* W = conditional.W.data();
  const int n = static_cast<int>(conditional.W.size()) / 6;
  for (int c = 0; c < n; ++c) {
    const double value = c < 6 ? next(c) : border[static_cast<std::size_t>(c - 6)];
    for (int i = 0; i < 6; ++i) {
      x(i) -= W[6 * c + i] * value;
    }
  }
  BackwardSolve(conditional.L.data(), 6, x.data());
  return x;
}

void ArrowRoot::Solve(ArrowMessage message) {
  n_ = message.size();
  L_ = std::move(message.A);
  held_.clear();
  has_covariance_ = false;
  Factorize(L_.data(), n_, [this](int i) { held_.push_back(i); });
  std::vector<double>& x = message.g;
  ForwardSolve(L_.data(), n_, x.data());
  BackwardSolve(L_.data(), n_, x.data());
  for (int i = 0; i < 6; ++i) {
    pose_(i) = x[static_cast<std::size_t>(i)];
  }
  border_.assign(x.begin() + 6, x.end());
}

const Eigen::MatrixXd& ArrowRoot::covariance() const {
  if (has_covariance_) {
    return covariance_;
  }
  // Columns of L^-1, then their products: A^-1 = L^-T L^-1.
  Eigen::MatrixXd inverse = Eigen::MatrixXd::Identity(n_, n_);
  for (int c = 0; c < n_; ++c) {
    ForwardSolve(L_.data(), n_, &inverse(0, c));
  }
  covariance_.resize(n_, n_);
  for (int j = 0; j < n_; ++j) {
    for (int i = j; i < n_; ++i) {
      double sum = 0.0;
      for (int k = i; k < n_; ++k) {
        sum += inverse(k, i) * inverse(k, j);
      }
      covariance_(i, j) = covariance_(j, i) = sum;
    }
  }
  for (const int i : held_) {
    covariance_(i, i) = kUnknownVariance;
  }
  has_covariance_ = true;
  return covariance_;
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "estimation/smoothing/arrow_elimination.hpp"

#include <algorithm>
#include <cmath>

namespace limpet {
namespace {

constexpr double kSmallestPivot = 1e-12;  // share of the diagonal below which nothing observes it
constexpr double kHeldPivot = 1e24;       // what holds it

std::size_t Index(int row, int column, int rows) {
  return static_cast<std::size_t>(column) * static_cast<std::size_t>(rows) +
         static_cast<std::size_t>(row);
}

/// In-place Cholesky of a 6 x 6 lower triangle; pivots that are not positive are held.
int Factorize(std::array<double, 36>& A) {
  int held = 0;
  for (int j = 0; j < 6; ++j) {
    const double original = A[Index(j, j, 6)];
    double pivot = original;
    for (int k = 0; k < j; ++k) {
      pivot -= A[Index(j, k, 6)] * A[Index(j, k, 6)];
    }
    if (!(pivot > kSmallestPivot * std::max(original, 1e-6))) {
      held |= 1 << j;
      pivot = kHeldPivot;
    }
    const double root = std::sqrt(pivot);
    A[Index(j, j, 6)] = root;
    for (int i = j + 1; i < 6; ++i) {
      double sum = A[Index(i, j, 6)];
      for (int k = 0; k < j; ++k)
        sum -= A[Index(i, k, 6)] * A[Index(j, k, 6)];
      A[Index(i, j, 6)] = sum / root;
    }
  }
  return held;
}

/// Rows of W and d: W <- L^-1 W.
void ForwardSolve(ArrowConditional& out, int n) {
  double* W = out.W.data();
  for (int j = 0; j < 6; ++j) {
    double* row = W + Index(0, j, n);
    const double inverse = 1.0 / out.L[Index(j, j, 6)];
    for (int c = 0; c < n; ++c)
      row[c] *= inverse;
    out.d[static_cast<std::size_t>(j)] *= inverse;
    for (int i = j + 1; i < 6; ++i) {
      const double factor = out.L[Index(i, j, 6)];
      double* below = W + Index(0, i, n);
      for (int c = 0; c < n; ++c)
        below[c] -= factor * row[c];
      out.d[static_cast<std::size_t>(i)] -= factor * out.d[static_cast<std::size_t>(j)];
    }
  }
}

/// The message less what was known through the eliminated pose.
void Downdate(ArrowMessage& message, const ArrowConditional& out) {
  const int n = message.size();
  const double* W = out.W.data();
  const double *w0 = W, *w1 = W + n, *w2 = w1 + n, *w3 = w2 + n, *w4 = w3 + n, *w5 = w4 + n;
  double* g = message.g.data();
  for (int c = 0; c < n; ++c) {
    double* column = &message.A[Index(0, c, n)];
    const double a0 = w0[c], a1 = w1[c], a2 = w2[c], a3 = w3[c], a4 = w4[c], a5 = w5[c];
    for (int i = c; i < n; ++i) {
      column[i] -= a0 * w0[i] + a1 * w1[i] + a2 * w2[i] + a3 * w3[i] + a4 * w4[i] + a5 * w5[i];
    }
    g[c] -= a0 * out.d[0] + a1 * out.d[1] + a2 * out.d[2] + a3 * out.d[3] + a4 * out.d[4] +
            a5 * out.d[5];
  }
}

/// Adds a term of so many rows.
template <int kRows>
void AddRows(ArrowMessage& message, const LinearTerm& term, std::span<const JacobianBlock> blocks) {
  const auto product = [](const double* a, const double* b) {
    double sum = 0.0;
    for (int k = 0; k < kRows; ++k)
      sum += a[k] * b[k];
    return sum;
  };
  const int n = message.size();
  for (const JacobianBlock& a : blocks) {
    for (int j = 0; j < a.width; ++j) {
      const double* J_a = a.J + 6 * j;
      message.g[static_cast<std::size_t>(a.first + j)] -= product(J_a, term.r.data());
      double* column = &message.A[Index(0, a.first + j, n)];
      for (const JacobianBlock& b : blocks) {
        if (b.first < a.first) continue;
        for (int i = b.first == a.first ? j : 0; i < b.width; ++i)
          column[b.first + i] += product(J_a, b.J + 6 * i);
      }
    }
  }
}

}  // namespace

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
    std::copy_n(&old[Index(column, column, old_size)], old_size - column, &at(column, column));
  }
}

void ArrowMessage::Add(const LinearTerm& term, std::span<const JacobianBlock> blocks) {
  constexpr std::array kAdders{&AddRows<1>, &AddRows<2>, &AddRows<3>,
                               &AddRows<4>, &AddRows<5>, &AddRows<6>};
  if (term.rows > 0) kAdders[static_cast<std::size_t>(term.rows - 1)](*this, term, blocks);
}

ArrowConditional EliminateHead(ArrowMessage& message, const ArrowLink& link) {
  const int n = message.size();
  ArrowConditional out;
  out.W.resize(static_cast<std::size_t>(6 * n));
  for (int j = 0; j < 6; ++j) {
    const double* column = &message.A[Index(0, j, n)];
    std::copy_n(column + j, 6 - j, &out.L[Index(j, j, 6)]);
    out.d[static_cast<std::size_t>(j)] = message.g[static_cast<std::size_t>(j)];
    for (int i = 0; i < 6; ++i)
      out.W[Index(i, j, n)] = link.head_next[Index(j, i, 6)];
    std::copy_n(column + 6, n - 6, &out.W[Index(6, j, n)]);
  }
  out.held = Factorize(out.L);
  ForwardSolve(out, n);

  for (int c = 0; c < 6; ++c) {
    double* column = &message.A[Index(0, c, n)];
    std::fill_n(column + c, n - c, 0.0);
    std::copy_n(&link.next_next[Index(c, c, 6)], 6 - c, column + c);
    message.g[static_cast<std::size_t>(c)] = link.g_next[static_cast<std::size_t>(c)];
    for (std::size_t b = 0; b < link.columns.size(); ++b) {
      for (std::size_t i = 0; i < 3; ++i) {
        column[6 + link.columns[b] + static_cast<int>(i)] =
            link.next_border[18 * b + 6 * i + static_cast<std::size_t>(c)];
      }
    }
  }
  Downdate(message, out);
  return out;
}

NavVector BackSubstitute(const ArrowConditional& conditional, const NavVector& next,
                         const double* border) {
  const int n = conditional.columns();
  const double* W = conditional.W.data();
  NavVector x = Eigen::Map<const NavVector>(conditional.d.data());
  for (int c = 0; c < n; ++c) {
    const double z = c < 6 ? next(c) : border[c - 6];
    for (int j = 0; j < 6; ++j)
      x(j) -= W[Index(c, j, n)] * z;
  }
  for (int j = 5; j >= 0; --j) {
    for (int i = j + 1; i < 6; ++i)
      x(j) -= conditional.L[Index(i, j, 6)] * x(i);
    x(j) /= conditional.L[Index(j, j, 6)];
  }
  return x;
}

}  // namespace limpet

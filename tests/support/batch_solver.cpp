// SPDX-License-Identifier: MIT
#include "tests/support/batch_solver.hpp"

#include <cmath>
#include <optional>
#include <vector>

#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>

namespace limpet {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// Normal equations of the graph where its variables are.
class NormalEquations {
 public:
  explicit NormalEquations(const ChainGraph& graph) : poses_(6 * graph.node_count()) {
    size_ = poses_ + 3 * graph.slot_count();
    g_ = Eigen::VectorXd::Zero(size_);
    LinearTerm linear;
    for (int i = 0; i < graph.node_count(); ++i) {
      if (i > 0) {
        graph.LinearizeStep(i, linear);
        std::vector<Block> blocks{{6 * (i - 1), 6, linear.J_previous.data()},
                                  {6 * i, 6, linear.J_pose.data()}};
        AddBorders(*graph.node(i).step, linear, blocks);
        Add(linear, blocks);
      }
      for (const ChainNode::Entry& entry : graph.node(i).terms) {
        graph.Linearize(i, entry.term, linear);
        std::vector<Block> blocks{{6 * i, 6, linear.J_pose.data()}};
        AddBorders(entry.term, linear, blocks);
        Add(linear, blocks);
      }
    }
    for (int slot = 0; slot < graph.slot_count(); ++slot) {
      for (const Term& term : graph.border(slot).terms) {
        graph.LinearizeBorder(term, linear);
        std::vector<Block> blocks;
        AddBorders(term, linear, blocks);
        Add(linear, blocks);
      }
    }
    if (graph.joint_prior()) Add(graph, *graph.joint_prior());
    H_.resize(size_, size_);
    H_.setFromTriplets(triplets_.begin(), triplets_.end());
  }

  /// Solves (H + lambda diag(H) + tiny) d = g; empty when not positive definite.
  [[nodiscard]] Eigen::VectorXd Solve(double lambda) const {
    SparseMatrix damped = H_;
    for (int i = 0; i < size_; ++i) {
      double& diagonal = damped.coeffRef(i, i);
      diagonal += lambda * diagonal + 1e-9;
    }
    Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower, Eigen::NaturalOrdering<int>> ldlt(damped);
    return ldlt.info() == Eigen::Success ? Eigen::VectorXd(ldlt.solve(g_)) : Eigen::VectorXd();
  }

 private:
  struct Block {
    int first;
    int columns;
    const double* J;  ///< six rows, column-major
  };
  void AddBorders(const Term& term, const LinearTerm& linear, std::vector<Block>& blocks) const {
    for (std::size_t i = 0; i < term.slots().size(); ++i)
      blocks.push_back({poses_ + 3 * term.slots()[i], 3, linear.J_border[i].data()});
  }
  void Add(const LinearTerm& linear, const std::vector<Block>& blocks) {
    for (const Block& a : blocks) {
      for (int i = 0; i < a.columns; ++i) {
        for (int k = 0; k < linear.rows; ++k) {
          g_(a.first + i) -= a.J[6 * i + k] * linear.r(k);
        }
        for (const Block& b : blocks) {
          for (int j = 0; j < b.columns; ++j) {
            double sum = 0.0;
            for (int k = 0; k < linear.rows; ++k) {
              sum += a.J[6 * i + k] * b.J[6 * j + k];
            }
            if (a.first + i >= b.first + j) {
              triplets_.emplace_back(a.first + i, b.first + j, sum);
            }
          }
        }
      }
    }
  }
  void Add(const ChainGraph& graph, const JointPrior& prior) {
    Eigen::VectorXd off = -prior.mean();
    std::vector<int> rows;
    for (const int slot : prior.slots()) {
      off.segment<3>(static_cast<Eigen::Index>(rows.size())) += graph.border(slot).x;
      for (int i = 0; i < 3; ++i)
        rows.push_back(poses_ + 3 * slot + i);
    }
    g_(rows) -= prior.information() * off;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      for (std::size_t j = 0; j < rows.size(); ++j) {
        if (rows[i] < rows[j]) continue;
        triplets_.emplace_back(
            rows[i], rows[j],
            prior.information()(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
      }
    }
  }

  int poses_, size_;
  std::vector<Eigen::Triplet<double>> triplets_;
  SparseMatrix H_;
  Eigen::VectorXd g_;
};

void Move(ChainGraph& graph, const Eigen::VectorXd& d) {
  const int poses = 6 * graph.node_count();
  for (int i = 0; i < graph.node_count(); ++i) {
    graph.node(i).x += d.segment<6>(6 * i);
  }
  for (int slot = 0; slot < graph.slot_count(); ++slot) {
    graph.border(slot).x += d.segment<3>(poses + 3 * slot);
  }
}

}  // namespace

SolveReport SolveBatch(ChainGraph& graph, int max_iterations) {
  SolveReport report{.cost = graph.Cost(), .reason = "iterations used up"};
  double lambda = 1e-6;
  while (report.iterations < max_iterations && !report.has_converged) {
    ++report.iterations;
    const NormalEquations equations(graph);
    bool has_stepped = false;
    for (; lambda < 1e8 && !has_stepped; lambda *= 10.0) {
      const Eigen::VectorXd d = equations.Solve(lambda);
      if (d.size() == 0) {
        continue;
      }
      Move(graph, d);
      const double cost = graph.Cost();
      has_stepped = cost <= report.cost * (1.0 + 1e-12);
      if (has_stepped) {
        report.has_converged = report.cost - cost <= 1e-9 * std::max(cost, 1.0);
        report.reason = "cost settled";
        report.cost = cost;
      } else {
        Move(graph, -d);
      }
    }
    if (!has_stepped) {
      report.reason = "no step lowers the cost";
      return report;
    }
    lambda = std::max(lambda * 0.01, 1e-9);
  }
  return report;
}

}  // namespace limpet

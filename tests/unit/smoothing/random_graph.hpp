// SPDX-License-Identifier: MIT
// Random chains with landmarks, pairs of them and what is known of several beforehand; and the
// whole graph's information, as one matrix.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Cholesky>

#include "estimation/smoothing/arrow_smoother.hpp"
#include "estimation/smoothing/factors/birthplace_factor.hpp"
#include "estimation/smoothing/factors/border_prior_factor.hpp"
#include "estimation/smoothing/factors/depth_factor.hpp"
#include "estimation/smoothing/factors/pose_prior_factor.hpp"
#include "estimation/smoothing/factors/roll_pitch_factor.hpp"
#include "estimation/smoothing/factors/same_place_factor.hpp"
#include "estimation/smoothing/factors/xyz_yaw_factor.hpp"
#include "limpet/core/random.hpp"

namespace limpet {

/// Feeds a smoother, a pose at a time.
class RandomGraph {
 public:
  RandomGraph(std::uint64_t seed, Smoother& smoother)
      : random_(seed, "graph"), smoother_(smoother) {}

  void AddPose() {
    const int node = smoother_.graph().node_count();
    if (node == 0) {
      smoother_.AddNode(truth_, std::nullopt);
      smoother_.AddTerm(0, Term::OnPose(PosePriorFactor(truth_, NavVector::Constant(0.1))));
    } else {
      const double turn = random_.Normal(0.2);
      const Eigen::Vector4d variance(1e-3, 1e-3, 1e-4, 1e-4);
      Eigen::Vector4d motion(0.5, random_.Normal(0.1), 0.0, turn);
      truth_.head<2>() += Turned(motion.head<2>());
      truth_(kNavYaw) += turn;
      NavVector guess = truth_;
      guess.head<2>() += Eigen::Vector2d(random_.Normal(0.1), random_.Normal(0.1));
      for (int i = 0; i < 4; ++i)
        motion(i) += random_.Normal(0.3 * std::sqrt(variance(i)));
      smoother_.AddNode(guess, Term::OnStep(XyzYawFactor(motion, variance)));
    }
    smoother_.AddTerm(node, Term::OnPose(DepthFactor(Meters(0.0), Meters(0.05))));
    smoother_.AddTerm(node,
                      Term::OnPose(RollPitchFactor(Radians(0.0), Radians(0.0), Radians(0.02))));
  }
  /// The newest pose sees a landmark: a new one now and then.
  TermId See() {
    std::size_t i = slots.empty() ? 0 : random_.Index(slots.size());
    if (slots.size() < 5 && (slots.empty() || random_.Chance(0.2))) {
      places_.emplace_back(truth_.head<3>() +
                           Eigen::Vector3d(random_.Normal(2), random_.Normal(2), 3));
      i = slots.size();
      slots.push_back(smoother_.AddLandmark(places_.back()));
    }
    const Eigen::Vector3d seen = places_[i] - truth_.head<3>() +
                                 Eigen::Vector3d(random_.Normal(0.1), random_.Normal(0.1), 0.0);
    return smoother_.AddTerm(smoother_.graph().node_count() - 1,
                             Term::OnObservation(BirthplaceFactor(seen, Meters(0.3)), slots[i]));
  }
  void AddPrior() {
    const std::size_t i = random_.Index(slots.size());
    smoother_.AddBorderTerm(
        slots[i], Term::OnBorder(BorderPriorFactor(places_[i], 0.25 * Eigen::Matrix3d::Identity()),
                                 slots[i]));
  }
  void AddPair() {
    if (slots.size() < 2) return;
    const std::size_t i = random_.Index(slots.size() - 1);
    smoother_.AddBorderTerm(slots[i + 1], Term::OnBorder(SamePlaceFactor(Meters(2.0)),
                                                         std::array{slots[i + 1], slots[i]}));
  }
  void AddJointPrior() {
    const auto n = static_cast<Eigen::Index>(3 * slots.size());
    Eigen::VectorXd mean(n);
    for (std::size_t i = 0; i < slots.size(); ++i)
      mean.segment<3>(static_cast<Eigen::Index>(3 * i)) = places_[i];
    const Eigen::MatrixXd covariance =
        0.04 * Eigen::MatrixXd::Identity(n, n) + 0.3 * Eigen::MatrixXd::Ones(n, n);
    smoother_.SetJointPrior(JointPrior(slots, mean, covariance));
  }
  void RemoveLandmark() {
    if (slots.size() < 2) return;
    const std::size_t i = random_.Index(slots.size());
    smoother_.RemoveLandmark(slots[i]);
    slots.erase(slots.begin() + static_cast<std::ptrdiff_t>(i));
    places_.erase(places_.begin() + static_cast<std::ptrdiff_t>(i));
  }
  [[nodiscard]] Random& random() { return random_; }

  std::vector<int> slots;  ///< of the landmarks there are

 private:
  [[nodiscard]] Eigen::Vector2d Turned(const Eigen::Vector2d& d) const {
    const double c = std::cos(truth_(kNavYaw)), s = std::sin(truth_(kNavYaw));
    return {c * d.x() - s * d.y(), s * d.x() + c * d.y()};
  }
  Random random_;
  Smoother& smoother_;
  NavVector truth_ = NavVector::Zero();
  std::vector<Eigen::Vector3d> places_;
};

/// Information and gradient of all of a graph where its variables are: poses, then border slots.
class WholeGraph {
 public:
  explicit WholeGraph(const ChainGraph& graph) : graph_(graph), poses_(6 * graph.node_count()) {
    const Eigen::Index n = poses_ + 3 * graph.slot_count();
    H_ = Eigen::MatrixXd::Zero(n, n);
    g_ = Eigen::VectorXd::Zero(n);
    for (int i = 0; i < graph.node_count(); ++i)
      AddNode(i);
    for (int slot = 0; slot < graph.slot_count(); ++slot)
      AddBorder(slot);
    AddJointPrior();
  }
  [[nodiscard]] Eigen::MatrixXd Covariance() const {
    return H_.llt().solve(Eigen::MatrixXd::Identity(H_.rows(), H_.cols()));
  }
  /// How far a Newton step would go from here.
  [[nodiscard]] double StepLeft() const { return H_.llt().solve(g_).lpNorm<Eigen::Infinity>(); }
  [[nodiscard]] Eigen::Index RowOf(int slot) const { return poses_ + 3 * slot; }

 private:
  void AddNode(int i) {
    LinearTerm linear;
    if (i > 0) {
      graph_.LinearizeStep(i, linear);
      Eigen::MatrixXd J = Blank(linear);
      J.middleCols(6 * (i - 1), 6) = linear.J_previous.topRows(linear.rows);
      J.middleCols(6 * i, 6) = linear.J_pose.topRows(linear.rows);
      Add(J, linear);
    }
    for (const ChainNode::Entry& entry : graph_.node(i).terms) {
      graph_.Linearize(i, entry.term, linear);
      Eigen::MatrixXd J = Blank(linear);
      J.middleCols(6 * i, 6) = linear.J_pose.topRows(linear.rows);
      FillBorders(entry.term, linear, J);
      Add(J, linear);
    }
  }
  void FillBorders(const Term& term, const LinearTerm& linear, Eigen::MatrixXd& J) const {
    for (std::size_t i = 0; i < term.slots().size(); ++i)
      J.middleCols(RowOf(term.slots()[i]), 3) = linear.J_border[i].topRows(linear.rows);
  }
  void AddBorder(int slot) {
    if (!graph_.border(slot).is_used) {
      H_.diagonal().segment(RowOf(slot), 3).setOnes();  // nothing asks about it
      return;
    }
    LinearTerm linear;
    for (const Term& term : graph_.border(slot).terms) {
      graph_.LinearizeBorder(term, linear);
      Eigen::MatrixXd J = Blank(linear);
      FillBorders(term, linear, J);
      Add(J, linear);
    }
  }
  void AddJointPrior() {
    if (!graph_.joint_prior()) return;
    const JointPrior& prior = *graph_.joint_prior();
    std::vector<Eigen::Index> rows;
    Eigen::VectorXd off = -prior.mean();
    for (std::size_t i = 0; i < prior.slots().size(); ++i) {
      off.segment<3>(static_cast<Eigen::Index>(3 * i)) += graph_.border(prior.slots()[i]).x;
      for (Eigen::Index k = 0; k < 3; ++k)
        rows.push_back(RowOf(prior.slots()[i]) + k);
    }
    H_(rows, rows) += prior.information();
    g_(rows) += prior.information() * off;
  }
  [[nodiscard]] Eigen::MatrixXd Blank(const LinearTerm& linear) const {
    return Eigen::MatrixXd::Zero(linear.rows, H_.cols());
  }
  void Add(const Eigen::MatrixXd& J, const LinearTerm& linear) {
    H_ += J.transpose() * J;
    g_ += J.transpose() * linear.r.head(linear.rows);
  }
  const ChainGraph& graph_;
  Eigen::Index poses_;
  Eigen::MatrixXd H_;
  Eigen::VectorXd g_;
};

}  // namespace limpet

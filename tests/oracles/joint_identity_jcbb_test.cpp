// SPDX-License-Identifier: MIT
// The search for identities against MRPT's joint compatibility branch and bound: two answers to one
// question, which of the things seen after a drift are which of those known before.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "estimation/association/joint_identity.hpp"
#include "limpet/core/random.hpp"

#ifdef LIMPET_HAS_MRPT_SLAM
#include <mrpt/slam/data_association.h>

namespace limpet {
namespace {

constexpr double kKnownSigma = 0.15;  // [m] of each known thing's place
constexpr double kSeenSigma = 0.1;    // [m] of each place as it is seen now
constexpr double kModelSigma = 0.1;   // [m] IdentityProblem's
constexpr double kGroundSide = 30.0;  // [m] of the ground that things lie on

/// Things known, and things seen once all places have drifted by the same.
struct DriftedScene {
  Eigen::MatrixXd known, seen;  ///< a place per row
  std::vector<int> truth;       ///< per seen thing the known one; -1: something else
  double drift = 0.0;           ///< 1-sigma [m]
};

Eigen::RowVector3d AnywhereOnGround(Random& random) {
  return {random.Uniform(0.0, kGroundSide), random.Uniform(0.0, kGroundSide),
          random.Uniform(3.0, 4.0)};
}

Eigen::RowVector3d ErrorOfPlace(Random& random, double sigma) {
  return {random.Normal(sigma), random.Normal(sigma), random.Normal(sigma)};
}

struct DriftedWorld {
  double drift = 0.0;      ///< 1-sigma [m]
  double share_new = 0.0;  ///< of what is seen
};

DriftedScene DrawDrifted(std::uint64_t seed, const DriftedWorld& world) {
  Random random(seed);
  const int known = 5 + static_cast<int>(random.Index(4));
  const int seen = 4 + static_cast<int>(random.Index(3));
  DriftedScene scene{.known = Eigen::MatrixXd(known, 3),
                     .seen = Eigen::MatrixXd(seen, 3),
                     .truth = {},
                     .drift = world.drift};
  Eigen::MatrixXd places(known, 3);
  for (int k = 0; k < known; ++k) {
    places.row(k) = AnywhereOnGround(random);
    scene.known.row(k) = places.row(k) + ErrorOfPlace(random, kKnownSigma);
  }
  const Eigen::RowVector3d shift = ErrorOfPlace(random, world.drift);
  int next = 0;
  for (int i = 0; i < seen; ++i) {
    const bool is_new = next >= known || random.Chance(world.share_new);
    scene.truth.push_back(is_new ? -1 : next);
    const Eigen::RowVector3d place = is_new ? AnywhereOnGround(random) : places.row(next++);
    scene.seen.row(i) = place + shift + ErrorOfPlace(random, kSeenSigma);
  }
  return scene;
}

/// Three rows per thing: `common` to all, and `own` of each.
Eigen::MatrixXd DriftCovariance(Eigen::Index things, double common, double own) {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(3 * things, 3 * things);
  for (Eigen::Index a = 0; a < things; ++a) {
    for (Eigen::Index b = 0; b < things; ++b)
      result.block<3, 3>(3 * a, 3 * b) = common * common * Eigen::Matrix3d::Identity();
  }
  result.diagonal().array() += own * own;
  return result;
}

std::vector<int> Ours(const DriftedScene& scene) {
  const Eigen::Index seen = scene.seen.rows(), known = scene.known.rows();
  IdentityProblem problem;
  problem.model_sigma = kModelSigma;
  problem.places.resize(3 * (seen + known));
  for (Eigen::Index i = 0; i < seen + known; ++i) {
    problem.places.segment<3>(3 * i) =
        (i < seen ? scene.seen.row(i) : scene.known.row(i - seen)).transpose();
  }
  problem.covariance = Eigen::MatrixXd::Zero(problem.places.size(), problem.places.size());
  problem.covariance.topLeftCorner(3 * seen, 3 * seen) =
      DriftCovariance(seen, scene.drift, kSeenSigma);
  problem.covariance.bottomRightCorner(3 * known, 3 * known) =
      DriftCovariance(known, 0.0, kKnownSigma);
  // Something else may lie anywhere in the volume of the ground.
  const double elsewhere = 2.0 * std::log(kGroundSide * kGroundSide);
  for (int i = 0; i < seen; ++i) {
    IdentityProblem::Claimant claimant{
        .thing = i, .new_cost = elsewhere, .overlap_cost = 0.0, .options = {}};
    for (int k = 0; k < known; ++k)
      claimant.options.push_back({.thing = static_cast<int>(seen) + k, .cost = 0.0});
    problem.claimants.push_back(claimant);
    for (int k = 0; k < i; ++k)
      problem.apart.push_back({.a = i, .b = k});
  }
  std::vector<int> is = LikeliestIdentities(problem).front().is;
  for (std::size_t i = 0; i < is.size(); ++i)
    is[i] = is[i] == static_cast<int>(i) ? -1 : is[i] - static_cast<int>(seen);
  return is;
}

std::vector<int> Theirs(const DriftedScene& scene, mrpt::slam::TDataAssociationMethod method) {
  // The difference of a pair has the drift in common with all others, and both things' own errors.
  const Eigen::MatrixXd covariance = DriftCovariance(
      scene.known.rows(), scene.drift, std::hypot(kKnownSigma, kSeenSigma, kModelSigma));
  mrpt::math::CMatrixDouble seen(scene.seen), known(scene.known), joint(covariance);
  mrpt::slam::TDataAssociationResults result;
  mrpt::slam::data_association_full_covariance(seen, known, joint, result, method,
                                               mrpt::slam::metricMaha, 0.999, false);
  std::vector<int> is(static_cast<std::size_t>(scene.seen.rows()), -1);
  for (const auto& [i, k] : result.associations)
    is[i] = static_cast<int>(k);
  return is;
}

/// How many of 200 scenes come out as they are, or as with one another.
struct Tally {
  int ours = 0, joint = 0, nearest = 0, agree = 0;
};

Tally Judge(const DriftedWorld& world) {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const DriftedScene scene = DrawDrifted(seed, world);
    const std::vector<int> ours = Ours(scene);
    const std::vector<int> joint = Theirs(scene, mrpt::slam::assocJCBB);
    tally.ours += ours == scene.truth ? 1 : 0;
    tally.joint += joint == scene.truth ? 1 : 0;
    tally.nearest += Theirs(scene, mrpt::slam::assocNN) == scene.truth ? 1 : 0;
    tally.agree += ours == joint ? 1 : 0;
  }
  return tally;
}

TEST(JointIdentityBesideJcbb, AgreesWhereTheDriftIsSmall) {
  const Tally tally = Judge({.drift = 0.3, .share_new = 0.25});
  EXPECT_GE(tally.agree, 190);
  EXPECT_GE(tally.ours, 190);
}

TEST(JointIdentityBesideJcbb, AgreesAfterALargeDriftIfNothingIsNew) {
  const Tally tally = Judge({.drift = 4.0, .share_new = 0.0});
  EXPECT_GE(tally.agree, 190);
  EXPECT_GE(tally.ours, 190);
  EXPECT_LE(tally.nearest, 100) << "each by itself would have done";
}

/// As many pairs as can be is what the other seeks: what is new is taken for what was missed.
TEST(JointIdentityBesideJcbb, KnowsWhatIsNewAfterALargeDriftWhereAsManyPairsAsCanBeDoesNot) {
  const Tally tally = Judge({.drift = 4.0, .share_new = 0.25});
  EXPECT_GE(tally.ours, 185);
  EXPECT_LE(tally.joint, 100);
}

}  // namespace
}  // namespace limpet

#else

TEST(JointIdentityBesideJcbb, IsCompared) { GTEST_SKIP() << "libmrpt-slam-dev is not installed"; }

#endif

// SPDX-License-Identifier: MIT
#include "estimation/association/triangulation.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "tests/unit/association/association_draws.hpp"

namespace limpet {
namespace {

constexpr int kPlaceCases = 200;

/// A sphere that a few poses about it see.
struct SphereScene {
  Eigen::Vector3d p_W;
  std::vector<NavVector> poses;
  std::vector<Observation> observations;
  [[nodiscard]] std::function<NavVector(int)> PoseOf() const {
    return [this](int node) { return poses[static_cast<std::size_t>(node)]; };
  }
};

class TriangulationTest : public ::testing::Test {
 protected:
  [[nodiscard]] Observation Observe(const Eigen::Vector3d& p_W, const NavVector& x, int node,
                                    Random* noise = nullptr) const {
    Box box = *BoxFrom(camera_, x, p_W);
    if (noise != nullptr) {
      const double sigma = 2.0 + 0.02 * box.w;
      box.u += noise->Normal(sigma), box.v += noise->Normal(sigma);
    }
    return ObservationOf(box, camera_, node, node);
  }
  /// Level poses over a strip of 2 m; every box is whole.
  [[nodiscard]] SphereScene Draw(Random& random, int poses, Random* noise = nullptr) const {
    SphereScene scene;
    const double yaw = random.Uniform(-3.0, 3.0), height = random.Uniform(2.5, 3.5);
    scene.p_W = {random.Uniform(-40, 40), random.Uniform(-40, 40), random.Uniform(5, 15)};
    for (int i = 0; i < poses; ++i) {
      NavVector x = NavVector::Zero();
      const double ahead = poses > 1 ? -0.6 + 1.2 * i / (poses - 1) : 0.3;
      x.head<3>() = scene.p_W + Eigen::Vector3d(ahead * std::cos(yaw), ahead * std::sin(yaw), 0) -
                    Eigen::Vector3d(0, 0, height);
      x(kNavYaw) = yaw + random.Normal(0.05);
      x(kNavPitch) = random.Normal(0.02), x(kNavRoll) = random.Normal(0.02);
      scene.poses.push_back(x);
      scene.observations.push_back(Observe(scene.p_W, x, i, noise));
    }
    return scene;
  }
  [[nodiscard]] Triangulation Solve(const SphereScene& scene) const {
    return Triangulate(scene.observations, scene.PoseOf(), mount_, model_);
  }

  const CameraModel camera_{};
  const CameraMount mount_{camera_};
  ObjectModel model_;
};

TEST_F(TriangulationTest, FindsTheSphereThatExactBoxesShow) {
  Random random(61);
  for (int i = 0; i < kPlaceCases; ++i) {
    const SphereScene scene = Draw(random, 1 + static_cast<int>(random.Index(6)));
    const Triangulation found = Solve(scene);
    EXPECT_LT((found.p_W - scene.p_W).norm(), 1e-5) << i;
    EXPECT_LT(found.worst_residual, 1e-4) << i;
  }
}

TEST_F(TriangulationTest, AWorldTurnedAndMovedHasItsSphereTurnedAndMoved) {
  Random random(62);
  for (int i = 0; i < kPlaceCases; ++i) {
    Random noise(1000 + static_cast<std::uint64_t>(i));
    SphereScene scene = Draw(random, 4, &noise);
    const Triangulation before = Solve(scene);
    const WorldChange change = DrawWorldChange(random);
    for (NavVector& x : scene.poses)
      x = change.ApplyToPose(x);
    const Triangulation after = Solve(scene);
    EXPECT_LT((after.p_W - change.Apply(before.p_W)).norm(), 1e-6) << i;
    EXPECT_TRUE(after.covariance_W.isApprox(
        change.R() * before.covariance_W * change.R().transpose(), 1e-6))
        << i;
    EXPECT_NEAR(after.worst_residual, before.worst_residual, 1e-6) << i;
  }
}

TEST_F(TriangulationTest, TheOrderOfTheLaterBoxesChangesNothing) {
  Random random(63);
  for (int i = 0; i < kPlaceCases; ++i) {
    Random noise(2000 + static_cast<std::uint64_t>(i));
    SphereScene scene = Draw(random, 6, &noise);
    const Triangulation before = Solve(scene);
    std::shuffle(scene.observations.begin() + 1, scene.observations.end(), random.engine());
    EXPECT_LT((Solve(scene).p_W - before.p_W).norm(), 1e-9) << i;
  }
}

TEST_F(TriangulationTest, ABoxMoreNeverMakesThePlaceLessCertainInAnyDirection) {
  Random random(64);
  for (int i = 0; i < kPlaceCases; ++i) {
    SphereScene scene = Draw(random, 5);
    const Observation last = scene.observations.back();
    scene.observations.pop_back();
    const Eigen::Matrix3d before = Solve(scene).covariance_W;
    scene.observations.push_back(last);
    const Eigen::Matrix3d gain = before - Solve(scene).covariance_W;
    EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(gain).eigenvalues().minCoeff(), -1e-12)
        << i;
  }
}

TEST_F(TriangulationTest, AnUnsureDetectorMakesAnUncertainPlace) {
  Random random(65);
  for (int i = 0; i < kPlaceCases; ++i) {
    const SphereScene sure = Draw(random, 4);
    SphereScene unsure = sure;
    for (Observation& one : unsure.observations)
      one.reading.sigma_px *= 2.0;
    EXPECT_GT(Solve(unsure).covariance_W.trace(), Solve(sure).covariance_W.trace()) << i;
  }
}

TEST_F(TriangulationTest, SaysHowFarItIsOff) {
  // Boxes with the noise that they are taken to have: the error is as the covariance says, no box
  // of the range's sigma more.
  Random random(66);
  double nees = 0.0;
  for (int i = 0; i < kPlaceCases; ++i) {
    Random noise(3000 + static_cast<std::uint64_t>(i));
    const SphereScene scene = Draw(random, 5, &noise);
    const Triangulation found = Solve(scene);
    const Eigen::Vector3d error = found.p_W - scene.p_W;
    nees += error.dot(found.covariance_W.llt().solve(error));
  }
  EXPECT_LT(nees / kPlaceCases, 3.6) << "surer than it is";
  EXPECT_GT(nees / kPlaceCases, 0.8) << "much less sure than it is";
}

TEST_F(TriangulationTest, ABoxOfSomethingElseStandsOut) {
  Random random(67);
  const double usual = 3.5;  // what a track may have at most, to be confirmed
  for (int i = 0; i < kPlaceCases; ++i) {
    SphereScene scene = Draw(random, 5);
    const Eigen::Vector3d other = scene.p_W + Eigen::Vector3d(0.9, -0.9, 0.0);
    const std::optional<Box> box = BoxFrom(camera_, scene.poses[2], other);
    if (!box || IsCut(*box, camera_)) continue;
    scene.observations[2] = ObservationOf(*box, camera_, 2, 2.0);
    EXPECT_GT(Solve(scene).worst_residual, usual) << i;
  }
}

TEST_F(TriangulationTest, OneCutBoxMakesAPlaceWithNumbersWhereverItIs) {
  Random random(68);
  for (int i = 0; i < kPlaceCases; ++i) {
    const NavVector x = DrawPose(random);
    const Box box{.u = random.Uniform(0.0, 640.0),
                  .v = random.Uniform(0.0, 480.0),
                  .w = random.Uniform(1.0, 640.0),
                  .h = random.Uniform(1.0, 480.0),
                  .confidence = random.Uniform(0.0, 1.0),
                  .color = "yellow"};
    Observation one = ObservationOf(box, camera_, 0);
    if (random.Chance(0.5)) one.altitude = random.Uniform(0.5, 9.0);
    const Triangulation found = Triangulate(
        {one}, [&x](int) { return x; }, mount_, model_);
    EXPECT_TRUE(found.p_W.allFinite()) << i;
    EXPECT_TRUE(found.covariance_W.allFinite()) << i;
    EXPECT_EQ(found.covariance_W.llt().info(), Eigen::Success) << i;
    EXPECT_TRUE(std::isfinite(found.worst_residual)) << i;
  }
}

TEST_F(TriangulationTest, AWholeBoxLaterInThePassGivesTheDistanceThatACutFirstOneLacks) {
  NavVector early = NavVector::Zero(), late = NavVector::Zero();
  const Eigen::Vector3d p_W(1.75, 0.0, 3.0);  // cut at the image's upper border at first
  late(kNavX) = 1.2;
  const std::vector<Observation> both{Observe(p_W, early, 0), Observe(p_W, late, 1)};
  ASSERT_FALSE(both.front().reading.is_whole());
  ASSERT_TRUE(both.back().reading.is_whole());
  const auto pose_of = [&](int node) { return node == 0 ? early : late; };
  EXPECT_LT((Triangulate(both, pose_of, mount_, model_).p_W - p_W).norm(), 1e-4);
}

/// So a near ball came into a murky image: of its cap, darkened by the border, only the middle was
/// taken for it.
TEST_F(TriangulationTest, APartTakenForACapMovesThePlaceLessForTheDetectorsDoubt) {
  const Eigen::Vector3d p_W(1.15, 0.2, 1.6);
  const auto error_with = [&](double cap_doubt) {
    std::vector<NavVector> poses(3, NavVector::Zero());
    std::vector<Observation> seen;
    for (int i = 0; i < 3; ++i) {
      NavVector& x = poses[static_cast<std::size_t>(i)];
      x(kNavX) = 0.13 * i;
      Box box = *BoxFrom(camera_, x, p_W);
      box.confidence = 1.0;
      if (i == 0) {
        const double part = 0.4;
        box.w *= 0.55, box.h *= part, box.v *= part, box.confidence = 0.5;
      }
      seen.push_back(ObservationOf(box, camera_, i, i));
      BoxNoise noise;
      noise.cap_doubt = cap_doubt;
      seen.back().reading = ReadBox(box, camera_, noise);
    }
    const auto pose_of = [&poses](int node) { return poses[static_cast<std::size_t>(node)]; };
    return (Triangulate(seen, pose_of, mount_, model_).p_W - p_W).norm();
  };
  const double as_sure_as_others = 0.0;
  EXPECT_LT(error_with(BoxNoise{}.cap_doubt), 0.6 * error_with(as_sure_as_others));
}

TEST_F(TriangulationTest, TheSeabedHoldsTheDepthOfABoxWithoutARange) {
  model_.radius_m = 0.0;  // unknown: no box tells a distance
  const NavVector x = NavVector::Zero();
  Observation one = Observe({0.0, 0.0, 3.1}, x, 0);
  one.altitude = 4.0;
  const auto pose_of = [&x](int) { return x; };
  EXPECT_NEAR(Triangulate({one}, pose_of, mount_, model_).p_W.z(), 3.1, 1e-6);
  one.altitude = 5.0;
  EXPECT_NEAR(Triangulate({one}, pose_of, mount_, model_).p_W.z(), 4.1, 1e-6);
}

TEST_F(TriangulationTest, OnlyTheFirstBoxOfAPassHintsAtTheSeabed) {
  Random random(69);
  SphereScene scene = Draw(random, 4);
  scene.observations.front().altitude = 3.0;
  const Triangulation once = Solve(scene);
  for (Observation& one : scene.observations)
    one.altitude = 3.0;
  EXPECT_EQ(Solve(scene).p_W, once.p_W);
}

TEST_F(TriangulationTest, ABoxGivesTheTermsThatItTells) {
  const auto count = [&](const Eigen::Vector3d& p_W, double radius, bool with_seabed) {
    Observation one = Observe(p_W, NavVector::Zero(), 0);
    one.altitude = 4.0;
    ObjectModel model;
    model.radius_m = radius;
    return TermsOf(one, {}, mount_.camera(), model, with_seabed).size();
  };
  const Eigen::Vector3d whole(0.0, 0.0, 3.0), side(0.0, 2.4, 3.0), corner(1.75, 2.4, 3.0);
  EXPECT_EQ(count(whole, 0.5, false), 2U) << "direction and distance";
  EXPECT_EQ(count(whole, 0.0, false), 1U) << "direction alone: how large it is, is unknown";
  EXPECT_EQ(count(whole, 0.5, true), 3U);
  EXPECT_EQ(count(side, 0.5, false), 2U) << "one axis, and the edge that shows of the other";
  EXPECT_EQ(count(side, 0.0, false), 1U);
  EXPECT_EQ(count(corner, 0.5, true), 3U) << "two edges";
  EXPECT_EQ(count(corner, 0.0, true), 0U) << "edges of what may have any size tell no place";
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "estimation/navigation/former_session_tie.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;

/// Joint covariance of places in a frame that may be off by `shift` [m] and `turn` [rad], each
/// place known to `own` [m] in it.
Eigen::MatrixXd JointOf(const std::vector<ObjectEstimate>& objects, double shift, double turn,
                        double own) {
  const auto n = static_cast<Eigen::Index>(3 * objects.size());
  Eigen::MatrixXd J(n, 4);
  for (Eigen::Index i = 0; i < n; i += 3) {
    J.middleRows<3>(i) = FrameOffset{}.Jacobian(objects[static_cast<std::size_t>(i / 3)].p_W);
  }
  const Eigen::Vector4d frame(shift * shift, shift * shift, 0.01 * 0.01, turn * turn);
  return J * frame.asDiagonal() * J.transpose() + own * own * Eigen::MatrixXd::Identity(n, n);
}

std::vector<ObjectEstimate> Objects(const std::vector<Eigen::Vector2d>& places) {
  std::vector<ObjectEstimate> objects;
  for (const Eigen::Vector2d& p : places) {
    objects.push_back({.p_W = {p.x(), p.y(), 6.0}, .color = "yellow"});
  }
  return objects;
}

const std::vector<Eigen::Vector2d> kPlaces{{4.0, 1.0}, {2.0, 10.0}, {6.0, -3.0}, {-6.0, -5.0}};

/// Objects at these places, by ids from 1 on; a place is known to `own` [m] in a frame that may be
/// off by `frame_shift` [m].
FormerSession FormerAt(const std::vector<Eigen::Vector2d>& places, double frame_shift = 0.5,
                       double own = 0.05) {
  FormerSession former;
  for (const ObjectEstimate& object : Objects(places)) {
    former.objects.push_back({.id = static_cast<int>(former.objects.size()) + 1, .object = object});
  }
  former.joint_cov_W = JointOf(Objects(places), frame_shift, 0.01, own);
  return former;
}

FormerSession Former() { return FormerAt(kPlaces); }

/// The objects of this session: places of the former one, taken along by `offset`.
PresentLandmarks Present(const std::vector<Eigen::Vector2d>& places, const FrameOffset& offset = {},
                         double frame_shift = 0.5) {
  PresentLandmarks present{.slots = {}, .objects = Objects(places), .covariance = {}};
  for (ObjectEstimate& object : present.objects) {
    object.p_W = offset.Apply(object.p_W);
    present.slots.push_back(10 + static_cast<int>(present.slots.size()));
  }
  present.covariance = JointOf(present.objects, frame_shift, 0.01, 0.05);
  return present;
}

/// Best estimate of present places with the tie's prior: (places, covariance).
std::pair<Eigen::VectorXd, Eigen::MatrixXd> Together(const PresentLandmarks& present,
                                                     const JointPrior& prior) {
  const Eigen::Index n = present.covariance.rows();
  Eigen::MatrixXd information = present.covariance.inverse();
  Eigen::VectorXd mean(n);
  for (Eigen::Index i = 0; i < n; i += 3)
    mean.segment<3>(i) = present.objects[static_cast<std::size_t>(i / 3)].p_W;
  Eigen::VectorXd pull = information * mean;
  for (std::size_t a = 0; a < prior.slots().size(); ++a) {
    const auto row = static_cast<Eigen::Index>(3 * (prior.slots()[a] - 10));
    for (std::size_t b = 0; b < prior.slots().size(); ++b) {
      const auto column = static_cast<Eigen::Index>(3 * (prior.slots()[b] - 10));
      const auto block = prior.information().block<3, 3>(static_cast<Eigen::Index>(3 * a),
                                                         static_cast<Eigen::Index>(3 * b));
      information.block<3, 3>(row, column) += block;
      pull.segment<3>(row) += block * prior.mean().segment<3>(static_cast<Eigen::Index>(3 * b));
    }
  }
  const Eigen::MatrixXd covariance = information.inverse();
  return {covariance * pull, covariance};
}

/// What each present landmark was matched with.
std::vector<std::optional<int>> IdsOf(const FormerSessionTie& tie) {
  std::vector<std::optional<int>> ids;
  for (const FormerIdentity& identity : tie.identities())
    ids.push_back(identity.id);
  return ids;
}

TEST(FormerSessionTie, FindsAShiftOfMetresAndATurnOfManyDegrees) {
  FormerSessionTie tie({.datum_sigma = Meters(8.0), .datum_turn_sigma = Radians(0.3)});
  tie.SetFormer(Former());
  FrameOffset truth{.shift_W = {5.0, -3.0}, .turn = 0.2, .pivot_W = {1.5, 0.75}};
  ASSERT_TRUE(tie.Match(Present(kPlaces, truth), std::nullopt));
  EXPECT_THAT(IdsOf(tie), ElementsAre(1, 2, 3, 4));
  EXPECT_NEAR(tie.offset().shift_W.x(), 5.0, 0.05);
  EXPECT_NEAR(tie.offset().shift_W.y(), -3.0, 0.05);
  EXPECT_NEAR(tie.offset().turn, 0.2, 0.01);
}

TEST(FormerSessionTie, FindsAFrameThatLiesElsewhereWithoutBeingTold) {
  const std::vector<Eigen::Vector2d> places{{4.0, 1.0},   {2.0, 10.0},  {6.0, -3.0},  {-6.0, -5.0},
                                            {-15.0, 2.0}, {11.0, 18.0}, {19.0, -8.0}, {-9.0, 14.0}};
  const FormerSession former = FormerAt(places);
  FormerSessionTie tie({});
  tie.SetFormer(former);
  const FrameOffset truth{.shift_W = {-14.0, 14.0}, .turn = 0.7, .pivot_W = {}};
  const PresentLandmarks present = Present(places, truth);
  ASSERT_TRUE(tie.Match(present, std::nullopt));
  EXPECT_TRUE(tie.is_elsewhere());
  EXPECT_THAT(IdsOf(tie), ElementsAre(1, 2, 3, 4, 5, 6, 7, 8));
  EXPECT_NEAR(tie.offset().turn, 0.7, 0.01);
  // It says nothing of where the places are: no surer than by this session's fixes alone.
  const auto [where, covariance] = Together(present, *tie.prior());
  EXPECT_NEAR(where(0), present.objects[0].p_W.x(), 0.1);
  EXPECT_GT(std::sqrt(covariance(0, 0)), 0.9 * std::sqrt(present.covariance(0, 0)));
  // Back where it should be, it is believed again.
  ASSERT_TRUE(tie.Match(Present(places), std::nullopt));
  EXPECT_FALSE(tie.is_elsewhere());
}

/// Evidence for it comes and goes with every landmark; where the frame lies does not.
TEST(FormerSessionTie, AFrameThatWasFoundElsewhereStaysThere) {
  const std::vector<Eigen::Vector2d> places{{4.0, 1.0},   {2.0, 10.0}, {6.0, -3.0},
                                            {-6.0, -5.0}, {-9.0, 4.0}, {11.0, 8.0}};
  const FormerSession former = FormerAt(places, 0.3, 0.15);
  FormerSessionTie tie({});
  tie.SetFormer(former);
  // Another datum; two of the objects are gone and one has come.
  const FrameOffset truth{.shift_W = {-8.0, 3.0}, .turn = 0.0, .pivot_W = {}};
  Random random(4);
  int elsewhere = 0;
  bool was_elsewhere = false;
  for (int i = 0; i < 60; ++i) {
    PresentLandmarks present =
        Present({places[0], places[1], places[2], places[3], places[4], {-2.0, -11.0}}, truth, 0.3);
    for (ObjectEstimate& object : present.objects) {
      object.p_W += Eigen::Vector3d(random.Normal(0.15), random.Normal(0.15), 0.0);
    }
    present.covariance = JointOf(present.objects, 0.3, 0.01, 0.15);
    ASSERT_TRUE(tie.Match(present, std::nullopt));
    EXPECT_TRUE(tie.is_elsewhere() || !was_elsewhere) << "lost after " << i;
    was_elsewhere = was_elsewhere || tie.is_elsewhere();
    elsewhere += tie.is_elsewhere() ? 1 : 0;
  }
  EXPECT_GT(elsewhere, 30);
}

TEST(FormerSessionTie, KnowsFourObjectsThatAgreeWhereFixesWereWorseThanTheySay) {
  const FormerSession former = FormerAt(
      {{4.0, 1.0}, {2.0, 10.0}, {6.0, -3.0}, {-6.0, -5.0}, {-9.0, 4.0}, {11.0, 8.0}}, 0.3, 0.1);
  FormerSessionTie tie({});
  tie.SetFormer(former);
  const FrameOffset off{.shift_W = {2.8, -1.8}, .turn = 0.0, .pivot_W = {}};
  const auto known = [&](const std::vector<Eigen::Vector2d>& places) {
    PresentLandmarks present = Present(places, off, 0.3);
    present.covariance = JointOf(present.objects, 0.3, 0.01, 0.1);
    EXPECT_TRUE(tie.Match(present, std::nullopt));
    return std::ranges::count_if(tie.identities(),
                                 [](const auto& one) { return one.id.has_value(); });
  };
  EXPECT_EQ(known({{4.0, 1.0}, {2.0, 10.0}, {6.0, -3.0}, {-6.0, -5.0}, {-3.0, 8.0}}), 4);
  EXPECT_FALSE(tie.is_elsewhere());
  // None of which stood there.
  EXPECT_EQ(known({{8.3, 4.0}, {-2.0, 6.0}, {-11.0, -2.0}, {0.0, -9.0}, {-3.0, 8.0}}), 0);
}

TEST(FormerSessionTie, WeighsBothSessionsFixesWhereTheirFramesAgreeAsTheyShould) {
  FormerSessionTie tie({});
  tie.SetFormer(Former());
  const FrameOffset off{.shift_W = {0.6, 0.0}, .turn = 0.0, .pivot_W = {}};
  const PresentLandmarks present = Present(kPlaces, off);
  ASSERT_TRUE(tie.Match(present, std::nullopt));
  const auto [places, covariance] = Together(present, *tie.prior());
  // Both know their frame equally well: the truth is half way, and better known than by one alone.
  EXPECT_NEAR(places(0) - kPlaces[0].x(), 0.3, 0.05);
  EXPECT_LT(std::sqrt(covariance(0, 0)), 0.75 * std::sqrt(present.covariance(0, 0)));
}

TEST(FormerSessionTie, TakesOnlyTheShapeOfASessionWhoseFrameIsFarOff) {
  FormerSessionTie tie({.datum_sigma = Meters(8.0)});
  tie.SetFormer(Former());
  const FrameOffset off{.shift_W = {6.0, 2.0}, .turn = 0.0, .pivot_W = {}};
  PresentLandmarks present = Present(kPlaces, off);
  present.objects[3].p_W.x() += 0.3;  // as drift would have it
  present.covariance(9, 9) += 0.25;
  ASSERT_TRUE(tie.Match(present, std::nullopt));
  const auto [places, covariance] = Together(present, *tie.prior());
  EXPECT_NEAR(places(0), kPlaces[0].x() + 6.0, 0.1);
  EXPECT_NEAR(places(9) - places(0), kPlaces[3].x() - kPlaces[0].x(), 0.15);
}

TEST(FormerSessionTie, IsNotDraggedByWhatWentCameOrMoved) {
  FormerSessionTie tie({});
  tie.SetFormer(Former());
  FormerSessionTie undisturbed({});
  undisturbed.SetFormer(Former());
  const FrameOffset off{.shift_W = {0.4, -0.3}, .turn = 0.0, .pivot_W = {}};
  // The first and the last are where they were; the second moved by 2 m, one is new.
  ASSERT_TRUE(tie.Match(Present({kPlaces[0], kPlaces[3], {2.0, 12.0}, {-3.0, 11.0}}, off), {}));
  ASSERT_TRUE(undisturbed.Match(Present({kPlaces[0], kPlaces[3]}, off), {}));
  EXPECT_THAT(IdsOf(tie), ElementsAre(1, 4, std::nullopt, std::nullopt));
  EXPECT_THAT(tie.prior()->slots(), ElementsAre(10, 11));
  EXPECT_LT((tie.offset().vector() - undisturbed.offset().vector()).norm(), 0.005);
}

TEST(FormerSessionTie, AMatchDoesNotProveItself) {
  FormerSessionTie tie({});
  tie.SetFormer(Former());
  const FrameOffset off{.shift_W = {0.9, 0.5}, .turn = 0.01, .pivot_W = {}};
  const PresentLandmarks alone = Present(kPlaces, off);
  ASSERT_TRUE(tie.Match(alone, std::nullopt));
  const JointPrior first = *tie.prior();
  const FrameOffset offset = tie.offset();
  // As the smoother has them once it has taken the prior in.
  PresentLandmarks tied = alone;
  const auto [places, covariance] = Together(alone, first);
  tied.covariance = covariance;
  for (Eigen::Index i = 0; i < places.size(); i += 3)
    tied.objects[static_cast<std::size_t>(i / 3)].p_W = places.segment<3>(i);
  ASSERT_TRUE(tie.Match(tied, first));
  EXPECT_LT((tie.offset().vector() - offset.vector()).norm(), 1e-4);
  EXPECT_LT((tie.prior()->mean() - first.mean()).norm(), 1e-3);
}

TEST(FormerSessionTie, DoesNotAskALandmarkWhosePlaceAmongTheOthersIsNotKnown) {
  FormerSessionTie tie({});
  tie.SetFormer(Former());
  // The last one was seen after a dropout of the DVL: it may be anything within metres.
  PresentLandmarks present = Present({kPlaces[0], kPlaces[1], kPlaces[2], {-4.5, -4.0}});
  present.covariance.block<2, 2>(9, 9) += 4.0 * Eigen::Matrix2d::Identity();
  ASSERT_TRUE(tie.Match(present, std::nullopt));
  EXPECT_THAT(IdsOf(tie), ElementsAre(1, 2, 3, std::nullopt));
  ASSERT_EQ(tie.identities()[3].candidates.size(), 1U) << "but it may be the fourth";
  EXPECT_EQ(tie.identities()[3].candidates[0].id, 4);
  EXPECT_GT(tie.identities()[3].candidates[0].probability, 0.1);
  EXPECT_LT(tie.identities()[3].candidates[0].probability, 0.9);
  EXPECT_THAT(tie.prior()->slots(), ElementsAre(10, 11, 12));
}

TEST(FormerSessionTie, ALandmarkThatFitsNoFormerObjectIsNoCandidate) {
  FormerSessionTie tie({});
  tie.SetFormer(Former());
  PresentLandmarks present = Present({kPlaces[0], kPlaces[1], kPlaces[2], {9.0, 12.0}});
  present.covariance.block<2, 2>(9, 9) += 1.0 * Eigen::Matrix2d::Identity();
  ASSERT_TRUE(tie.Match(present, std::nullopt));
  EXPECT_THAT(tie.identities()[3].candidates, ::testing::IsEmpty());
}

TEST(FormerSessionTie, DecidesThroughADriftOfHalfAMetre) {
  FormerSessionTie tie({});
  tie.SetFormer(Former());
  const FrameOffset drift{.shift_W = {0.4, -0.3}, .turn = 0.01, .pivot_W = {}};
  ASSERT_TRUE(tie.Match(Present({kPlaces[0], kPlaces[2], kPlaces[3]}, drift), std::nullopt));
  EXPECT_THAT(IdsOf(tie), ElementsAre(1, 3, 4));
  for (const FormerIdentity& identity : tie.identities())
    EXPECT_TRUE(identity.is_decided());
}

/// Alone, one object of two that stand a metre apart may be either: the frames may be off by that.
TEST(FormerSessionTie, DoesNotDecideWhichOfTwoCloseFormerObjectsIsLeft) {
  const FormerSession former = FormerAt({{4.0, 1.0}, {4.0, 2.0}});
  FormerSessionTie tie({});
  tie.SetFormer(former);
  ASSERT_TRUE(tie.Match(Present({{4.0, 1.4}}), std::nullopt));
  ASSERT_EQ(tie.identities()[0].candidates.size(), 2U);
  EXPECT_NEAR(
      tie.identities()[0].candidates[0].probability + tie.identities()[0].candidates[1].probability,
      1.0, 1e-9);
  EXPECT_EQ(tie.identities()[0].id, 1) << "the likelier one";
  EXPECT_FALSE(tie.prior());
}

/// Others tell where the frame lies.
TEST(FormerSessionTie, DecidesWhichOfTwoCloseFormerObjectsIsLeftIfOthersPinTheFrame) {
  const FormerSession former = FormerAt({{4, 1}, {4, 2}, {-6, -5}, {6, -9}, {-2, 10}});
  FormerSessionTie tie({});
  tie.SetFormer(former);
  const FrameOffset drift{.shift_W = {0.3, 0.4}, .turn = 0.0, .pivot_W = {}};
  ASSERT_TRUE(tie.Match(Present({{4, 2}, {-6, -5}, {6, -9}, {-2, 10}}, drift), std::nullopt));
  EXPECT_THAT(IdsOf(tie), ElementsAre(2, 3, 4, 5));
  EXPECT_THAT(tie.identities()[0].candidates, ::testing::IsEmpty());
}

/// Over random fields: chances are chances, what is decided has no candidates, and an undecided
/// landmark ties nothing.
TEST(FormerSessionTieProperties, CandidatesAreChancesOfWhatIsNotDecided) {
  Random random(5);
  for (int trial = 0; trial < 60; ++trial) {
    std::vector<Eigen::Vector2d> places;
    for (int i = 0; i < 4; ++i)
      places.emplace_back(random.Uniform(-4.0, 4.0), random.Uniform(-4.0, 4.0));
    const FormerSession former = FormerAt(places);
    places.erase(places.begin() + trial % 4);
    const FrameOffset drift{.shift_W = {random.Uniform(-0.5, 0.5), random.Uniform(-0.5, 0.5)},
                            .turn = 0.0,
                            .pivot_W = {}};
    PresentLandmarks present = Present(places, drift);
    present.covariance.block<2, 2>(6, 6) += random.Uniform(0.0, 2.0) * Eigen::Matrix2d::Identity();
    FormerSessionTie tie({});
    tie.SetFormer(former);
    ASSERT_TRUE(tie.Match(present, std::nullopt));
    for (std::size_t j = 0; j < places.size(); ++j) {
      double sum = 0.0;
      for (const FormerCandidate& candidate : tie.identities()[j].candidates) {
        EXPECT_GE(candidate.id, 1);
        EXPECT_LE(candidate.id, 4);
        EXPECT_LT(candidate.probability, 1.0);
        sum += candidate.probability;
      }
      EXPECT_LE(sum, 1.0 + 1e-9);
      const bool is_tied =
          tie.prior() && std::ranges::count(tie.prior()->slots(), 10 + static_cast<int>(j)) > 0;
      EXPECT_FALSE(is_tied && !tie.identities()[j].candidates.empty()) << trial;
    }
  }
}

TEST(FormerSessionTie, LetsGoOfALandmarkThatHasComeInDoubt) {
  FormerSessionTie tie({});
  tie.SetFormer(Former());
  PresentLandmarks present = Present({kPlaces[0], kPlaces[1], kPlaces[2]});
  ASSERT_TRUE(tie.Match(present, std::nullopt));
  const JointPrior applied = *tie.prior();
  present.covariance = Together(present, applied).second;
  present.others = 1;  // the last one
  ASSERT_TRUE(tie.Match(present, applied));
  EXPECT_THAT(IdsOf(tie), ElementsAre(1, 2, std::nullopt));
  EXPECT_THAT(tie.prior()->slots(), ElementsAre(10, 11));
}

TEST(FormerSessionTie, TwoThatLieAlikeAmongManyThatDoNotAreChance) {
  FormerSessionTie tie({});
  tie.SetFormer(Former());
  std::vector<Eigen::Vector2d> places{kPlaces[0], kPlaces[1]};
  for (int i = 0; i < 30; ++i)
    places.emplace_back(-40.0 - 3.0 * (i / 6), 20.0 + 5.0 * (i % 6));
  ASSERT_TRUE(tie.Match(Present(places), std::nullopt));
  EXPECT_FALSE(tie.prior()) << "of this place more would be known";
  EXPECT_THAT(IdsOf(tie), Each(std::nullopt));
  places.resize(4);
  ASSERT_TRUE(tie.Match(Present(places), std::nullopt));
  EXPECT_TRUE(tie.prior()) << "two of four";
}

TEST(FormerSessionTie, OneObjectAloneTiesNothing) {
  FormerSessionTie tie({});
  tie.SetFormer(Former());
  ASSERT_TRUE(tie.Match(Present({kPlaces[2]}), std::nullopt));
  EXPECT_THAT(IdsOf(tie), ElementsAre(3));
  EXPECT_FALSE(tie.prior());
}

TEST(FormerSessionTie, LivesWithCovariancesThatAreNone) {
  FormerSession broken = Former();
  broken.joint_cov_W.setConstant(-1.0);
  for (FormerObject& former : broken.objects)
    former.object.cov_W = -Eigen::Matrix3d::Identity();
  FormerSessionTie tie({});
  tie.SetFormer(broken);
  ASSERT_TRUE(tie.Match(Present(kPlaces), std::nullopt));
  EXPECT_THAT(IdsOf(tie), ElementsAre(1, 2, 3, 4));
}

TEST(FormerSessionTie, HasNothingToSayWithoutFormerObjects) {
  FormerSessionTie tie({});
  tie.SetFormer({});
  EXPECT_FALSE(tie.Match(Present(kPlaces), std::nullopt));
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
// What must hold of associations in any scene: random ones, with fixed seeds.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/object_flight.hpp"

namespace limpet {
namespace {

/// Objects of a random scene, none nearer to another than `apart` [m].
std::vector<Eigen::Vector3d> RandomObjects(std::uint64_t seed, std::size_t count, double apart) {
  Random random(seed, "objects");
  std::vector<Eigen::Vector3d> objects;
  while (objects.size() < count) {
    const Eigen::Vector3d p(random.Uniform(1.0, 13.0), random.Uniform(0.0, 6.0),
                            random.Uniform(6.0, 7.0));
    const bool is_free = std::ranges::none_of(
        objects, [&](const Eigen::Vector3d& other) { return (other - p).norm() < apart; });
    if (is_free) objects.push_back(p);
  }
  return objects;
}

Eigen::Vector2d Turned(const Eigen::Vector2d& p, double angle) {
  return {std::cos(angle) * p.x() - std::sin(angle) * p.y(),
          std::sin(angle) * p.x() + std::cos(angle) * p.y()};
}
Eigen::Vector3d Turned(const Eigen::Vector3d& p, double angle) {
  const Eigen::Vector2d level = Turned(Eigen::Vector2d(p.head<2>()), angle);
  return {level.x(), level.y(), p.z()};
}

/// Flies three lanes over the scene and one across them.
class Survey : public ObjectFlight {
 public:
  explicit Survey(std::vector<Eigen::Vector3d> objects, std::uint64_t seed = 3,
                  double heading = 0.0)
      : ObjectFlight(seed, heading), heading_(heading) {
    objects_ = std::move(objects);
    for (Eigen::Vector3d& object : objects_)
      object = Turned(object, heading);
  }
  void Fly() {
    for (const Eigen::Vector2d& p : std::vector<Eigen::Vector2d>{{14.0, 0.0},
                                                                 {14.0, 3.0},
                                                                 {0.0, 3.0},
                                                                 {0.0, 6.0},
                                                                 {14.0, 6.0},
                                                                 {7.0, 6.0},
                                                                 {7.0, -1.0}})
      FlyTo(Turned(Eigen::Vector2d(p.x(), side_ * p.y()), heading_));
  }
  /// Landmarks' places at the optimum, in the scene's own axes, south to north.
  [[nodiscard]] std::vector<Eigen::Vector3d> Places() {
    smoother_.Converge();
    tracker_.Refresh();
    std::vector<Eigen::Vector3d> places;
    for (const TrackedObject& object : Found())
      places.push_back(Turned(object.p_W, -heading_));
    std::ranges::sort(places, {}, [](const Eigen::Vector3d& p) { return p.x(); });
    return places;
  }
  /// Per object of the scene: names that its boxes were given, and boxes that were given one.
  std::map<std::size_t, std::set<int>> names_;
  std::map<std::size_t, std::vector<int>> named_frames_;
  int double_names_ = 0;  ///< frames in which two boxes were given one name
  double side_ = 1.0;     ///< -1: lanes to the west

 protected:
  void OnFrame() override {
    std::set<int> seen;
    for (std::size_t i = 0; i < shown_.size(); ++i) {
      if (!shown_[i]) continue;
      double_names_ += seen.insert(*shown_[i]).second ? 0 : 1;
      if (!truth_of_box_[i]) continue;
      names_[*truth_of_box_[i]].insert(*shown_[i]);
      named_frames_[*truth_of_box_[i]].push_back(frame_);
    }
  }

 private:
  double heading_;
};

void ExpectSamePlaces(const std::vector<Eigen::Vector3d>& a, const std::vector<Eigen::Vector3d>& b,
                      double within) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    EXPECT_LT((a[i] - b[i]).norm(), within) << "landmark " << i;
}

class RandomScene : public ::testing::TestWithParam<std::uint64_t> {
 protected:
  const std::vector<Eigen::Vector3d> objects_ = RandomObjects(GetParam(), 5, 2.2);
};

TEST_P(RandomScene, EveryObjectIsOneLandmarkWhereItIs) {
  Survey survey(objects_, GetParam());
  survey.Fly();
  const std::vector<Eigen::Vector3d> places = survey.Places();
  EXPECT_EQ(places.size(), objects_.size());
  for (const Eigen::Vector3d& object : objects_) {
    const auto near = std::ranges::count_if(
        places, [&](const Eigen::Vector3d& p) { return (p - object).norm() < 0.25; });
    EXPECT_EQ(near, 1);
  }
}

TEST_P(RandomScene, BoxesOfOneObjectHaveOneNameAndNoOthersDo) {
  Survey survey(objects_, GetParam());
  survey.Fly();
  std::set<int> all;
  for (const auto& [object, names] : survey.names_) {
    EXPECT_EQ(names.size(), 1U) << "object " << object;
    for (const int name : names)
      EXPECT_TRUE(all.insert(name).second) << "one name of two objects";
  }
  EXPECT_EQ(all.size(), objects_.size());
  EXPECT_EQ(survey.double_names_, 0);
}

TEST_P(RandomScene, TheOrderOfTheBoxesInAFrameChangesNothing) {
  Survey forward(objects_, GetParam()), backward(objects_, GetParam());
  backward.reorder_ = [](std::vector<std::size_t>& order) { std::ranges::reverse(order); };
  forward.Fly();
  backward.Fly();
  ExpectSamePlaces(forward.Places(), backward.Places(), 1e-5);
  EXPECT_EQ(forward.named_frames_, backward.named_frames_);
}

TEST_P(RandomScene, AnObjectFarAwayChangesNoBoxOfTheOthers) {
  std::vector<Eigen::Vector3d> more = objects_;
  more.emplace_back(7.0, -9.5, 6.5);
  Survey without(objects_, GetParam()), with(more, GetParam());
  without.noise_px_ = with.noise_px_ = 0.0;  // a draw more would change all that follow
  for (Survey* survey : {&with, &without}) {
    survey->Fly();
    survey->FlyTo({7.0, -12.0});
  }
  EXPECT_EQ(with.Places().size(), objects_.size() + 1);
  with.named_frames_.erase(objects_.size());
  EXPECT_EQ(with.named_frames_, without.named_frames_);
}

TEST_P(RandomScene, AWorldTurnedWithItsVehicleHasTheSameLandmarks) {
  // Gates take the worse of north and east, so here and there a box more or less is used.
  Survey ahead(objects_, GetParam());
  ahead.Fly();
  for (const double heading : {0.5 * std::numbers::pi, -2.1}) {
    Survey turned(objects_, GetParam(), heading);
    turned.Fly();
    ExpectSamePlaces(ahead.Places(), turned.Places(), 0.05);
  }
}

TEST_P(RandomScene, AMirroredWorldHasMirroredLandmarks) {
  std::vector<Eigen::Vector3d> mirrored = objects_;
  for (Eigen::Vector3d& object : mirrored)
    object.y() = -object.y();
  Survey east(objects_, GetParam()), west(mirrored, GetParam());
  west.side_ = -1.0;
  east.noise_px_ = west.noise_px_ = 0.0;
  east.Fly();
  west.Fly();
  std::vector<Eigen::Vector3d> places = west.Places();
  for (Eigen::Vector3d& p : places)
    p.y() = -p.y();
  ExpectSamePlaces(east.Places(), places, 1e-4);
}

TEST_P(RandomScene, DetectionsThatComeAndGoMakeNoDuplicates) {
  Survey survey(objects_, GetParam());
  survey.hit_share_ = 0.7;
  survey.Fly();
  EXPECT_EQ(survey.Places().size(), objects_.size());
}

TEST_P(RandomScene, FalseBoxesMakeNoLandmark) {
  Survey survey(objects_, GetParam());
  survey.false_share_ = 0.05;
  survey.Fly();
  for (const Eigen::Vector3d& p : survey.Places()) {
    EXPECT_TRUE(std::ranges::any_of(
        objects_, [&](const Eigen::Vector3d& object) { return (object - p).norm() < 0.3; }));
  }
}

TEST_P(RandomScene, BoxesTooDoubtfulToUseAreAsIfTheyWereNotThere) {
  Survey survey(objects_, GetParam());
  survey.confidence_ = ObjectTrackerParams{}.min_confidence - 0.01;
  survey.Fly();
  EXPECT_TRUE(survey.Places().empty());
  EXPECT_TRUE(survey.names_.empty());
}

TEST_P(RandomScene, ASecondVisitAfterDriftThatOdometryAdmitsMergesEveryObjectWithItself) {
  Survey survey(objects_, GetParam());
  survey.Fly();
  const std::vector<Eigen::Vector3d> before = survey.Places();
  survey.step_sigma_ = 0.04;
  Random random(GetParam(), "drift");
  survey.FlyTo({7.0, -14.0}, {random.Normal(0.3), random.Normal(0.3)});
  survey.FlyTo({-6.0, -14.0});
  survey.step_sigma_ = 0.01;
  survey.FlyTo({-6.0, 0.0});
  survey.Fly();
  survey.FlyTo({-6.0, -6.0});
  ExpectSamePlaces(survey.Places(), before, 0.3);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomScene, ::testing::Range<std::uint64_t>(1, 9));

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/planning/seen_planes.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/planning/seen_along.hpp"
#include "tests/unit/planning/search_scene.hpp"

namespace limpet {
namespace {

constexpr std::size_t kPlaneBottom = SeenPlanes::kBottom, kPlaneTop = SeenPlanes::kTop;

/// Cells of the bottom and of the top that the images along `path` would newly show.
SeenPlanes::Counts ShownByImages(const Ground& ground, const DubinsPath& path) {
  SeenWorkspace images(ground);
  path.Sample(0.125, [&images](const Pose2& pose, double) { images.Look(pose); });
  SeenPlanes::Counts shown{};
  std::vector<std::uint8_t> first(ground.levels().size() * 2, Footprint::kLayers);
  std::vector<std::uint8_t> last = first;
  for (const SeenWorkspace::Change& change : images.changes()) {
    first[change.cell] = std::min(first[change.cell], change.before);
    last[change.cell] = change.after;
  }
  for (const SeenWorkspace::Change& change : images.changes()) {
    const std::size_t cell = change.cell;
    shown[kPlaneBottom] += first[cell] == 0 ? 1 : 0;
    shown[kPlaneTop] +=
        first[cell] < Footprint::kLayers && last[cell] == Footprint::kLayers ? 1 : 0;
    first[cell] = last[cell] = Footprint::kLayers;  // each cell once
  }
  return shown;
}

/// They look only every metre of a turn: what they lack are slivers at its outer side.
TEST(SeenPlanes, CountWhatTheImagesAlongAPathWouldShowOrALittleLess) {
  const scene::HalfSeen half;
  Random random(4);
  for (int i = 0; i < 20; ++i) {
    const Pose2 from{random.Uniform(-12.0, 12.0), random.Uniform(-15.0, 15.0),
                     random.Uniform(-3.0, 3.0)};
    const DubinsPath path(
        from, {{0.0, random.Uniform(1.0, 20.0)},
               {random.Chance(0.5) ? 1.0 / 3.0 : -1.0 / 3.0, random.Uniform(1.0, 9.0)}});
    const SeenPlanes::Counts images = ShownByImages(half.ground, path);
    SeenPlanes planes(half.ground);
    const SeenPlanes::Counts before = planes.unseen();
    Pose2 pose = path.start();
    planes.Look(pose);
    for (const PathSegment& segment : path.segments()) {
      planes.Sweep(pose, segment);
      pose = Advance(pose, segment);
    }
    for (const std::size_t plane : {kPlaneBottom, kPlaneTop}) {
      const int shown = before[plane] - planes.unseen()[plane];
      EXPECT_LE(shown, images[plane] + 2) << "plane " << plane;
      EXPECT_GE(shown, 0.95 * images[plane] - 2) << "plane " << plane;
    }
  }
}

TEST(SeenPlanes, AreAsBeforeAfterRewind) {
  const scene::HalfSeen half;
  SeenPlanes planes(half.ground);
  planes.Sweep({0.0, 0.0, 0.3}, {.curvature = 0.0, .length = 10.0});
  const SeenPlanes::Counts kept = planes.unseen();
  const SeenPlanes::Moment then = planes.Mark();
  planes.Sweep({5.0, 0.0, 1.3}, {.curvature = 0.3, .length = 10.0});
  ASSERT_NE(planes.unseen(), kept);
  planes.Rewind(then);
  EXPECT_EQ(planes.unseen(), kept);
}

TEST(SeenPlanes, NameEveryCellThatIsUnseen) {
  const scene::HalfSeen half;
  const SeenPlanes planes(half.ground);
  int n = 0;
  planes.EachUnseen(kPlaneTop, [&](double north, double east) {
    const PlanePoint cell = planes.NthUnseen(kPlaneTop, n++);
    ASSERT_EQ(cell.x(), north);
    ASSERT_EQ(cell.y(), east);
  });
  EXPECT_EQ(n, planes.unseen()[kPlaneTop]);
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/imaging/picture_renderer.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "limpet/imaging/solid_image.hpp"

namespace limpet {
namespace {

PictureSettings Real() {
  PictureSettings settings{
      .scene = {.camera = {}, .seabed_depth = [](const Eigen::Vector2d&) { return 7.5; }},
      .image = {}};
  settings.image.look = "real";
  settings.image.seabed.kind = "sand";
  return settings;
}

Pose HighUp(double altitude) {
  Pose pose;
  pose.p_WB = {1.0, 2.0, 7.5 - altitude};
  return pose;
}

TEST(PictureRenderer, EqualInputGivesEqualBytes) {
  PictureRenderer one(Real());
  PictureRenderer two(Real());
  const std::vector<Solid> solids{{.p_W = {1.2, 2.2, 7.0}, .radius = 0.3, .color = "yellow"}};
  const Image first = one.Render(HighUp(3.0), solids, 7, Seconds(1.0));
  static_cast<void>(two.Render(HighUp(2.0), {}, 3, Seconds(9.0)));  // must not matter
  EXPECT_EQ(first.bgr, two.Render(HighUp(3.0), solids, 7, Seconds(1.0)).bgr);
  EXPECT_NE(first.bgr, two.Render(HighUp(3.0), solids, 8, Seconds(1.0)).bgr);
}

TEST(PictureRenderer, LabelsAreTheSilhouettesOfEveryKind) {
  PictureSettings settings = Real();
  settings.image.clutter = {.natural_per_m2 = 0.0, .litter_per_m2 = 0.0};
  PictureRenderer renderer(settings);
  for (const std::string& kind : SolidKindNames()) {
    Solid solid{.kind = *SolidKindOf(kind),
                .p_W = {1.3, 2.6, 6.3},
                .radius = 0.3,
                .height = 0.4,
                .color = "red"};
    solid.R_WS = RotationFromRollPitchYaw(0.4, 0.3, 0.9);
    static_cast<void>(renderer.Render(HighUp(4.0), std::span(&solid, 1), 0, Seconds(0.0)));
    ASSERT_EQ(renderer.labels().size(), 1U) << kind;
    const SolidLabel& label = renderer.labels().front();
    const auto outline = OutlineOf(settings.scene.camera, HighUp(4.0), solid);
    EXPECT_NEAR(label.visible.left, outline->left, 1.5) << kind;
    EXPECT_NEAR(label.visible.right, outline->right, 1.5) << kind;
    EXPECT_NEAR(label.visible.top, outline->top, 1.5) << kind;
    EXPECT_NEAR(label.visible.bottom, outline->bottom, 1.5) << kind;
    EXPECT_EQ(label.visible_fraction, 1.0) << kind;
  }
}

TEST(PictureRenderer, LabelOfAHiddenSolidIsOfWhatCanBeSeen) {
  PictureRenderer renderer(Real());
  // The upper covers the lower's right half and more.
  const std::vector<Solid> solids{{.p_W = {1.0, 2.0, 7.0}, .radius = 0.3, .color = "red"},
                                  {.p_W = {1.0, 2.4, 6.0}, .radius = 0.4, .color = "white"}};
  static_cast<void>(renderer.Render(HighUp(4.0), solids, 0, Seconds(0.0)));
  ASSERT_EQ(renderer.labels().size(), 2U);
  const SolidLabel& lower = renderer.labels().front();
  EXPECT_EQ(lower.solid, 0U);
  EXPECT_LT(lower.visible_fraction, 0.8);
  EXPECT_LT(lower.visible.right, lower.outline.right - 5.0);
  EXPECT_EQ(renderer.labels().back().visible_fraction, 1.0);
}

TEST(PictureRenderer, SurvivesAHorizonInTheImage) {
  PictureRenderer renderer(Real());
  Pose pose = HighUp(3.0);
  pose.roll = 1.4;
  EXPECT_EQ(renderer.Render(pose, {}, 0, Seconds(0.0)).bgr.size(), 3U * 640U * 480U);
}

}  // namespace
}  // namespace limpet

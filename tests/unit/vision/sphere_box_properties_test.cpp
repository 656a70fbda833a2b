// SPDX-License-Identifier: MIT
// What a camera sees of a sphere, against rays that touch it and pixels that are counted.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/vision/box_model.hpp"
#include "limpet/vision/paint_classifier.hpp"
#include "limpet/vision/sphere_box.hpp"

namespace limpet {
namespace {

struct SeenSphere {
  Eigen::Vector3d p_C;
  double radius;
};

/// In front of the camera, anywhere about the image and its borders.
SeenSphere DrawSphere(Random& random) {
  const double depth = random.Uniform(1.5, 8.0);
  return {{random.Uniform(-1.1, 1.1) * depth, random.Uniform(-0.8, 0.8) * depth, depth},
          random.Uniform(0.1, 0.9)};
}

double DistanceToRay(const Eigen::Vector3d& p, const Eigen::Vector3d& ray) {
  return (p - p.dot(ray) * ray).norm();
}

TEST(SphereChords, EndWhereRaysTouchTheSphere) {
  const CameraModel camera;
  Random random(1, "chords");
  int chords = 0;
  for (int run = 0; run < 300; ++run) {
    const SeenSphere sphere = DrawSphere(random);
    const double v = random.Uniform(-50.0, 530.0);
    const auto chord = ChordOfSphere(camera, v, sphere.p_C, sphere.radius);
    if (!chord) continue;
    ++chords;
    EXPECT_LT(chord->left, chord->right);
    for (const double u : {chord->left, chord->right}) {
      EXPECT_NEAR(DistanceToRay(sphere.p_C, camera.RayOf({u, v})), sphere.radius, 1e-6);
    }
    const double middle = 0.5 * (chord->left + chord->right);
    EXPECT_LT(DistanceToRay(sphere.p_C, camera.RayOf({middle, v})), sphere.radius);
  }
  EXPECT_GT(chords, 30);
}

TEST(SphereChords, AreThereExactlyInTheRowsOfTheOutline) {
  const CameraModel camera;
  Random random(2, "chords");
  for (int run = 0; run < 200; ++run) {
    const SeenSphere sphere = DrawSphere(random);
    const auto image = ImageOfSphere(camera, sphere.p_C, sphere.radius);
    if (!image) continue;
    const PixelRect& outline = image->outline;
    for (double share = -0.2; share <= 1.2; share += 0.05) {
      if (std::abs(share) < 0.01 || std::abs(share - 1.0) < 0.01) continue;  // at the very edge
      const double v = outline.top + share * outline.height();
      const auto chord = ChordOfSphere(camera, v, sphere.p_C, sphere.radius);
      EXPECT_EQ(chord.has_value(), share > 0.0 && share < 1.0) << share;
      if (chord) {
        EXPECT_GE(chord->left, outline.left - 1e-6);
        EXPECT_LE(chord->right, outline.right + 1e-6);
      }
    }
  }
}

TEST(SphereImages, HaveTheirVisiblePartInsideTheOutlineAndThePicture) {
  const CameraModel camera;
  Random random(3, "images");
  for (int run = 0; run < 500; ++run) {
    const SeenSphere sphere = DrawSphere(random);
    const auto image = ImageOfSphere(camera, sphere.p_C, sphere.radius);
    if (!image) continue;
    const PixelRect &visible = image->visible, &outline = image->outline;
    EXPECT_GE(visible.left, std::max(0.0, outline.left) - 1e-6);
    EXPECT_GE(visible.top, std::max(0.0, outline.top) - 1e-6);
    EXPECT_LE(visible.right, std::min(640.0, outline.right) + 1e-6);
    EXPECT_LE(visible.bottom, std::min(480.0, outline.bottom) + 1e-6);
    EXPECT_GT(image->visible_fraction, 0.0);
    EXPECT_LE(image->visible_fraction, 1.0 + 1e-9);
    EXPECT_NEAR(image->range, sphere.p_C.norm(), 1e-9);
  }
}

TEST(SphereImages, ShowTheShareThatCountingRowsFinds) {
  const CameraModel camera;
  Random random(4, "images");
  for (int run = 0; run < 60; ++run) {
    const SeenSphere sphere = DrawSphere(random);
    const auto image = ImageOfSphere(camera, sphere.p_C, sphere.radius);
    if (!image) continue;
    double whole = 0.0, inside = 0.0;
    const double step = image->outline.height() / 800.0;
    for (double v = image->outline.top + 0.5 * step; v < image->outline.bottom; v += step) {
      const auto chord = ChordOfSphere(camera, v, sphere.p_C, sphere.radius);
      if (!chord) continue;
      whole += chord->right - chord->left;
      const double cut = std::min(chord->right, 640.0) - std::max(chord->left, 0.0);
      inside += v >= 0.0 && v <= 480.0 ? std::max(cut, 0.0) : 0.0;
    }
    EXPECT_NEAR(image->visible_fraction, inside / whole, 0.01);
  }
}

TEST(SphereImages, AreMirroredWithTheirSphere) {
  const CameraModel camera;
  Random random(5, "images");
  for (int run = 0; run < 200; ++run) {
    const SeenSphere sphere = DrawSphere(random);
    const auto image = ImageOfSphere(camera, sphere.p_C, sphere.radius);
    const auto mirrored =
        ImageOfSphere(camera, {-sphere.p_C.x(), sphere.p_C.y(), sphere.p_C.z()}, sphere.radius);
    ASSERT_EQ(image.has_value(), mirrored.has_value());
    if (!image) continue;
    EXPECT_NEAR(mirrored->outline.left, 640.0 - image->outline.right, 1e-6);
    EXPECT_NEAR(mirrored->outline.top, image->outline.top, 1e-6);
    EXPECT_NEAR(mirrored->visible_fraction, image->visible_fraction, 1e-3);
  }
}

TEST(SphereImages, GrowWithTheSphere) {
  const CameraModel camera;
  Random random(6, "images");
  for (int run = 0; run < 200; ++run) {
    const SeenSphere sphere = DrawSphere(random);
    const auto small = ImageOfSphere(camera, sphere.p_C, sphere.radius);
    const auto large = ImageOfSphere(camera, sphere.p_C, 1.2 * sphere.radius);
    if (!small || !large) continue;
    EXPECT_LT(large->outline.left, small->outline.left);
    EXPECT_GT(large->outline.right, small->outline.right);
    EXPECT_LT(large->outline.top, small->outline.top);
    EXPECT_GT(large->outline.bottom, small->outline.bottom);
  }
}

PixelRect DrawRect(Random& random) {
  const double left = std::floor(random.Uniform(0.0, 20.0));
  const double top = std::floor(random.Uniform(0.0, 20.0));
  return {left, top, left + std::floor(random.Uniform(1.0, 15.0)),
          top + std::floor(random.Uniform(1.0, 15.0))};
}

bool Covers(const PixelRect& rect, double u, double v) {
  return u > rect.left && u < rect.right && v > rect.top && v < rect.bottom;
}

TEST(Overlaps, AreTheSharesOfPixelsThatTheRectanglesHaveInCommon) {
  Random random(7, "overlaps");
  for (int run = 0; run < 300; ++run) {
    const PixelRect a = DrawRect(random), b = DrawRect(random);
    int both = 0, any = 0;
    for (double u = 0.5; u < 40.0; ++u) {
      for (double v = 0.5; v < 40.0; ++v) {
        both += Covers(a, u, v) && Covers(b, u, v) ? 1 : 0;
        any += Covers(a, u, v) || Covers(b, u, v) ? 1 : 0;
      }
    }
    EXPECT_NEAR(Overlap(a, b), static_cast<double>(both) / any, 1e-12);
    EXPECT_EQ(Overlap(a, b), Overlap(b, a));
  }
}

TEST(PaintClasses, DoNotChangeWithTheHazeThatOnlyScalesContrast) {
  Random random(8, "paint");
  int named = 0;
  for (int run = 0; run < 500; ++run) {
    const Eigen::Vector3d difference(random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0),
                                     random.Uniform(-1.0, 1.0));
    const auto clear = ClassifyPaint(100.0 * difference);
    const auto hazy = ClassifyPaint(50.0 * difference);
    ASSERT_EQ(clear.has_value(), hazy.has_value()) << difference.transpose();
    if (!clear) continue;
    ++named;
    EXPECT_EQ(clear->color, hazy->color);
    EXPECT_NEAR(clear->certainty, hazy->certainty, 1e-9);
    EXPECT_GE(clear->certainty, 0.0);
    EXPECT_LE(clear->certainty, 1.0);
  }
  EXPECT_GT(named, 50);
}

TEST(DetectionChances, FallWithTheRangeAndWithWhatTheBorderCuts) {
  const BoxModel model(BoxModel::Settings{});
  const CameraModel camera;
  double before = 1.0;
  for (double range = 2.0; range < 12.0; range += 0.25) {
    const double chance =
        model.DetectionProbability(*ImageOfSphere(camera, {0.0, 0.0, range}, 0.5));
    EXPECT_GE(chance, 0.0);
    EXPECT_LE(chance, before + 1e-9) << range;
    before = chance;
  }
  SphereImage image = *ImageOfSphere(camera, {0.0, 0.0, 4.0}, 0.5);
  before = 1.0;
  for (double share = 1.0; share > 0.0; share -= 0.05) {
    image.visible_fraction = share;
    const double chance = model.DetectionProbability(image);
    EXPECT_LE(chance, before + 1e-9) << share;
    before = chance;
  }
  EXPECT_LT(before, 0.2) << "what hardly shows is hardly found";
}

}  // namespace
}  // namespace limpet

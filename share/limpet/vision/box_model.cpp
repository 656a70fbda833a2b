// SPDX-License-Identifier: MIT
#include "limpet/vision/box_model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "limpet/core/logistic.hpp"

namespace limpet {
namespace {

/// What a paint is taken for when it is taken for another.
std::string_view MistakenFor(std::string_view color) {
  constexpr std::array<std::array<std::string_view, 2>, 6> kPairs{{{"yellow", "green"},
                                                                   {"orange", "red"},
                                                                   {"red", "orange"},
                                                                   {"green", "yellow"},
                                                                   {"white", "yellow"},
                                                                   {"blue", "white"}}};
  for (const auto& [color_of, other] : kPairs) {
    if (color_of == color) {
      return other;
    }
  }
  return color;
}

/// Takes from every image what nearer spheres hide of it, by their rectangles.
void HideBehindNearer(std::vector<SphereImage>& images) {
  for (SphereImage& image : images) {
    double hidden = 0.0;
    for (const SphereImage& other : images) {
      if (other.range < image.range) {
        hidden = std::max(hidden,
                          Intersection(image.visible, other.visible).area() / image.visible.area());
      }
    }
    image.visible_fraction *= 1.0 - hidden;
  }
}

}  // namespace

double BoxModel::DetectionProbability(const SphereImage& image) const {
  const BoxModelConstants& k = settings_.constants;
  const double x = image.range / settings_.visibility_m;
  if (std::sqrt(image.outline.width() * image.outline.height()) < 2.0 * k.least_radius_px) {
    return 0.0;
  }
  return k.peak * Logistic((k.faint_at - x) / k.faint_width) *
         Logistic((image.visible_fraction - k.cut_at) / k.cut_width);
}

Box BoxModel::Draw(const SphereImage& image, const std::string& color, Random& random) const {
  const BoxModelConstants& k = settings_.constants;
  const double x = image.range / settings_.visibility_m;
  const double cut = 1.0 - image.visible_fraction;
  const double growth = (1.0 + k.sd_growth_faint * x * x) * (1.0 + k.sd_growth_cut * cut);
  Box box;
  box.u = image.visible.center_u() + random.Normal(k.centre_sd_px * growth);
  box.v = image.visible.center_v() + random.Normal(k.centre_sd_px * growth);
  box.w =
      std::max(1.0, image.visible.width() + k.size_bias_px + random.Normal(k.size_sd_px * growth));
  box.h =
      std::max(1.0, image.visible.height() + k.size_bias_px + random.Normal(k.size_sd_px * growth));
  const double mean = k.confidence - k.confidence_loss_faint * x * x - k.confidence_loss_cut * cut;
  box.confidence = std::clamp(mean + random.Normal(k.confidence_sd), 0.3, 1.0);
  const double confusion = k.confusion_whole + (k.confusion_cut - k.confusion_whole) * cut * cut;
  box.color = random.Chance(confusion) ? std::string(MistakenFor(color)) : color;
  return box;
}

Box BoxModel::DrawFalse(Random& random) const {
  constexpr std::array<std::string_view, 3> kColors{"yellow", "orange", "green"};
  const double size = random.Uniform(18.0, 90.0);
  return {.u = random.Uniform(0.5 * size, settings_.camera.width_px - 0.5 * size),
          .v = random.Uniform(0.5 * size, settings_.camera.height_px - 0.5 * size),
          .w = size * random.Uniform(0.8, 1.25),
          .h = size,
          .confidence = random.Uniform(0.3, 0.7),
          .color = std::string(kColors.at(random.Index(kColors.size())))};
}

std::vector<Box> BoxModel::Detect(const Pose& X_WB, std::span<const Sphere> spheres,
                                  Random& random) const {
  std::vector<SphereImage> images;
  std::vector<const Sphere*> seen;
  for (const Sphere& sphere : spheres) {
    const Eigen::Vector3d p_C = settings_.camera.InCamera(X_WB, sphere.p_W);
    if (const auto image = ImageOfSphere(settings_.camera, p_C, sphere.radius)) {
      images.push_back(*image);
      seen.push_back(&sphere);
    }
  }
  HideBehindNearer(images);
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < images.size(); ++i) {
    if (random.Chance(DetectionProbability(images[i]))) {
      boxes.push_back(Draw(images[i], seen[i]->color, random));
    }
  }
  std::poisson_distribution<int> false_boxes(settings_.false_boxes_per_image);
  const int extra = settings_.false_boxes_per_image > 0.0 ? false_boxes(random.engine()) : 0;
  for (int i = 0; i < extra; ++i) {
    boxes.push_back(DrawFalse(random));
  }
  std::ranges::stable_sort(boxes, std::ranges::greater(), &Box::confidence);
  return boxes;
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/vision/scene_renderer.hpp"

#include <algorithm>
#include <cmath>

#include "limpet/core/random.hpp"
#include "limpet/core/require.hpp"
#include "limpet/core/smooth_step.hpp"
#include "limpet/core/split_mix.hpp"
#include "limpet/vision/seabed_ray.hpp"
#include "limpet/vision/sphere_painter.hpp"

namespace limpet {
namespace {

constexpr int kLinearLevels = 4096;
constexpr std::size_t kNoiseLength = 1U << 16U;
constexpr double kNoiseLevels = 2.2;  ///< 1-sigma of the sensor noise in 8-bit levels
constexpr double kVignetteAtCorner = 0.22;

/// The counter-based generator behind noise and specks.
std::uint64_t Hash(std::uint64_t counter) {
  return SplitMixed(counter * kGoldenStep + 0x632be59bd9b4e019ULL);
}

/// Smooth noise in -1 .. 1 of a place, one random value per unit cell.
float PatchNoise(double x, double y, std::uint64_t seed) {
  const double cell_x = std::floor(x);
  const double cell_y = std::floor(y);
  const auto corner = [cell_x, cell_y, seed](int i, int j) {
    const auto a = static_cast<std::uint64_t>(static_cast<std::int64_t>(cell_x) + i);
    const auto b = static_cast<std::uint64_t>(static_cast<std::int64_t>(cell_y) + j);
    return static_cast<float>(Hash(seed ^ (a * 0x8da6b343ULL) ^ (b * 0xd8163841ULL)) >> 40U) /
               8388608.0F -
           1.0F;
  };
  const float right = SmoothStep(static_cast<float>(x - cell_x));
  const float low = SmoothStep(static_cast<float>(y - cell_y));
  return std::lerp(std::lerp(corner(0, 0), corner(1, 0), right),
                   std::lerp(corner(0, 1), corner(1, 1), right), low);
}

/// 8-bit level of linear light, gamma 2.2, with room for the noise at both ends.
std::vector<std::uint8_t> ToneCurve() {
  std::vector<std::uint8_t> curve(kLinearLevels);
  for (int i = 0; i < kLinearLevels; ++i) {
    const double level = std::pow(static_cast<double>(i) / (kLinearLevels - 1), 1.0 / 2.2);
    curve[static_cast<std::size_t>(i)] =
        static_cast<std::uint8_t>(std::lround(9.0 + 236.0 * level));
  }
  return curve;
}

/// Draws within +-9 levels, so that adding one to the tone curve cannot overflow.
std::vector<std::int8_t> NoiseTable(std::uint64_t seed, std::size_t row_length) {
  Random random(seed, "camera noise");
  std::vector<std::int8_t> noise(kNoiseLength + row_length);
  for (std::int8_t& value : noise) {
    value = static_cast<std::int8_t>(std::clamp(std::lround(random.Normal(kNoiseLevels)), -9L, 9L));
  }
  return noise;
}

}  // namespace

/// The camera of one frame in the world.
struct SceneRenderer::View {
  Eigen::Matrix3d R_WC;
  Eigen::Vector3d p_W;  ///< camera [m]
  double origin_north;  ///< corner of a texture tile near the camera, so that floats stay fine [m]
  double origin_east;
};

SceneRenderer::SceneRenderer(const SceneSettings& settings)
    : settings_(settings),
      water_(WaterOptics::OfVisibility(settings.visibility_m)),
      texture_(settings.seabed_seed),
      relief_(settings.seabed_depth),
      corners_(settings.camera, kLayers),
      brightness_(corners_.columns() * kBlock),
      tone_curve_(ToneCurve()),
      noise_(
          NoiseTable(settings.noise_seed, 3 * static_cast<std::size_t>(settings.camera.width_px))) {
  LIMPET_REQUIRE(settings.seabed_depth != nullptr, "a scene needs a seabed");
}

float SceneRenderer::Vignette(const Eigen::Vector2d& at_px) const {
  const CameraModel& camera = settings_.camera;
  const double du = at_px.x() - camera.cx;
  const double dv = at_px.y() - camera.cy;
  const double corner2 = camera.cx * camera.cx + camera.cy * camera.cy;
  return static_cast<float>(1.0 - kVignetteAtCorner * (du * du + dv * dv) / corner2);
}

void SceneRenderer::FillNode(const View& view, int column, int row, double& distance) {
  const CameraModel& camera = settings_.camera;
  const double u = column * kBlock;
  const double v = row * kBlock;
  const Eigen::Vector3d ray =
      view.R_WC * Eigen::Vector3d((u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy, 1.0);
  constexpr double kFarthest = 60.0;
  const auto [p, ground] = SeabedRays(relief_, view.p_W, kFarthest).Meet(ray, distance);
  corners_.place(column, row) = Eigen::Vector2f(static_cast<float>(p.x() - view.p_W.x()),
                                                static_cast<float>(p.y() - view.p_W.y()));
  constexpr double kQ8PerMeter = 256.0 * SeabedTexture::kTexelsPerMeter;
  corners_.node(kAcross, column, row) =
      static_cast<float>((p.y() - view.origin_east) * kQ8PerMeter);
  corners_.node(kAlong, column, row) =
      static_cast<float>((p.x() - view.origin_north) * kQ8PerMeter);
  // Relief is lit from the south-west; patches of weed are darker and greener.
  const double relief = 1.0 + 0.8 * ground.slope_north + 0.5 * ground.slope_east;
  const float weed = 0.6F * PatchNoise(p.x() / 2.7, p.y() / 2.7, settings_.seabed_seed) +
                     0.4F * PatchNoise(p.x() / 0.9, p.y() / 0.9, settings_.seabed_seed + 1);
  constexpr std::array<float, 3> kWeed{0.16F, 0.09F, 0.15F};
  const double range = distance * ray.norm();
  const float vignette = Vignette({u, v});
  for (int c = 0; c < 3; ++c) {
    const auto i = static_cast<std::size_t>(c);
    const auto left_over = static_cast<float>(std::exp(-water_.attenuation_per_m[i] * range));
    const auto light = static_cast<float>(water_.illumination[i] * std::clamp(relief, 0.4, 1.6));
    corners_.node(kGain + c, column, row) = light * vignette * left_over * (1.0F + kWeed[i] * weed);
    corners_.node(kVeil + c, column, row) =
        4095.0F * static_cast<float>(water_.veil[i]) * vignette * (1.0F - left_over);
  }
}

void SceneRenderer::FillNodes(const View& view, std::span<const Sphere> spheres) {
  corners_.EachCorner(
      [&](int column, int row, double& distance) { FillNode(view, column, row, distance); });
  for (const Sphere& sphere : spheres) {
    DropShadow(view, sphere);
  }
}

void SceneRenderer::DropShadow(const View& view, const Sphere& sphere) {
  const Eigen::Vector2f center((sphere.p_W - view.p_W).head<2>().cast<float>());
  if (center.norm() > 30.0F) {
    return;  // farther than the camera can see a shadow
  }
  // Light from the whole sky: the higher the sphere, the wider and fainter its shadow.
  const double height =
      std::max(relief_.At(sphere.p_W.head<2>()).depth - sphere.p_W.z() - sphere.radius, 0.0);
  const double spread = sphere.radius + 0.5 * height;
  const auto darkness =
      static_cast<float>(0.55 * sphere.radius * sphere.radius / (spread * spread));
  const auto reach2 = static_cast<float>(spread * spread);
  corners_.Dim(kGain, center, [&](float distance2) {
    return distance2 < 5.0F * reach2 ? 1.0F - darkness * std::exp(-distance2 / reach2) : 1.0F;
  });
}

/// Reads the texture along a row.
void SceneRenderer::SampleSeabedRow(int row) {
  corners_.TakeRow(row);
  const float* across = corners_.at_row(kAcross);
  const float* along = corners_.at_row(kAlong);
  for (std::size_t block = 0; block + 1 < corners_.columns(); ++block) {
    // Four more bits for the steps inside the block.
    auto [u, v, step_u, step_v] = corners_.StepsIn(block, across, along, 16.0F);
    float* bright = &brightness_[block * kBlock];
    for (int i = 0; i < kBlock; ++i, u += step_u, v += step_v) {
      bright[i] = static_cast<float>(texture_.Sample(u >> 4, v >> 4));
    }
  }
}

void SceneRenderer::ShadeSeabedRow(LinearRow& linear) const {
  constexpr std::array<float, kBlock> kStep = CornerGrid::kShare;
  for (std::size_t c = 0; c < 3; ++c) {
    const float* gains = corners_.at_row(kGain + c);
    const float* veils = corners_.at_row(kVeil + c);
    const auto [tone, warmth] = SeabedTexture::kTone[c];
    for (std::size_t block = 0; block + 1 < corners_.columns(); ++block) {
      const float gain = gains[block];
      const float veil = veils[block];
      const float gain_step = gains[block + 1] - gain;
      const float veil_step = veils[block + 1] - veil;
      const float* bright = &brightness_[block * kBlock];
      float* light = &linear[c][block * kBlock];
      for (std::size_t i = 0; i < kBlock; ++i) {
        light[i] = (tone + warmth * bright[i]) * bright[i] * (gain + kStep[i] * gain_step) + veil +
                   kStep[i] * veil_step;
      }
    }
  }
}

void SceneRenderer::Develop(const LinearRow& linear, std::uint64_t counter,
                            std::uint8_t* bgr) const {
  const std::int8_t* noise =
      noise_.data() + Hash(settings_.noise_seed ^ Hash(counter)) % kNoiseLength;
  const auto width = static_cast<std::size_t>(settings_.camera.width_px);
  for (std::size_t column = 0; column < width; ++column) {
    for (std::size_t c = 0; c < 3; ++c) {
      const int light = std::min(static_cast<int>(linear[c][column]), kLinearLevels - 1);
      bgr[3 * column + c] = static_cast<std::uint8_t>(tone_curve_[static_cast<std::size_t>(light)] +
                                                      noise[3 * column + c]);
    }
  }
}

/// Drifting particles that shine in front of everything: two or three pixels each.
void SceneRenderer::AddSpecks(std::uint32_t frame, Image& image) const {
  const int count = static_cast<int>(160.0 / settings_.visibility_m);
  for (int speck = 0; speck < count; ++speck) {
    const std::uint64_t bits = Hash(settings_.noise_seed ^ Hash((std::uint64_t{frame} << 16U) +
                                                                static_cast<std::uint64_t>(speck)));
    const auto column =
        static_cast<std::size_t>((bits & 0xffffU) % static_cast<unsigned>(image.width_px - 1));
    const auto row = static_cast<std::size_t>(((bits >> 16U) & 0xffffU) %
                                              static_cast<unsigned>(image.height_px - 1));
    const auto glow = static_cast<int>(12 + ((bits >> 32U) & 31U));
    for (std::size_t dy = 0; dy < 2; ++dy) {
      for (std::size_t dx = 0; dx < 2; ++dx) {
        std::uint8_t* pixel =
            &image.bgr[3 * ((row + dy) * static_cast<std::size_t>(image.width_px) + column + dx)];
        for (int c = 0; c < 3; ++c) {
          pixel[c] = static_cast<std::uint8_t>(std::min(pixel[c] + glow, 255));
        }
      }
    }
  }
}

Image SceneRenderer::Render(const Pose& X_WB, std::span<const Sphere> spheres,
                            std::uint32_t frame) {
  const CameraModel& camera = settings_.camera;
  const Eigen::Matrix3d R_WB = RotationOf(X_WB);
  const Eigen::Vector3d p_W = X_WB.p_WB + R_WB * camera.p_BC;
  constexpr double kTile = SeabedTexture::kSize / SeabedTexture::kTexelsPerMeter;
  const View view{.R_WC = R_WB * camera.R_BC,
                  .p_W = p_W,
                  .origin_north = kTile * std::floor(p_W.x() / kTile),
                  .origin_east = kTile * std::floor(p_W.y() / kTile)};
  FillNodes(view, spheres);
  std::vector<SpherePainter> painters;
  for (const Sphere& sphere : spheres) {
    if (auto painter = SpherePainter::Make(camera, X_WB, sphere, water_, relief_)) {
      painters.push_back(*painter);
    }
  }
  std::ranges::stable_sort(painters, std::ranges::greater(), &SpherePainter::range);

  Image image{camera.width_px, camera.height_px, {}};
  const std::size_t row_bytes = 3 * static_cast<std::size_t>(camera.width_px);
  image.bgr.resize(row_bytes * static_cast<std::size_t>(camera.height_px));
  LinearRow linear;
  linear.fill(std::vector<float>(brightness_.size()));
  const double vignette_curve = kVignetteAtCorner / (camera.cx * camera.cx + camera.cy * camera.cy);
  for (int row = 0; row < camera.height_px; ++row) {
    SampleSeabedRow(row);
    ShadeSeabedRow(linear);
    for (SpherePainter& painter : painters) {
      if (row >= painter.first_row() && row < painter.last_row()) {
        painter.PaintRow(row, vignette_curve, linear);
      }
    }
    Develop(linear, (std::uint64_t{frame} << 16U) + static_cast<std::uint64_t>(row),
            &image.bgr[static_cast<std::size_t>(row) * row_bytes]);
  }
  AddSpecks(frame, image);
  return image;
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/imaging/ground_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "limpet/core/random.hpp"
#include "limpet/imaging/growth_form.hpp"
#include "limpet/vision/seabed_ray.hpp"
#include "limpet/vision/sphere_box.hpp"

namespace limpet {
namespace {

constexpr double kFarthest = 40.0;     // of a ray, in units of the optical axis [m]
constexpr double kSeenClutter = 12.0;  // from the camera [m]
constexpr double kTileSide = SeabedTile::kSize / SeabedTile::kTexelsPerMeter;
/// Units of SeabedTile's places per metre.
constexpr double kUnitsPerMeter = SeabedTile::kUnitsPerTexel * SeabedTile::kTexelsPerMeter;

}  // namespace

GroundView::GroundView(const CameraModel& camera, SeabedTile tile, std::uint64_t seed)
    : camera_(camera),
      tile_(std::move(tile)),
      patches_([seed] {
        Random random(seed, "seabed patches");
        return TileNoise(64, 110.0, random);
      }()),
      corners_(camera, kLayers),
      caustic_columns_((corners_.columns() - 1) * (kBlock / kCausticStep) + 1),
      caustic_rows_((corners_.rows() - 1) * (kBlock / kCausticStep) + 1),
      caustics_(caustic_columns_ * caustic_rows_),
      row_caustics_(caustic_columns_),
      texels_((corners_.columns() - 1) * kBlock) {}

void GroundView::LookAt(const SceneLight& light, SeabedRelief& relief, int column, int row,
                        double& range) {
  const double u = column * kBlock;
  const double v = row * kBlock;
  const Eigen::Vector3d ray = light.R_WC() * Eigen::Vector3d((u - camera_.cx) / camera_.fx,
                                                             (v - camera_.cy) / camera_.fy, 1.0);
  const auto [p, ground] = SeabedRays(relief, light.camera_W(), kFarthest).Meet(ray, range);
  const Eigen::Vector2d off(p.y() - origin_.x(), p.x() - origin_.y());
  corners_.place(column, row) = off.cast<float>();
  corners_.node(kAcross, column, row) = static_cast<float>(kUnitsPerMeter * off.x());
  corners_.node(kAlong, column, row) = static_cast<float>(kUnitsPerMeter * off.y());

  const double length = ray.norm();
  const SceneLight::Path path = light.Along(ray / length, range * length);
  const Eigen::Vector3d up =
      Eigen::Vector3d(ground.slope_north, ground.slope_east, -1.0).normalized();
  const SceneLight::Ground lit = light.OnGround(p, up);
  const float patch =
      1.0F + 0.22F * patches_.At(static_cast<float>(p.y()), static_cast<float>(p.x()));
  const auto vignette = static_cast<float>(light.VignetteOf({u, v}));
  constexpr float kUnpacked = 1.0F / (255.0F * 255.0F);  // texels are square roots in 1/255
  for (int c = 0; c < 3; ++c) {
    corners_.node(kGain + c, column, row) =
        kUnpacked * vignette * patch * lit.light(c) * path.direct(c);
    corners_.node(kVeil + c, column, row) = vignette * path.veil(c);
  }
  corners_.node(kSunShare, column, row) = lit.sun_share;
  mean_range_ += range * length;
  if (range * length < kSeenClutter) {
    area_.south = std::min(area_.south, p.x());
    area_.north = std::max(area_.north, p.x());
    area_.west = std::min(area_.west, p.y());
    area_.east = std::max(area_.east, p.y());
  }
}

void GroundView::Look(const SceneLight& light, SeabedRelief& relief) {
  const Eigen::Vector3d& camera = light.camera_W();
  // Relative to a tile's corner nearby, so that floats stay fine.
  origin_ = {kTileSide * std::floor(camera.y() / kTileSide),
             kTileSide * std::floor(camera.x() / kTileSide)};
  area_ = {camera.x(), camera.x(), camera.y(), camera.y()};
  mean_range_ = 0.0;
  corners_.EachCorner(
      [&](int column, int row, double& range) { LookAt(light, relief, column, row, range); });
  mean_range_ /= static_cast<double>(corners_.columns() * corners_.rows());
  FillCaustics(light);
}

void GroundView::FillCaustics(const SceneLight& light) {
  if (light.caustics().is_flat()) {
    std::ranges::fill(caustics_, 0.0F);
    return;
  }
  static_assert(kBlock == 2 * kCausticStep, "one sample between two corners");
  float* out = caustics_.data();
  for (int row = 0; row < static_cast<int>(caustic_rows_); ++row) {
    for (int column = 0; column < static_cast<int>(caustic_columns_); ++column) {
      const int right = (column + 1) / 2;
      const int low = (row + 1) / 2;
      const Eigen::Vector2f at =
          0.25F * (corners_.place(column / 2, row / 2) + corners_.place(right, row / 2) +
                   corners_.place(column / 2, low) + corners_.place(right, low));
      *out++ = light.caustics().LightAt({origin_.y() + at.y(), origin_.x() + at.x()}) - 1.0F;
    }
  }
}

void GroundView::DropShadow(const SceneLight& light, const Solid& solid,
                            const Eigen::Vector3d& towards_sun_W) {
  const double above = std::max(light.SeabedDepthAt(solid.p_W) - solid.p_W.z(), 0.0);
  const Eigen::Vector3d fallen = solid.p_W - towards_sun_W * (above / towards_sun_W.z());
  const Eigen::Vector2f middle(static_cast<float>(fallen.y() - origin_.x()),
                               static_cast<float>(fallen.x() - origin_.y()));
  // The sky fills the shadow of what floats high; water scatters the sun's edge.
  const double radius = solid.ReachAlong(Eigen::Vector3d::UnitX());
  const double spread = radius + 0.25 * std::max(above - radius, 0.0);
  const auto darkness = static_cast<float>(0.6 * radius * radius / (spread * spread));
  const auto reach2 = static_cast<float>(spread * spread);
  corners_.Dim(kGain, middle, [&](float distance2) {
    const float far2 = distance2 / reach2;
    return far2 > 4.0F ? 1.0F : 1.0F - darkness * std::exp(-far2 * far2);
  });
}

void GroundView::SampleRow() {
  const float* across = corners_.at_row(kAcross);
  const float* along = corners_.at_row(kAlong);
  for (std::size_t block = 0; block + 1 < corners_.columns(); ++block) {
    auto [u, v, step_u, step_v] = corners_.StepsIn(block, across, along);
    std::uint32_t* out = &texels_[block * kBlock];
    const int longest = std::max(std::abs(step_u), std::abs(step_v));
    if (longest <= SeabedTile::kUnitsPerTexel * 3 / 4) {  // nearer than the tile is fine
      for (int i = 0; i < kBlock; ++i, u += step_u, v += step_v)
        out[i] = tile_.Between(u, v);
      continue;
    }
    // The level whose texels are about as large as the pixels.
    int level = 0;
    while (level + 1 < SeabedTile::kLevels &&
           longest > (SeabedTile::kUnitsPerTexel * 3 / 2 << level)) {
      ++level;
    }
    const SeabedTile::Level texels = tile_.level(level);
    for (int i = 0; i < kBlock; ++i, u += step_u, v += step_v)
      out[i] = texels.At(u, v);
  }
}

void GroundView::PaintSpot(const Spot& spot, const Eigen::Vector3f& sun) {
  const Growth& growth = *spot.growth;
  const float* across = corners_.at_row(kAcross);
  const float* along = corners_.at_row(kAlong);
  constexpr auto kMeters = static_cast<float>(1.0 / kUnitsPerMeter);
  const auto east_of = static_cast<float>(growth.east - origin_.x());
  const auto north_of = static_cast<float>(growth.north - origin_.y());
  const auto scale = static_cast<float>(1.0 / growth.radius);
  for (int column = spot.left; column < spot.right; ++column) {
    const auto block = static_cast<std::size_t>(column / kBlock);
    const float t = (static_cast<float>(column % kBlock) + 0.5F) / kBlock;
    const float east =
        kMeters * (across[block] + t * (across[block + 1] - across[block])) - east_of;
    const float north = kMeters * (along[block] + t * (along[block + 1] - along[block])) - north_of;
    if (east * east + north * north > 2.25F / (scale * scale)) continue;
    const GrowthSample sample = GrowthAt(growth, scale * east, scale * north, sun);
    if (sample.cover <= 0.01F) continue;
    std::uint32_t& texel = texels_[static_cast<std::size_t>(column)];
    std::uint32_t blended = 0;
    for (unsigned c = 0; c < 3; ++c) {
      const auto root = static_cast<float>((texel >> (8U * c)) & 255U);
      const float before = root * root;
      const float after = 65025.0F * std::min(sample.albedo(c), 1.0F);
      const float mixed = before + sample.cover * (after - before);
      blended |= static_cast<std::uint32_t>(std::sqrt(std::max(mixed, 0.0F))) << (8U * c);
    }
    texel = blended;
  }
}

void GroundView::InterpolateCaustics(int row) {
  const auto upper = static_cast<std::size_t>(row / kCausticStep);
  const float low = (static_cast<float>(row % kCausticStep) + 0.5F) / kCausticStep;
  const float* above = &caustics_[upper * caustic_columns_];
  const float* below = above + caustic_columns_;
  const float* share = corners_.at_row(kSunShare);
  for (std::size_t i = 0; i < caustic_columns_; ++i) {
    row_caustics_[i] = 1.0F + share[i / 2] * (above[i] + low * (below[i] - above[i]));
  }
}

void GroundView::ShadeRow(int row, LinearImage& image) const {
  constexpr std::array<float, kBlock> kShare = CornerGrid::kShare;
  constexpr std::array<float, kCausticStep> kFine{0.125F, 0.375F, 0.625F, 0.875F};
  for (std::size_t block = 0; block + 1 < corners_.columns(); ++block) {
    std::array<float, kBlock> waves;
    const float* caustic = &row_caustics_[2 * block];
    for (std::size_t i = 0; i < kCausticStep; ++i) {
      waves[i] = caustic[0] + kFine[i] * (caustic[1] - caustic[0]);
      waves[i + kCausticStep] = caustic[1] + kFine[i] * (caustic[2] - caustic[1]);
    }
    const std::uint32_t* texels = &texels_[block * kBlock];
    for (std::size_t c = 0; c < 3; ++c) {
      const float* gains = corners_.at_row(kGain + c) + block;
      const float* veils = corners_.at_row(kVeil + c) + block;
      const float gain = gains[0], gain_step = gains[1] - gain;
      const float veil = veils[0], veil_step = veils[1] - veil;
      float* out = image.row(c, row) + block * kBlock;
      for (std::size_t i = 0; i < kBlock; ++i) {
        const auto root =
            static_cast<float>(static_cast<std::int32_t>((texels[i] >> (8U * c)) & 255U));
        out[i] =
            root * root * waves[i] * (gain + kShare[i] * gain_step) + veil + kShare[i] * veil_step;
      }
    }
  }
}

void GroundView::Paint(const CameraModel& camera, const Pose& X_WB, SeabedRelief& relief,
                       std::span<const Growth> growth, const Eigen::Vector3d& towards_sun_W,
                       LinearImage& image) {
  spots_.clear();
  for (const Growth& one : growth) {
    const Eigen::Vector3d p_W(one.north, one.east, relief.At({one.north, one.east}).depth);
    const auto seen = ImageOfSphere(camera, camera.InCamera(X_WB, p_W), 1.5 * one.radius);
    if (!seen) continue;
    const auto inside = [](double px, int size) {
      return std::clamp(static_cast<int>(px), 0, size);
    };
    spots_.push_back({&one, inside(seen->outline.left, camera.width_px),
                      inside(seen->outline.right + 1.0, camera.width_px),
                      inside(seen->outline.top, camera.height_px),
                      inside(seen->outline.bottom + 1.0, camera.height_px)});
  }
  const Eigen::Vector3f sun(static_cast<float>(towards_sun_W.y()),
                            static_cast<float>(towards_sun_W.x()),
                            static_cast<float>(-towards_sun_W.z()));
  for (int row = 0; row < camera.height_px; ++row) {
    corners_.TakeRow(row);
    SampleRow();
    for (const Spot& spot : spots_) {
      if (row >= spot.top && row < spot.bottom) PaintSpot(spot, sun);
    }
    InterpolateCaustics(row);
    ShadeRow(row, image);
  }
}

}  // namespace limpet

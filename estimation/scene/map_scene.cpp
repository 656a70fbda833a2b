// SPDX-License-Identifier: MIT
#include "estimation/scene/map_scene.hpp"

#include <cstddef>
#include <cstdint>

#include <fmt/format.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/opengl/CEllipsoid3D.h>
#include <mrpt/opengl/COctoMapVoxels.h>
#include <mrpt/opengl/COpenGLScene.h>
#include <mrpt/opengl/CSetOfLines.h>
#include <mrpt/opengl/CSetOfObjects.h>
#include <mrpt/opengl/CText.h>
#include <mrpt/opengl/stock_objects.h>
#include <mrpt/serialization/CArchive.h>

#include "estimation/mapping/map_export.hpp"
#include "estimation/mapping/status_label.hpp"

namespace limpet {
namespace {

using mrpt::img::TColor;

constexpr std::size_t kLabels = 6;    // of VoxelLabel
constexpr float kSigmas = 3.0F;       // of an object's ellipsoid
constexpr double kLeastSigma = 1e-3;  // [m] MRPT draws no ellipsoid without an extent

/// East, north, up of north, east, down; its own inverse.
Eigen::Vector3d Up(const Eigen::Vector3d& p_W) { return {p_W.y(), p_W.x(), -p_W.z()}; }

TColor ColorOfLabel(VoxelLabel label, std::uint8_t opacity = 255) {
  const VoxelColor color = ColorOf({.label = label});
  return {color.red, color.green, color.blue, opacity};
}

mrpt::opengl::CRenderizable::Ptr Seabed(const SemanticOctree& octree) {
  auto seabed = mrpt::opengl::COctoMapVoxels::Create();
  seabed->setName("seabed");
  seabed->enableLights(true);
  seabed->resizeVoxelSets(kLabels);
  Eigen::Vector3d low = Eigen::Vector3d::Zero(), high = Eigen::Vector3d::Zero();
  for (const Voxel& leaf : octree.Leaves()) {
    if (leaf.belief.occupied <= 0.0F) continue;
    const Eigen::Vector3d p = Up(leaf.p_W);
    const mrpt::math::TPoint3Df at(static_cast<float>(p.x()), static_cast<float>(p.y()),
                                   static_cast<float>(p.z()));
    const auto set = static_cast<std::size_t>(leaf.belief.label);
    seabed->push_back_Voxel(set, {at, leaf.size, ColorOfLabel(leaf.belief.label)});
    low = low.cwiseMin(p), high = high.cwiseMax(p);
  }
  for (std::size_t set = 0; set < kLabels; ++set)
    seabed->showVoxels(static_cast<unsigned>(set), true);
  seabed->setBoundingBox({low.x(), low.y(), low.z()}, {high.x(), high.y(), high.z()});
  return seabed;
}

void AddObject(const OpiBelief& opi, mrpt::opengl::CSetOfObjects& objects) {
  const Eigen::Vector3d p = Up(opi.object.p_W);
  Eigen::Matrix3d to_up = Eigen::Matrix3d::Zero();
  to_up(0, 1) = to_up(1, 0) = 1.0, to_up(2, 2) = -1.0;
  const Eigen::Matrix3d cov = to_up * opi.object.cov_W * to_up.transpose() +
                              Eigen::Matrix3d::Identity() * (kLeastSigma * kLeastSigma);
  mrpt::math::CMatrixDouble33 covariance;
  for (int i = 0; i < 9; ++i)
    covariance(i / 3, i % 3) = cov(i / 3, i % 3);

  auto ellipsoid = mrpt::opengl::CEllipsoid3D::Create();
  ellipsoid->setName(fmt::format("object {}", opi.id));
  ellipsoid->setCovMatrix(covariance);
  ellipsoid->setQuantiles(kSigmas);
  ellipsoid->enableDrawSolid3D(true);
  ellipsoid->setColor_u8(ColorOfLabel(LabelOf(opi.decided), 140));
  ellipsoid->setLocation(p.x(), p.y(), p.z());
  objects.insert(ellipsoid);

  auto text = mrpt::opengl::CText::Create(
      fmt::format("{} {} {}", opi.id, opi.object.color, NameOf(opi.decided)));
  text->setColor_u8(TColor(20, 20, 20));
  text->setLocation(p.x(), p.y(), p.z() + 1.5);
  objects.insert(text);
}

mrpt::opengl::CRenderizable::Ptr Path(const std::vector<Eigen::Vector3d>& path_W) {
  auto path = mrpt::opengl::CSetOfLines::Create();
  path->setName("path");
  path->setColor_u8(TColor(0, 0, 0));
  path->setLineWidth(2.0F);
  for (std::size_t i = 1; i < path_W.size(); ++i) {
    const Eigen::Vector3d a = Up(path_W[i - 1]), b = Up(path_W[i]);
    path->appendLine(a.x(), a.y(), a.z(), b.x(), b.y(), b.z());
  }
  return path;
}

}  // namespace

std::string ToScene(const SemanticOctree& octree, const std::vector<OpiBelief>& objects,
                    const std::vector<Eigen::Vector3d>& path_W) {
  mrpt::opengl::COpenGLScene scene;
  scene.getViewport()->setCustomBackgroundColor({0.85F, 0.9F, 0.95F});
  scene.insert(Seabed(octree));
  auto all = mrpt::opengl::CSetOfObjects::Create();
  all->setName("objects");
  for (const OpiBelief& opi : objects)
    if (opi.decided != Status::kNothing) AddObject(opi, *all);
  scene.insert(all);
  if (path_W.size() > 1) scene.insert(Path(path_W));
  auto origin = mrpt::opengl::stock_objects::CornerXYZSimple(1.0F);
  origin->setName("origin");
  scene.insert(origin);

  mrpt::io::CMemoryStream memory;
  auto archive = mrpt::serialization::archiveFrom(memory);
  archive << scene;
  return {static_cast<const char*>(memory.getRawBufferData()), memory.getTotalBytesCount()};
}

}  // namespace limpet

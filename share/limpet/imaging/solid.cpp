// SPDX-License-Identifier: MIT
#include "limpet/imaging/solid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace limpet {
namespace {

constexpr std::array<std::pair<std::string_view, SolidKind>, 5> kSolidKinds{
    {{"sphere", SolidKind::kSphere},
     {"cylinder", SolidKind::kCylinder},
     {"cone", SolidKind::kCone},
     {"box", SolidKind::kBox},
     {"tyre", SolidKind::kTyre}}};

/// Radius of a tyre's tube, which fills its width [m].
double TubeRadius(const Solid& tyre) { return std::min(0.5 * tyre.height, 0.5 * tyre.radius); }

}  // namespace

std::optional<SolidKind> SolidKindOf(std::string_view name) {
  for (const auto& [word, kind] : kSolidKinds) {
    if (word == name) return kind;
  }
  return std::nullopt;
}

std::vector<std::string> SolidKindNames() {
  std::vector<std::string> names;
  for (const auto& [word, kind] : kSolidKinds)
    names.emplace_back(word);
  return names;
}

double Solid::DistanceTo(const Eigen::Vector3d& p_S) const {
  const double across = p_S.head<2>().norm();
  const double past_end = std::abs(p_S.z()) - 0.5 * height;
  switch (kind) {
    case SolidKind::kSphere:
      return p_S.norm() - radius;
    case SolidKind::kCylinder:
      return std::max(across - radius, past_end);
    case SolidKind::kCone: {
      // The foot is down: z = +height / 2.
      const double slope = radius * (1.0 - top_share) / height;
      const double wall = across - radius - slope * (p_S.z() - 0.5 * height);
      return std::max(wall / std::sqrt(1.0 + slope * slope), past_end);
    }
    case SolidKind::kBox:
      return std::max({std::abs(p_S.x()) - radius, std::abs(p_S.y()) - radius, past_end});
    case SolidKind::kTyre: {
      const double tube = TubeRadius(*this);
      const double ring = across - (radius - tube);
      return std::sqrt(ring * ring + p_S.z() * p_S.z()) - tube;
    }
  }
  return 0.0;
}

Eigen::Vector3d Solid::NormalAt(const Eigen::Vector3d& p_S) const {
  const Eigen::Vector3d outwards =
      Eigen::Vector3d(p_S.x(), p_S.y(), 0.0) / std::max(p_S.head<2>().norm(), 1e-12);
  Eigen::Vector3d end(0.0, 0.0, std::copysign(1.0, p_S.z()));
  const bool is_end = DistanceTo(p_S) <= std::abs(p_S.z()) - 0.5 * height;
  switch (kind) {
    case SolidKind::kSphere:
      return p_S.normalized();
    case SolidKind::kCylinder:
      return is_end ? end : outwards;
    case SolidKind::kCone: {
      const double slope = radius * (1.0 - top_share) / height;
      return is_end ? end : (outwards - slope * Eigen::Vector3d::UnitZ()).normalized();
    }
    case SolidKind::kBox:
      if (is_end) return end;
      return std::abs(p_S.x()) > std::abs(p_S.y())
                 ? Eigen::Vector3d(std::copysign(1.0, p_S.x()), 0.0, 0.0)
                 : Eigen::Vector3d(0.0, std::copysign(1.0, p_S.y()), 0.0);
    case SolidKind::kTyre:
      return (p_S - (radius - TubeRadius(*this)) * outwards).normalized();
  }
  return end;
}

double Solid::ReachAlong(const Eigen::Vector3d& n_S) const {
  const double across = n_S.head<2>().norm();
  const double along = 0.5 * height * std::abs(n_S.z());
  switch (kind) {
    case SolidKind::kSphere:
      return radius * n_S.norm();
    case SolidKind::kCylinder:
      return radius * across + along;
    case SolidKind::kCone:
      return std::max(radius * across + 0.5 * height * n_S.z(),
                      top_share * radius * across - 0.5 * height * n_S.z());
    case SolidKind::kBox:
      return radius * (std::abs(n_S.x()) + std::abs(n_S.y())) + along;
    case SolidKind::kTyre:
      return (radius - TubeRadius(*this)) * across + TubeRadius(*this) * n_S.norm();
  }
  return 0.0;
}

double Solid::BoundingRadius() const {
  switch (kind) {
    case SolidKind::kSphere:
    case SolidKind::kTyre:
      return radius;
    case SolidKind::kBox:
      return std::sqrt(2.0 * radius * radius + 0.25 * height * height);
    case SolidKind::kCylinder:
    case SolidKind::kCone:
      break;
  }
  return std::hypot(radius, 0.5 * height);
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "estimation/association/triangulation.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "estimation/smoothing/factors/range_factor.hpp"
#include "estimation/smoothing/factors/reprojection_factor.hpp"
#include "estimation/smoothing/factors/seabed_factor.hpp"

namespace limpet {
namespace {

constexpr double kUsualDistance = 3.0;  // [m] when nothing tells
constexpr double kLeastDepth = 0.8;     // [m]
constexpr int kIterations = 6;

}  // namespace

void TrackedObject::RecountColor() {
  votes_.clear();
  for (const Look& look : looks) {
    votes_[look.color] += look.confidence;
  }
  const auto most = std::ranges::max_element(
      votes_, {}, [](const std::pair<const std::string, double>& vote) { return vote.second; });
  color_ = most == votes_.end() ? "" : most->first;
}

void TrackedObject::AddLook(Look look) {
  const double votes = votes_[look.color] += look.confidence;
  const auto leading = votes_.find(color_);
  if (leading == votes_.end() || votes > leading->second) color_ = look.color;
  looks.push_back(std::move(look));
}

double TrackedObject::LogOdds() const {
  double sum = 0.0;
  for (const Look& look : looks) {
    const double c = std::clamp(look.confidence, 0.05, 0.95);
    sum += std::log(c / (1.0 - c));
  }
  return sum;
}

Eigen::Vector3d PlaceAlongRay(const Look& look, const NavVector& x, const CameraModel& camera,
                              const ObjectModel& model) {
  const Pose X_WB = PoseOf(x);
  const Eigen::Matrix3d R_WC = RotationOf(X_WB) * camera.R_BC;
  const Eigen::Vector3d p_WC = X_WB.p_WB + RotationOf(X_WB) * camera.p_BC;
  Eigen::Vector3d ray = RayOfPixel(look.reading.centre_px, camera);
  ray /= ray.z();
  double depth = kUsualDistance;
  const Eigen::Vector3d ray_W = R_WC * ray;
  if (const auto range = look.reading.Range(model.radius_m)) {
    depth = *range / (0.5 * (std::hypot(ray.x(), 1.0) + std::hypot(ray.y(), 1.0)));
  } else if (look.altitude && ray_W.z() > 0.3) {
    const double down = X_WB.p_WB.z() + *look.altitude - model.height_m - p_WC.z();
    depth = down / ray_W.z();
  }
  return p_WC + std::clamp(depth, kLeastDepth, 30.0) * ray_W;
}

std::vector<Term> TermsOfLook(const Look& look, int slot, const CameraModel& camera,
                              const ObjectModel& model, bool with_seabed) {
  std::vector<Term> terms;
  const Loss loss = Loss::Huber(model.huber);
  const BoxReading& reading = look.reading;
  if (!reading.is_usable()) {
    return terms;
  }
  terms.push_back(
      Term::OnSight(ReprojectionFactor(camera, reading.centre_px, reading.sigma_px), slot, loss));
  if (const auto range = reading.Range(model.radius_m)) {
    const double sigma = model.noise.range_floor_m + model.noise.range_share * *range;
    terms.push_back(Term::OnSight(RangeFactor(camera, Meters(*range), Meters(sigma)), slot, loss));
  }
  if (reading.lone_edge && model.radius_m > 0.0) {
    terms.push_back(
        Term::OnSight(EdgeFactor(camera, Meters(model.radius_m), *reading.lone_edge), slot, loss));
  }
  if (with_seabed && look.altitude) {
    terms.push_back(Term::OnSight(
        SeabedFactor(Meters(*look.altitude), Meters(model.height_m), Meters(model.height_sigma_m)),
        slot, loss));
  }
  return terms;
}

Triangulation Triangulate(const std::vector<Look>& looks,
                          const std::function<NavVector(int)>& pose_of, const CameraModel& camera,
                          const ObjectModel& model) {
  struct Bound {
    NavVector x;
    Term term;
  };
  std::vector<Bound> bound;
  const Look* start = &looks.front();
  for (const Look& look : looks) {
    const NavVector x = pose_of(look.node);
    for (const Term& term : TermsOfLook(look, 0, camera, model, &look == &looks.front())) {
      bound.push_back({x, term});
    }
    if (look.reading.is_whole() && !start->reading.is_whole()) {
      start = &look;
    }
  }
  Triangulation result{.p = PlaceAlongRay(*start, pose_of(start->node), camera, model)};
  // Ties the point to the first guess within metres: looks from one place leave a direction open.
  const Eigen::Vector3d guess = result.p;
  constexpr double kGuessInformation = 1.0 / (2.0 * 2.0);
  LinearTerm linear;
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    Eigen::Matrix3d H = kGuessInformation * Eigen::Matrix3d::Identity();
    Eigen::Vector3d g = kGuessInformation * (guess - result.p);
    result.worst_residual = 0.0;
    for (const Bound& b : bound) {
      b.term.Linearize({nullptr, &b.x, &result.p}, linear);
      const auto J = linear.J_landmark.topRows(linear.rows);
      H += J.transpose() * J;
      g -= J.transpose() * linear.r.head(linear.rows);
      result.worst_residual = std::max(result.worst_residual, std::sqrt(2.0 * linear.cost));
    }
    const Eigen::LLT<Eigen::Matrix3d> llt(H);
    result.p += llt.solve(g);
    result.covariance = llt.solve(Eigen::Matrix3d::Identity());
  }
  return result;
}

}  // namespace limpet

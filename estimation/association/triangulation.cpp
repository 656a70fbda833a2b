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

/// A first guess from one observation.
Eigen::Vector3d PlaceAlongRay(const Observation& observation, const NavVector& x,
                              const CameraModel& camera, const ObjectModel& model) {
  const Pose X_WB = PoseOf(x);
  const Eigen::Matrix3d R_WC = RotationOf(X_WB) * camera.R_BC;
  const Eigen::Vector3d p_WC = X_WB.p_WB + RotationOf(X_WB) * camera.p_BC;
  Eigen::Vector3d ray =
      camera.RayOf(observation.reading.centre_px.x(), observation.reading.centre_px.y());
  ray /= ray.z();
  double depth = kUsualDistance;
  const Eigen::Vector3d ray_W = R_WC * ray;
  if (const auto range = observation.reading.Range(model.radius_m)) {
    depth = *range / (0.5 * (std::hypot(ray.x(), 1.0) + std::hypot(ray.y(), 1.0)));
  } else if (observation.altitude && ray_W.z() > 0.3) {
    const double down = X_WB.p_WB.z() + *observation.altitude - model.height_m - p_WC.z();
    depth = down / ray_W.z();
  }
  return p_WC + std::clamp(depth, kLeastDepth, 30.0) * ray_W;
}

}  // namespace

std::vector<Term> TermsOf(const Observation& observation, int slot, const CameraModel& camera,
                          const ObjectModel& model, bool with_seabed) {
  std::vector<Term> terms;
  const Loss loss = Loss::Huber(model.huber);
  const BoxReading& reading = observation.reading;
  if (!reading.is_usable()) {
    return terms;
  }
  terms.push_back(Term::OnObservation(
      ReprojectionFactor(camera, reading.centre_px, reading.sigma_px), slot, loss));
  if (const auto range = reading.Range(model.radius_m)) {
    const double sigma = model.noise.range_floor_m + model.noise.range_share * *range;
    terms.push_back(
        Term::OnObservation(RangeFactor(camera, Meters(*range), Meters(sigma)), slot, loss));
  }
  if (reading.lone_edge && model.radius_m > 0.0) {
    terms.push_back(Term::OnObservation(
        EdgeFactor(camera, Meters(model.radius_m), *reading.lone_edge), slot, loss));
  }
  if (with_seabed && observation.altitude) {
    terms.push_back(
        Term::OnObservation(SeabedFactor(Meters(*observation.altitude), Meters(model.height_m),
                                         Meters(model.height_sigma_m)),
                            slot, loss));
  }
  return terms;
}

Triangulation Triangulate(const std::vector<Observation>& observations,
                          const std::function<NavVector(int)>& pose_of, const CameraModel& camera,
                          const ObjectModel& model) {
  struct Bound {
    NavVector x;
    Term term;
  };
  std::vector<Bound> bound;
  const Observation* start = &observations.front();
  for (const Observation& observation : observations) {
    const NavVector x = pose_of(observation.node);
    for (const Term& term :
         TermsOf(observation, 0, camera, model, &observation == &observations.front())) {
      bound.push_back({x, term});
    }
    if (observation.reading.is_whole() && !start->reading.is_whole()) {
      start = &observation;
    }
  }
  Triangulation result{.p_W = PlaceAlongRay(*start, pose_of(start->node), camera, model)};
  // Ties the point to the first guess within metres: observations from one place leave a direction
  // open.
  const Eigen::Vector3d guess = result.p_W;
  constexpr double kGuessInformation = 1.0 / (2.0 * 2.0);
  LinearTerm linear;
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    Eigen::Matrix3d H = kGuessInformation * Eigen::Matrix3d::Identity();
    Eigen::Vector3d g = kGuessInformation * (guess - result.p_W);
    result.worst_residual = 0.0;
    for (const Bound& b : bound) {
      b.term.Linearize({.pose = &b.x, .border = {&result.p_W}}, linear);
      const auto J = linear.J_border[0].topRows(linear.rows);
      H += J.transpose() * J;
      g -= J.transpose() * linear.r.head(linear.rows);
      result.worst_residual = std::max(result.worst_residual, std::sqrt(2.0 * linear.cost));
    }
    const Eigen::LLT<Eigen::Matrix3d> llt(H);
    result.p_W += llt.solve(g);
    result.covariance = llt.solve(Eigen::Matrix3d::Identity());
  }
  return result;
}

}  // namespace limpet

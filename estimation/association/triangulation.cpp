// SPDX-License-Identifier: MIT
#include "estimation/association/triangulation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>

#include "estimation/smoothing/factors/camera_errors_factor.hpp"
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

/// `bind` makes a term of a factor of the camera, for which the object is `slot`.
template <class Bind>
std::vector<Term> CollectTerms(const Observation& observation, int slot, const CameraModel& camera,
                               const ObjectModel& model, bool with_seabed, const Bind& bind) {
  std::vector<Term> terms;
  const Loss loss = Loss::Huber(model.huber);
  const BoxReading& reading = observation.reading;
  if (!reading.is_usable()) {
    return terms;
  }
  terms.push_back(bind(ReprojectionFactor(camera, reading.centre_px, reading.sigma_px), loss));
  if (const auto range = reading.Range(model.radius_m)) {
    const double sigma = model.noise.range_floor_m + model.noise.range_share * *range;
    terms.push_back(bind(RangeFactor(camera, Meters(*range), Meters(sigma)), loss));
  }
  if (reading.lone_edge && model.radius_m > 0.0) {
    terms.push_back(bind(EdgeFactor(camera, Meters(model.radius_m), *reading.lone_edge), loss));
  }
  if (with_seabed && observation.altitude) {
    terms.push_back(
        Term::OnObservation(SeabedFactor(Meters(*observation.altitude), Meters(model.height_m),
                                         Meters(model.height_sigma_m)),
                            slot, loss));
  }
  return terms;
}

}  // namespace

std::vector<Term> TermsOf(const Observation& observation, int slot, const CameraMount& mount,
                          const ObjectModel& model, bool with_seabed) {
  const CameraModel& camera = mount.camera();
  if (!mount.slots()) {
    return CollectTerms(observation, slot, camera, model, with_seabed,
                        [slot](auto factor, Loss loss) {
                          return Term::OnObservation(std::move(factor), slot, loss);
                        });
  }
  const std::array slots{slot, (*mount.slots())[0], (*mount.slots())[1]};
  return CollectTerms(observation, slot, camera, model, with_seabed, [&](auto factor, Loss loss) {
    return Term::OnObservation(CameraErrorsFactor(camera, observation.motion, std::move(factor)),
                               slots, loss);
  });
}

Triangulation Triangulate(const std::vector<Observation>& observations,
                          const std::function<NavVector(int)>& pose_of, const CameraMount& mount,
                          const ObjectModel& model) {
  struct Bound {
    NavVector x;
    Term term;
  };
  std::vector<Bound> bound;
  std::vector<CameraModel> cameras;  // as each exposure saw it; the factors refer to them
  cameras.reserve(observations.size());
  const Observation* start = &observations.front();
  for (const Observation& observation : observations) {
    const NavVector x = pose_of(observation.node);
    cameras.push_back(mount.At(observation.motion));
    for (Term& term :
         CollectTerms(observation, 0, cameras.back(), model, &observation == &observations.front(),
                      [](auto factor, Loss loss) {
                        return Term::OnObservation(std::move(factor), 0, loss);
                      })) {
      bound.push_back({x, std::move(term)});
    }
    if (observation.reading.is_whole() && !start->reading.is_whole()) {
      start = &observation;
    }
  }
  Triangulation result{
      .p_W = PlaceAlongRay(*start, pose_of(start->node), mount.At(start->motion), model)};
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

// SPDX-License-Identifier: MIT
#include "estimation/association/triangulation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>

#include "estimation/association/usual_distance.hpp"
#include "estimation/smoothing/factors/camera_errors_factor.hpp"
#include "estimation/smoothing/factors/object_size_factor.hpp"
#include "estimation/smoothing/factors/range_factor.hpp"
#include "estimation/smoothing/factors/reprojection_factor.hpp"
#include "estimation/smoothing/factors/seabed_factor.hpp"
#include "estimation/smoothing/jacobians.hpp"

namespace limpet {
namespace {

constexpr double kLeastDepth = 0.8;  // [m]
constexpr int kIterations = 6;
constexpr double kKnownSize = 1e-4;  // 1-sigma of the logarithm of a size that is not in doubt
// A size far from what is believed is likelier than a Gaussian has it: mapped objects have the
// tails of Huber's loss, tentative ones a wider spread.
constexpr double kTentativeSpread = 1.5;
constexpr double kMostLogSize = 2.0;  // seven times as large or small

/// Pixel to look for a sphere's centre at: that of the box, where an edge shows in its stead half
/// the usual size from that.
Eigen::Vector2d CentreGuess(const BoxReading& reading, const CameraModel& camera, double radius) {
  Eigen::Vector2d centre = reading.centre_px;
  for (const std::optional<CutAxisFactor::Measurement>& cut : reading.cut_axes) {
    if (!cut || !cut->box.is_half_cut()) continue;
    const double half = (cut->axis == 0 ? camera.fx : camera.fy) * radius / kUsualDistance;
    centre(cut->axis) = cut->box.CentreOf(half);
  }
  return centre;
}

/// A first guess from one observation.
Eigen::Vector3d PlaceAlongRay(const Observation& observation, const NavVector& x,
                              const CameraModel& camera, const ObjectModel& model) {
  const Pose X_WB = PoseOf(x);
  const Eigen::Matrix3d R_WC = RotationOf(X_WB) * camera.R_BC;
  const Eigen::Vector3d p_WC = X_WB.p_WB + RotationOf(X_WB) * camera.p_BC;
  const BoxReading& reading = observation.reading;
  const bool is_in_corner = reading.is_cut_u && reading.is_cut_v;
  const Eigen::Vector2d centre_px =
      is_in_corner ? CentreGuess(reading, camera, model.radius_m) : reading.centre_px;
  Eigen::Vector3d ray = camera.RayOf(centre_px);
  ray /= ray.z();
  double depth = kUsualDistance;
  const Eigen::Vector3d ray_W = R_WC * ray;
  if (const auto range = reading.Range(model.radius_m)) {
    depth = *range / reading.size_planes_C.dot(
                         Eigen::Vector2d(std::hypot(ray.x(), 1.0), std::hypot(ray.y(), 1.0)));
  } else if (observation.altitude && ray_W.z() > 0.3) {
    const double down = X_WB.p_WB.z() + *observation.altitude - model.height_m - p_WC.z();
    depth = down / ray_W.z();
  }
  return p_WC + std::clamp(depth, kLeastDepth, 30.0) * ray_W;
}

/// `bind` makes a term of a factor of the camera; the object's place is the border variable `slot`.
template <class Bind>
std::vector<Term> CollectTerms(const Observation& observation, int slot, const CameraModel& camera,
                               const ObjectModel& model, bool with_seabed, const Bind& bind) {
  std::vector<Term> terms;
  const Loss loss = Loss::Huber(model.huber);
  const BoxReading& reading = observation.reading;
  if (std::isfinite(reading.sigma_px.minCoeff()))
    terms.push_back(bind(ReprojectionFactor(camera, reading.centre_px, reading.sigma_px), loss));
  if (const auto range = reading.Range(model.radius_m)) {
    const double sigma = model.noise.range_floor_m + model.noise.range_share * *range;
    terms.push_back(
        bind(RangeFactor(camera, Meters(*range), Meters(sigma), reading.size_planes_C), loss));
  }
  for (const std::optional<CutAxisFactor::Measurement>& cut : reading.cut_axes) {
    if (cut && model.radius_m > 0.0)
      terms.push_back(bind(CutAxisFactor(camera, Meters(model.radius_m), *cut), loss));
  }
  if (with_seabed && observation.altitude && reading.TellsPlace(model.radius_m)) {
    terms.push_back(
        Term::OnObservation(SeabedFactor(Meters(*observation.altitude), Meters(model.height_m),
                                         Meters(model.height_sigma_m)),
                            slot, loss));
  }
  return terms;
}

/// A look from a known pose at the border variables 0, the object's place, and 1, whose first
/// number is its size.
template <class F>
class LookFromKnownPose {
 public:
  static constexpr int kDim = F::kDim;
  using Residual = typename F::Residual;
  using Jacobian = typename F::Jacobian;
  using BorderJacobian = typename F::BorderJacobian;
  /// Derivatives by the pose, and by the object's place and size.
  using Jacobians = ObservationJacobians<kDim, 2>;

  LookFromKnownPose(const CameraModel& camera, F factor)
      : camera_(&camera), factor_(std::move(factor)) {}

  [[nodiscard]] Residual Evaluate(const NavVector& x, const Eigen::Vector3d& p_W,
                                  const Eigen::Vector3d& log_size, Jacobians* J) const {
    const CameraPoint point = CameraPointOf(*camera_, x, p_W);
    BorderJacobian J_C;
    J->border[1].setZero();
    Residual r = InCamera(point.p_C, log_size.x(), J_C, J->border[1]);
    J->pose = J_C * point.J_pose;
    J->border[0] = J_C * point.J_landmark;
    return r;
  }

 private:
  Residual InCamera(const Eigen::Vector3d& p_C, double log_size, BorderJacobian& J_C,
                    BorderJacobian& J_size) const {
    if constexpr (TakesSize<F>) {
      Residual by_size;
      Residual r = factor_.InCamera(p_C, log_size, J_C, by_size);
      J_size.col(0) = by_size;
      return r;
    } else {
      return factor_.InCamera(p_C, J_C);
    }
  }
  const CameraModel* camera_;
  F factor_;
};

/// A term of a look, from where the vehicle was.
struct BoundTerm {
  NavVector x;
  Term term;
};

/// Normal equations for an object's place [m] and the logarithm of its size.
struct NormalEquations {
  Eigen::Matrix4d H;
  Eigen::Vector4d g;

  /// What the terms say at a guess; returns the worst of their whitened residuals.
  double Add(const std::vector<BoundTerm>& terms, const Eigen::Vector3d& p_W, double log_size) {
    LinearTerm linear;
    double worst = 0.0;
    const Eigen::Vector3d size(log_size, 0.0, 0.0);
    for (const BoundTerm& b : terms) {
      b.term.Linearize({.pose = &b.x, .border = {&p_W, &size}}, linear);
      Eigen::Matrix<double, 6, 4> J = Eigen::Matrix<double, 6, 4>::Zero();
      J.topLeftCorner(linear.rows, 3) = linear.J_border[0].topRows(linear.rows);
      if (b.term.DependsOn(1))
        J.col(3).head(linear.rows) = linear.J_border[1].col(0).head(linear.rows);
      H += J.transpose() * J;
      g -= J.topRows(linear.rows).transpose() * linear.r.head(linear.rows);
      worst = std::max(worst, std::sqrt(2.0 * linear.cost));
    }
    return worst;
  }
};

}  // namespace

std::vector<Term> TermsOf(const Observation& observation, const LookSlots& slots,
                          const CameraModel& camera, const ObjectModel& model, bool with_seabed) {
  const auto bind = [&]<class F>(F factor, Loss loss) {
    if (!slots.mount) return Term::OnObservation(std::move(factor), slots.landmark, loss);
    const int tilt = (*slots.mount)[0], shift = (*slots.mount)[1];
    if constexpr (TakesSize<F>) {
      if (slots.size) {
        return Term::OnObservation(ObjectSizeFactor(camera, observation.motion, std::move(factor),
                                                    slots.size->index, slots.size->believed),
                                   std::array{slots.landmark, tilt, shift, slots.size->slot}, loss);
      }
    }
    return Term::OnObservation(CameraErrorsFactor(camera, observation.motion, std::move(factor)),
                               std::array{slots.landmark, tilt, shift}, loss);
  };
  return CollectTerms(observation, slots.landmark, camera, model, with_seabed, bind);
}

Triangulation Triangulate(const std::vector<Observation>& observations,
                          const std::function<NavVector(int)>& pose_of, const CameraMount& mount,
                          const ObjectModel& model) {
  std::vector<BoundTerm> bound;
  std::vector<CameraModel> cameras;  // as each exposure saw it; the factors refer to them
  cameras.reserve(observations.size());
  const Observation* start = &observations.front();
  for (const Observation& observation : observations) {
    const NavVector x = pose_of(observation.node);
    cameras.push_back(mount.At(observation.motion));
    for (Term& term : CollectTerms(
             observation, 0, cameras.back(), model, &observation == &observations.front(),
             [&cameras](auto factor, Loss loss) {
               return Term::OnObservation(LookFromKnownPose(cameras.back(), std::move(factor)),
                                          std::array{0, 1}, loss);
             })) {
      bound.push_back({x, std::move(term)});
    }
    const BoxReading &one = observation.reading, &first = start->reading;
    const bool tells_more =
        (one.is_whole() && !first.is_whole()) || (one.tells_size() && !first.tells_size());
    if (tells_more) {
      start = &observation;
    }
  }
  Triangulation result{
      .p_W = PlaceAlongRay(*start, pose_of(start->node), mount.At(start->motion), model)};
  // Ties the point to the first guess within metres: observations from one place leave a direction
  // open.
  const Eigen::Vector3d guess = result.p_W;
  constexpr double kGuessInformation = 1.0 / (2.0 * 2.0);
  const double expected_size = model.LogSizeOf(observations.front().color);
  result.log_size = expected_size;
  const double spread = std::max(kTentativeSpread * model.size_spread, kKnownSize);
  const double size_information = 1.0 / (spread * spread);
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    NormalEquations normal;
    normal.H =
        Eigen::Vector4d(kGuessInformation, kGuessInformation, kGuessInformation, size_information)
            .asDiagonal();
    normal.g << kGuessInformation * (guess - result.p_W),
        size_information * (expected_size - result.log_size);
    result.worst_residual = normal.Add(bound, result.p_W, result.log_size);
    const Eigen::LLT<Eigen::Matrix4d> llt(normal.H);
    const Eigen::Vector4d step = llt.solve(normal.g);
    result.p_W += step.head<3>();
    result.log_size = std::clamp(result.log_size + step(3), -kMostLogSize, kMostLogSize);
    result.covariance_W = llt.solve(Eigen::Matrix4d::Identity()).topLeftCorner<3, 3>();
  }
  return result;
}

}  // namespace limpet

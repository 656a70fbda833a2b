// SPDX-License-Identifier: MIT
#include "estimation/association/object_motion.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "estimation/association/usual_distance.hpp"
#include "estimation/association/visibility.hpp"

namespace limpet {
namespace {

constexpr std::size_t kLeastLooks = 8;
constexpr double kLeastSpan = 3.0;     // [s] of looks that can show a motion
constexpr double kLeastMotion = 0.12;  // [m] of both axes together: what a mount or clock may leave
constexpr double kClear = 3.0;         // variance of all of it as a share of the noise's

/// Where a look has the object in the plane of its height, off its place [m].
struct PlaneLook {
  double t = 0.0;
  Eigen::Vector2d off_W = Eigen::Vector2d::Zero();
  double noise = 0.0;  ///< variance of both axes together [m^2]
};

PlaneLook PlaneLookOf(const Observation& one, const Eigen::Vector3d& p_W, const Smoother& smoother,
                      const CameraMount& mount) {
  const CameraModel camera = mount.At(one.motion);
  const Pose X_WB = PoseOf(smoother.PoseAt(one.node));
  const Eigen::Matrix3d R_WB = RotationOf(X_WB);
  const Eigen::Vector3d p_WC = X_WB.p_WB + R_WB * camera.p_BC;
  const Eigen::Vector3d ray_W = R_WB * camera.R_BC * camera.RayOf(one.reading.centre_px);
  const Eigen::Vector3d seen_W = (p_W.z() - p_WC.z()) / ray_W.z() * ray_W;
  const double range = seen_W.norm();
  const Eigen::Vector2d sigma(one.reading.sigma_px.x() / camera.fx,
                              one.reading.sigma_px.y() / camera.fy);
  return {.t = one.t,
          .off_W = (p_WC + seen_W - p_W).head<2>(),
          .noise = range * range * sigma.squaredNorm()};
}

std::vector<PlaneLook> LastPass(const TrackedObject& object, double pause, const Smoother& smoother,
                                const CameraMount& mount) {
  std::vector<PlaneLook> looks;
  double later = object.last_seen();
  for (auto one = object.observations.rbegin(); one != object.observations.rend(); ++one) {
    if (later - one->t > pause) break;
    later = one->t;
    if (one->reading.is_whole() && !one->terms.empty())
      looks.push_back(PlaneLookOf(*one, object.p_W, smoother, mount));
  }
  return looks;
}

}  // namespace

double MotionVariance(const TrackedObject& object, double pause, const Smoother& smoother,
                      const CameraMount& mount) {
  if (object.observations.size() < kLeastLooks) return 0.0;
  const std::vector<PlaneLook> looks = LastPass(object, pause, smoother, mount);
  if (looks.size() < kLeastLooks || looks.front().t - looks.back().t < kLeastSpan) return 0.0;
  const auto n = static_cast<double>(looks.size());
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  double noise = 0.0, all = 0.0, steps = 0.0;
  for (const PlaneLook& look : looks)
    mean += look.off_W / n, noise += look.noise / n;
  for (std::size_t i = 0; i < looks.size(); ++i) {
    all += (looks[i].off_W - mean).squaredNorm() / (n - 1.0);
    if (i > 0) steps += (looks[i].off_W - looks[i - 1].off_W).squaredNorm() / (2.0 * (n - 1.0));
  }
  // Of white noise the differences have as much as the looks themselves [von Neumann 1941].
  const double white = std::max(steps, noise), slow = all - white;
  const bool moves = slow > kLeastMotion * kLeastMotion && all > kClear * white;
  return moves ? 0.5 * slow : 0.0;
}

int CountAbsences(const TrackedObject& seen, const TrackedObject& absent, const Smoother& smoother,
                  const CameraMount& mount) {
  const auto shows = [&absent](int frame) {
    return std::ranges::find(absent.observations, frame, &Observation::frame) !=
           absent.observations.end();
  };
  return static_cast<int>(std::ranges::count_if(seen.observations, [&](const Observation& one) {
    return !shows(one.frame) &&
           ShouldBeSeen(absent, smoother.PoseAt(one.node), mount.At(one.motion));
  }));
}

BoxReading OfMeanPlace(const BoxReading& reading, double motion_sd, const CameraModel& camera,
                       double radius) {
  if (!(motion_sd > 0.0)) return reading;
  BoxReading of_mean = reading;
  const double range = reading.Range(radius).value_or(kUsualDistance);
  const Eigen::Vector2d moved_px = motion_sd / range * Eigen::Vector2d(camera.fx, camera.fy);
  of_mean.sigma_px = (reading.sigma_px.array().square() + moved_px.array().square()).sqrt();
  of_mean.cut_axes = {};
  return of_mean;
}

}  // namespace limpet

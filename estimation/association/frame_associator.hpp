// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "estimation/association/track_list.hpp"
#include "estimation/association/tracker_params.hpp"
#include "estimation/smoothing/smoother.hpp"

namespace limpet {

/// Where a frame was taken from, and how the vehicle moved then.
struct Viewpoint {
  NavVector x = NavVector::Zero();
  std::optional<int> node{};  ///< of the chain, newest; nothing when the frame has no usable box
  double path = 0.0;          ///< way travelled [m]
  std::optional<double> altitude{};  ///< of the body origin above the seabed [m]
  BodyMotion motion{};
};

/// A box that is used, and its index in the frame.
struct Candidate {
  int detection = 0;
  ReadDetection seen;
};

/// What a box shows.
struct Association {
  enum class Kind {
    kTrack,      ///< one of the tracks
    kNothing,    ///< none of them
    kAmbiguous,  ///< it may be either of several: left out rather than guessed
  };
  Kind kind = Kind::kNothing;
  std::size_t track = 0;  ///< index, of kTrack
};

/// Assigns the boxes of a frame to tracks: gates on the predicted box with the joint covariance of
/// pose and place, then the one-to-one assignment of the greatest likelihood against being
/// something new. All must outlive it.
class FrameAssociator {
 public:
  FrameAssociator(const Smoother& smoother, const CameraMount& mount,
                  const ObjectTrackerParams& params, const TrackList& tracks)
      : smoother_(smoother), mount_(mount), params_(params), tracks_(tracks) {}

  /// What each candidate is associated with; the smoother must be up to date with the frame's node.
  [[nodiscard]] std::vector<Association> Assign(const Viewpoint& from,
                                                const std::vector<Candidate>& candidates) const;

  /// [m] beyond the greatest distance that a track was seen from: no error of the newest pose
  /// brings one further off into view.
  [[nodiscard]] double Reach() const;

 private:
  /// Tracks that no error of the pose could bring into view are left out.
  struct Reachable {
    std::vector<bool> is_reachable;  ///< per track
    Eigen::MatrixXd joint;           ///< of the pose, those that are mapped, the camera's errors
  };
  [[nodiscard]] Reachable CollectReachable(const NavVector& x) const;
  /// In the camera's frame: what its errors add to where the object is expected [m^2]. `row`: of
  /// the object in the joint covariance; nothing if it is not mapped.
  [[nodiscard]] Eigen::Matrix3d MountCovariance(const Viewpoint& from, const Eigen::Vector3d& p_W,
                                                const Eigen::MatrixXd& joint,
                                                std::optional<int> row) const;
  [[nodiscard]] PoseObjectCovariance CovarianceWith(const TrackedObject& object, double path,
                                                    const Eigen::MatrixXd& joint, int row) const;
  /// -2 ln of the likelihood ratio against being something new, per candidate and track.
  [[nodiscard]] Eigen::MatrixXd Costs(const Viewpoint& from,
                                      const std::vector<Candidate>& candidates) const;
  [[nodiscard]] bool IsSeenAgain(const TrackedObject& object) const {
    return tracks_.now - object.last_seen() > params_.confirm_within_s;
  }

  const Smoother& smoother_;
  const CameraMount& mount_;
  const ObjectTrackerParams& params_;
  const TrackList& tracks_;
};

}  // namespace limpet

// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "limpet/objects/former_identity.hpp"
#include "limpet/objects/status_posterior.hpp"

namespace limpet {

/// Size of an object that is taken for a sphere.
struct ObjectSize {
  double radius = 0.0;  ///< [m]
  double sd = 0.0;      ///< [m]
};

/// Where an object is believed to be, and what it is. W is the north-east-down frame of the session
/// that says so.
struct ObjectEstimate {
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();    ///< of its centre [m]
  Eigen::Matrix3d cov_W = Eigen::Matrix3d::Zero();  ///< [m^2]
  std::string color;                                ///< class, as Box::color
  std::optional<ObjectSize> size = std::nullopt;    ///< nothing where it is not estimated
  /// Standard deviation along each axis [m].
  [[nodiscard]] Eigen::Vector3d sd_W() const { return cov_W.diagonal().cwiseMax(0.0).cwiseSqrt(); }
  [[nodiscard]] bool is_size_known() const { return size && size->radius > 0.0; }
  /// Radius of this object [m]; `usual` where nobody has estimated it.
  [[nodiscard]] double RadiusOr(double usual) const {
    return is_size_known() ? size->radius : usual;
  }
};

/// An object as the smoother knows it: enough detections and parallax have made it one.
struct Landmark {
  int id = 0;
  ObjectEstimate object;
  int detections = 0;  ///< associated with it: boxes, several of one look
  FormerIdentity former = {};
};

/// An object of potential interest, as map and smoother together know it.
struct OpiBelief {
  int id = 0;                      ///< unique in the session and lasting
  std::optional<int> landmark{};   ///< NAV_LANDMARKS id; nothing if only the former session knew it
  std::optional<int> former_id{};  ///< id in SESSION_PRIOR, if the former session knew it
  ObjectEstimate object;  ///< the smoother's, else the former session's in this session's frame
  /// Lambda of this session: ln P(looks | present) / P(looks | absent).
  double log_likelihood_ratio = 0.0;
  int looks = 0;           ///< independent looks of this session, with or without a detection
  int looks_with_box = 0;  ///< of them; MAP_OPIS does not carry it
  StatusPosterior posterior;
  Status decided = Status::kUncertain;  ///< in a discovery session new or uncertain
  /// Chance of what is decided to have moved: that it is the former object `former_id`, which stood
  /// elsewhere, and that that place is empty now.
  std::optional<double> moved_probability = std::nullopt;
  Eigen::Vector3d centroid_W = Eigen::Vector3d::Zero();     ///< of the map's OPI voxels [m]
  Eigen::Vector3d centroid_sd_W = Eigen::Vector3d::Zero();  ///< their spread [m]
};

}  // namespace limpet

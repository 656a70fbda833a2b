// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "estimation/association/box_reading.hpp"
#include "estimation/smoothing/chain_graph.hpp"

namespace limpet {

/// One box that was taken to show an object.
struct Look {
  int frame = 0;
  int detection = 0;  ///< index of the box in its frame
  int node = 0;       ///< pose of the chain at the exposure
  double t = 0.0;
  BoxReading reading;
  std::string color;
  double confidence = 0.0;
  std::optional<double> altitude;  ///< of the body origin above the seabed then [m]
  std::vector<TermId> terms;       ///< of the graph, once the object is a landmark
};

/// Something that boxes hint at: tentative until enough of them agree, then a landmark.
struct TrackedObject {
  int id = -1;    ///< given with the landmark, from 1 on, never used again
  int slot = -1;  ///< in the smoother; -1 while tentative
  std::vector<Look> looks;
  Eigen::Vector3d p = Eigen::Vector3d::Zero();               ///< NED [m], as of the last solution
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();  ///< tentative: relative to its poses
  double worst_residual = 0.0;                               ///< tentative: whitened, of its looks
  double last_path = 0.0;                                    ///< way travelled when last seen [m]
  double far = 0.0;            ///< greatest distance it was seen at [m]
  int expected = 0;            ///< frames that should have shown it
  int hits = 0;                ///< of these, how many did
  int prior_id = -1;           ///< object of the former session it was matched with
  bool is_in_doubt = false;    ///< a landmark of the smoother that may be another one seen again
  double spread = 0.0;         ///< 1-sigma of its distance to landmarks when it came in doubt [m]
  bool is_open = false;        ///< what it is may still change
  int same_as = -1;            ///< id of the landmark that it is tied to; -1: none
  bool is_likely_new = false;  ///< in doubt: likelier none of the landmarks known before
  double certainty = 0.0;      ///< share of the likelihood of what it is taken for
  double decided_t = 0.0;      ///< when it was tied [s]
  bool is_fresh = true;        ///< seen since the last review
  /// Where it was when all its looks were last reviewed; nothing before that.
  std::optional<Eigen::Vector3d> reviewed_p;

  /// True if the smoother estimates its place.
  [[nodiscard]] bool is_mapped() const { return slot >= 0; }
  /// True if it is mapped in its own right, be it in doubt.
  [[nodiscard]] bool is_known() const { return is_mapped() && same_as < 0; }
  /// True if it is an object of its own: what others are told of.
  [[nodiscard]] bool is_landmark() const { return is_known() && !is_in_doubt; }
  [[nodiscard]] double last_seen() const { return looks.back().t; }
  /// The class most boxes gave it; the first in the alphabet if equal.
  [[nodiscard]] const std::string& Color() const { return color_; }
  /// To be called when looks went or came in numbers; AddLook counts its own.
  void RecountColor();
  void AddLook(Look look);
  /// Sum of confidences per class.
  [[nodiscard]] const std::map<std::string, double>& votes() const { return votes_; }
  /// Sum of ln(c / (1 - c)) over the confidences of its looks.
  [[nodiscard]] double LogOdds() const;

 private:
  std::map<std::string, double> votes_;
  std::string color_;
};

}  // namespace limpet

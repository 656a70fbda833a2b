// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "estimation/association/box_reading.hpp"
#include "estimation/association/object_sizes.hpp"
#include "estimation/smoothing/camera_errors.hpp"
#include "estimation/smoothing/chain_graph.hpp"
#include "limpet/objects/object_estimate.hpp"

namespace limpet {

/// One box that was taken to show an object.
struct Observation {
  int frame = 0;
  int detection = 0;  ///< index of the box in its frame
  int node = 0;       ///< pose of the chain at the exposure
  double t = 0.0;
  BoxReading reading;
  std::string color;
  double confidence = 0.0;
  BodyMotion motion{};             ///< of the vehicle then
  std::optional<double> altitude;  ///< of the body origin above the seabed then [m]
  std::vector<TermId> terms;       ///< of the graph, once the object is in it
};

/// A track that is not in the smoother: too few boxes agree on it yet.
struct Tentative {
  Eigen::Matrix3d covariance_W = Eigen::Matrix3d::Identity();  ///< relative to its poses [m^2]
  double worst_residual = 0.0;                                 ///< whitened, of its observations
};
/// In the smoother, and may be a landmark that is known, seen again.
struct InDoubt {};
/// An object of its own: what others are told of.
struct Confirmed {
  bool is_on_probation = false;  ///< that it is one may still be taken back
};
/// In the smoother and held at the place of an older track, which it is taken for: the tie may be
/// taken back.
struct Tied {
  int to = 0;          ///< id
  double since = 0.0;  ///< [s]
};
/// Merged into another track or given up; to be erased.
struct Gone {};
using TrackState = std::variant<Tentative, InDoubt, Confirmed, Tied, Gone>;

/// What the last joint decision on identities said of a track.
struct IdentityVerdict {
  double share = 0.0;          ///< of the likelihood, of what it is taken for
  bool is_likely_new = false;  ///< likelier none of the landmarks known before
};

/// Something that boxes hint at: tentative until enough of them agree, then in the smoother.
class TrackedObject {
 public:
  std::vector<Observation> observations;          ///< in order of time
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();  ///< [m], as of the last solution
  double log_size = 0.0;  ///< natural logarithm of its share of the believed radius, as of then
  TrackState state = Tentative{};
  double last_path = 0.0;     ///< way travelled when last seen [m]
  double max_distance = 0.0;  ///< from the camera that it was seen at [m]
  int expected = 0;           ///< frames that should have shown it
  int hits = 0;               ///< of these, how many did
  double motion_sd = 0.0;  ///< that it moves about its place, north and east [m]; 0: stands still
  FormerIdentity former;
  double drift_sd = 0.0;  ///< of its distance to landmarks when it came in doubt [m]
  IdentityVerdict verdict;
  /// What its own motion adds to the covariance of where it is found [m^2].
  [[nodiscard]] Eigen::Matrix3d MotionCovariance() const {
    // One pass takes a motion along its way for height.
    const Eigen::Vector3d sd(motion_sd, motion_sd, 2.0 * motion_sd);
    return sd.cwiseAbs2().asDiagonal();
  }
  bool needs_review = true;  ///< seen since the last review
  /// Where it was when all its observations were last reviewed; nothing before that.
  std::optional<Eigen::Vector3d> reviewed_p_W;

  /// Puts it into the smoother at `slot`, and its size at `size` if that is estimated, under an id
  /// from 1 on that is never used again.
  void Map(int id, int slot, const TrackState& as, std::optional<SizeSlot> size = std::nullopt);
  /// REQUIRES: is_mapped(), now or before it was gone.
  [[nodiscard]] int id() const { return mapped_->id; }
  /// Its variable in the smoother. REQUIRES: is_mapped().
  [[nodiscard]] int slot() const { return mapped_->slot; }
  /// The smoother's variable of its size, if that is estimated. REQUIRES: is_mapped().
  [[nodiscard]] const std::optional<SizeSlot>& size() const { return mapped_->size; }

  template <class State>
  [[nodiscard]] bool Is() const {
    return std::holds_alternative<State>(state);
  }
  /// True if the smoother estimates its place.
  [[nodiscard]] bool is_mapped() const { return !Is<Tentative>() && !Is<Gone>(); }
  /// True if it is mapped in its own right, be it in doubt.
  [[nodiscard]] bool is_untied() const { return Is<InDoubt>() || Is<Confirmed>(); }
  [[nodiscard]] bool is_landmark() const { return Is<Confirmed>(); }
  /// True if what it is may still change.
  [[nodiscard]] bool is_open() const;
  [[nodiscard]] bool IsTiedTo(int id) const {
    const auto* tied = std::get_if<Tied>(&state);
    return tied != nullptr && tied->to == id;
  }
  /// Id of the track that it is taken for.
  [[nodiscard]] std::optional<int> tied_to() const;
  /// REQUIRES: it is tentative.
  [[nodiscard]] const Tentative& tentative() const { return std::get<Tentative>(state); }

  [[nodiscard]] double last_seen() const { return observations.back().t; }
  /// The class most boxes gave it; the first in the alphabet if equal.
  [[nodiscard]] const std::string& Color() const { return color_; }
  /// To be called when observations went or came in numbers; Add counts its own.
  void RecountColor();
  void Add(Observation observation);
  /// Sum of confidences per class.
  [[nodiscard]] const std::map<std::string, double>& votes() const { return votes_; }
  /// Sum of ln(c / (1 - c)) over the confidences of its observations.
  [[nodiscard]] double LogOdds() const;

 private:
  struct Mapped {
    int id, slot;
    std::optional<SizeSlot> size;
  };
  std::optional<Mapped> mapped_;
  std::map<std::string, double> votes_;
  std::string color_;
};

}  // namespace limpet

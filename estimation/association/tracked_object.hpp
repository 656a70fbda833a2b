// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <variant>

#include <Eigen/Core>

#include "estimation/association/object_sizes.hpp"
#include "estimation/association/observation_list.hpp"
#include "limpet/objects/object_estimate.hpp"

namespace limpet {

/// A track that is not in the smoother: too few boxes agree on it yet.
struct Tentative {
  Eigen::Matrix3d covariance_W = Eigen::Matrix3d::Identity();  ///< relative to its poses [m^2]
  double worst_residual = 0.0;                                 ///< whitened, of its observations
};
/// A track in the smoother that may be a known landmark, seen again.
struct InDoubt {};
/// An object of its own: what others are told of.
struct Confirmed {
  bool is_on_probation = false;  ///< that it is one may still be taken back
};
/// A track in the smoother that is held at the place of an older track, which it is taken for: the
/// tie may be taken back.
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

/// How often a camera that looked its way saw a track, and how it did last.
struct Sightings {
  int expected = 0;           ///< frames that should have shown it
  int hits = 0;               ///< of these, how many did
  double max_distance = 0.0;  ///< from the camera that it was seen at [m]
  double last_path = 0.0;     ///< way travelled when last seen [m]

  /// `count` frames showed it, and no other should have.
  void CountAgain(std::size_t count) { expected = hits = static_cast<int>(count); }
  /// Takes over what was seen of another track that is the same object.
  void Absorb(const Sightings& other) {
    expected += other.expected;
    hits += other.hits;
    max_distance = std::max(max_distance, other.max_distance);
  }
};

/// When the observations of a track are to be held against its place again.
struct ReviewState {
  bool is_due = true;  ///< seen since the last review
  /// Where the object was when all its observations were last reviewed [m]; nothing before that.
  std::optional<Eigen::Vector3d> p_W;
};

/// Something that boxes hint at: tentative until enough of them agree, then in the smoother.
class TrackedObject {
 public:
  ObservationList observations;
  TrackState state = Tentative{};
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();  ///< [m], as of the last solution
  double log_size = 0.0;   ///< natural logarithm of its share of the believed radius, as of then
  double motion_sd = 0.0;  ///< that it moves about its place, north and east [m]; 0: stands still
  Sightings sightings;
  ReviewState review;
  FormerIdentity former;
  double drift_sd = 0.0;  ///< of its distance to landmarks when it came in doubt [m]
  IdentityVerdict verdict;

  /// What its own motion adds to the covariance of where it is found [m^2].
  [[nodiscard]] Eigen::Matrix3d MotionCovariance() const {
    // One pass takes a motion along its way for height.
    const Eigen::Vector3d sd(motion_sd, motion_sd, 2.0 * motion_sd);
    return sd.cwiseAbs2().asDiagonal();
  }

  /// Puts it into the smoother at `slot`, and its size at `size` if that is estimated, under an id
  /// from 1 on that is never used again.
  void Map(int id, int slot, const TrackState& as, std::optional<SizeSlot> size = std::nullopt);
  /// REQUIRES: is_mapped(), now or before it was gone.
  [[nodiscard]] int id() const { return mapped_->id; }
  /// The track's variable in the smoother. REQUIRES: is_mapped().
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

  /// REQUIRES: it has observations.
  [[nodiscard]] double last_seen() const { return observations.back().t; }
  /// The class that its boxes vote for.
  [[nodiscard]] const std::string& color() const { return observations.color(); }

 private:
  struct Mapped {
    int id, slot;
    std::optional<SizeSlot> size;
  };
  std::optional<Mapped> mapped_;
};

}  // namespace limpet

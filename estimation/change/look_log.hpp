// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "estimation/change/place_evidence.hpp"
#include "limpet/core/params.hpp"
#include "limpet/core/units.hpp"
#include "limpet/survey/look.hpp"
#include "limpet/survey/visibility_belief.hpp"

namespace limpet {

/// When frames count as one look and looks as one pass, and how often a whole pass goes wrong, or
/// all of one session.
struct LookParams {
  /// True if an object seen from `p_OC`, the camera from it [m], is another look than from
  /// `former_p_OC`.
  [[nodiscard]] bool IsNewLook(const Eigen::Vector3d& p_OC,
                               const Eigen::Vector3d& former_p_OC) const {
    return (p_OC - former_p_OC).norm() >= new_look_distance.value() ||
           p_OC.normalized().dot(former_p_OC.normalized()) <= std::cos(new_look_angle.value());
  }
  /// True if ground is seen in another look by a vehicle that has gone and turned so far.
  [[nodiscard]] bool IsNewLook(Meters gone, Radians turned) const {
    return gone >= new_look_distance || turned >= new_look_angle;
  }

  Meters new_look_distance{0.5};
  Radians new_look_angle = Radians::FromTextUnit(15.0);
  Seconds new_pass_gap{8.0};
  double pass_failure = 0.02;     ///< chance that a pass misses an object that it passed over
  double place_failure = 0.005;   ///< chance that all passes of one session do: it is overgrown
  double failing_detects = 0.05;  ///< share of the detection rate left in a failing pass
  double clutter_detects = 0.7;   ///< chance per frame of a box on lasting clutter

  template <class V>
  void Describe(V& visit) {
    using namespace literals;
    visit("new_look_distance_m", new_look_distance,
          "Frames from closer viewpoints than this are one look", InRange(0.05_m, 10.0_m));
    visit("new_look_angle_deg", new_look_angle,
          "Frames from directions closer than this are one look", InRange(1.0_deg, 90.0_deg));
    visit("new_pass_gap_s", new_pass_gap, "Out of sight longer than this starts a new pass",
          InRange(1.0_s, 600.0_s));
    visit("pass_failure", pass_failure,
          "Chance that a whole pass misses an object it should have seen", InRange(1e-5, 0.5));
    visit("place_failure", place_failure,
          "Chance that a whole session misses an object it should have seen", InRange(1e-5, 0.5));
    visit("failing_detects", failing_detects, "Share of the detection rate left in a failing pass",
          InRange(0.0, 0.9));
    visit("clutter_detects", clutter_detects, "Chance per frame of a box on lasting clutter",
          InRange(0.01, 0.99));
  }
};

/// What one frame said about one place that it could have seen.
struct FrameEvidence {
  double time = 0.0;                               ///< [s]
  Eigen::Vector3d p_OC = Eigen::Vector3d::Zero();  ///< camera relative to the place, NED [m]
  PerVisibility detects = 0.0;                     ///< chance of a box here if an object is there
  double false_alarm = 0.0;                        ///< chance of a box here if none is
  bool has_box = false;
};

/// Collects what the frames of one session said about one place, as looks (frames from nearly one
/// viewpoint count together as one witness) and passes (looks of one pass share what made them
/// fail), for each visibility that the water may have. What lasts is drawn once for all passes: a
/// stone that looks like a buoy does not become one by being seen again, and an overgrown buoy that
/// no pass saw is not gone for that.
class LookLog {
 public:
  explicit LookLog(const LookParams& params) : params_(params) {}

  /// REQUIRES: frames come in order of time; detects and false_alarm in (0, 1).
  void Add(const FrameEvidence& frame);
  /// ln P(seen) over all passes, the one under way included.
  struct Likelihoods {
    PerVisibility present, bare, lookalike;
  };
  [[nodiscard]] Likelihoods likelihoods() const;
  [[nodiscard]] PlaceEvidence evidence() const;
  /// Looks as `survey/look.hpp` has them, or that did show a box.
  [[nodiscard]] PerVisibility looks() const;
  [[nodiscard]] int looks_with_box() const;
  [[nodiscard]] int passes() const { return passes_; }

 private:
  /// ln P of what was seen of an object, of one in a pass that fails, of bare seabed, and of a
  /// lookalike that shows less often than an object; sums over looks.
  struct Evidence {
    PerVisibility object, failing, bare, faint_lookalike;
    Evidence& operator+=(const Evidence& other);
    [[nodiscard]] Evidence operator/(double n) const;
  };
  struct Look {
    Eigen::Vector3d p_OC = Eigen::Vector3d::Zero();
    Evidence sum;                 ///< over frames; a look counts as its mean
    PerVisibility detects = 0.0;  ///< sum over frames
    int frames = 0;
    bool has_box = false;
    [[nodiscard]] Evidence mean() const { return sum / static_cast<double>(frames); }
    [[nodiscard]] PerVisibility counts() const;
  };

  [[nodiscard]] Evidence Weigh(const FrameEvidence& frame) const;
  /// Evidence of a whole pass, which may have failed: it misses objects and lookalikes then.
  [[nodiscard]] Evidence OfPass(const Evidence& pass) const;
  void CloseLook();
  void ClosePass();

  LookParams params_;
  std::optional<Look> look_;
  std::optional<Evidence> pass_;  ///< closed looks of the pass under way
  double last_time_ = 0.0;
  Evidence closed_;  ///< of the passes before, each of which may have failed
  PerVisibility closed_looks_;
  int closed_looks_with_box_ = 0;
  int passes_ = 0;
};

}  // namespace limpet

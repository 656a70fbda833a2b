// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "estimation/change/place_watch.hpp"

namespace limpet {

/// Where a box's object is, if it has the radius that `model` gives: from the box's size, or, if
/// one border cuts it, from its other side. Nothing for boxes in a corner, and for ones so small
/// that their object would lie below the seabed.
[[nodiscard]] std::optional<Eigen::Vector3d> PlaceOfBox(const Box& box, const ObservedFrame& frame,
                                                        const WatchModel& model);

/// Something that boxes hint at but that is no landmark of the smoother: an object at the edge of
/// every image. A tentative object makes the vehicle look again, from where it would see the whole.
struct TentativeObject {
  ObjectEstimate place;
  int boxes = 0;
  int places = 0;                                   ///< boxes that told the place
  bool is_counted = false;                          ///< was open before
  bool is_left_out = false;                         ///< would have been, but there were too many
  double last_box = 0.0;                            ///< time [s]
  int good_looks = 0;                               ///< that had the place wholly in the image
  std::optional<Eigen::Vector3d> last_viewpoint_W;  ///< of a good look, NED [m]
  int id = 0;                                       ///< of the object it is shown as, 0 before that
};

/// Collects boxes that nothing known explains. What false detections cost is bounded: a tentative
/// object needs several boxes of one pass that agree on a place, there are only so many in a
/// session, and one is over after a few good looks, whatever they showed (if there is an object, it
/// is a landmark by then), or when it has grown old.
class TentativeObjects {
 public:
  using IsExplained = std::function<bool(const ObservedFrame&, const Box&)>;

  /// Frames in order of time.
  void AddFrame(const ObservedFrame& frame, const WatchModel& model,
                const IsExplained& is_explained);
  /// TentativeObjects that are worth a look now; the caller may give them ids.
  [[nodiscard]] std::vector<TentativeObject*> Open();
  /// Tentative objects that are worth a look but came after the session's greatest number of them.
  [[nodiscard]] int left_out() const { return left_out_; }

 private:
  /// A box in the image's corner tells no place, but may be a known tentative object's.
  void Support(const Box& box, const ObservedFrame& frame, const WatchModel& model);
  void Take(const Eigen::Vector3d& p_W, const std::string& color, double time);

  std::vector<TentativeObject> tentative_;
  double now_ = 0.0;  ///< time of the newest frame [s]
  int counted_ = 0;   ///< tentative objects that were ever open
  int left_out_ = 0;
};

}  // namespace limpet

// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <map>
#include <string>
#include <vector>

#include "limpet/core/units.hpp"
#include "limpet/objects/frame.hpp"
#include "limpet/objects/image_chips.hpp"

namespace limpet {

/// A picture of an object.
struct ObjectChip {
  Seconds exposure;
  Box box;
  std::string jpeg;

  /// How well it shows the object: large, whole, and as the detector likes it.
  [[nodiscard]] double Worth() const;
};

/// The few pictures that show each landmark best, of looks that lie apart in time. Bounded: so many
/// of so many landmarks, whatever comes.
class BestChips {
 public:
  static constexpr std::size_t kOfEach = 3;
  static constexpr std::size_t kMostLandmarks = 500;
  static constexpr Seconds kApart{4.0};  ///< pictures taken closer together are one look

  /// Pictures wait for the frame that says which landmarks they show.
  void Add(ImageChips chips);
  void Add(const ObservedFrame& frame);
  /// Best first; empty for a landmark without pictures, and for none.
  [[nodiscard]] const std::vector<ObjectChip>& Of(const std::optional<int>& landmark) const;

 private:
  static constexpr std::size_t kWaiting = 16;
  void Keep(int landmark, const Seconds& exposure, const ImageChip& chip);

  std::deque<ImageChips> waiting_;
  std::map<int, std::vector<ObjectChip>> of_landmark_;
};

}  // namespace limpet

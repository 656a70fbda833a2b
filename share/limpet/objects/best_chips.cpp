// SPDX-License-Identifier: MIT
#include "limpet/objects/best_chips.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "limpet/objects/pixel_rect.hpp"

namespace limpet {
namespace {

/// The frame's box may be that of another camera model (rectified), a little beside the chip's.
constexpr double kSameBox = 0.5;

/// Which of the two shows more; of equals the earlier, so that the choice does not depend on order.
bool IsBetter(const ObjectChip& a, const ObjectChip& b) {
  const double worth_a = a.Worth();
  const double worth_b = b.Worth();
  return worth_a > worth_b || (worth_a == worth_b && a.exposure < b.exposure);
}

}  // namespace

double ObjectChip::Worth() const {
  constexpr double kLargeEnough = 120.0;  // beyond so many pixels a person sees no more
  // The shorter side: what the image's border cuts shows less of itself.
  return box.confidence * std::clamp(std::min(box.w, box.h), 0.0, kLargeEnough);
}

void BestChips::Add(ImageChips chips) {
  if (chips.chips.empty()) return;
  waiting_.push_back(std::move(chips));
  if (waiting_.size() > kWaiting) waiting_.pop_front();
}

void BestChips::Add(const ObservedFrame& frame) {
  const auto of_frame = std::ranges::find_if(waiting_, [&frame](const ImageChips& chips) {
    constexpr Seconds kSameTime(1e-4);  // logs round
    return std::abs((chips.exposure - frame.exposure).value()) < kSameTime.value();
  });
  if (of_frame == waiting_.end()) return;
  for (const Box& box : frame.boxes) {
    if (!box.landmark) continue;
    const auto chip = std::ranges::find_if(of_frame->chips, [&box](const ImageChip& one) {
      return Overlap(RectOf(one.box), RectOf(box)) >= kSameBox;
    });
    if (chip != of_frame->chips.end()) Keep(*box.landmark, of_frame->exposure, *chip);
  }
  waiting_.erase(waiting_.begin(), of_frame + 1);  // frames come in order
}

void BestChips::Keep(int landmark, const Seconds& exposure, const ImageChip& chip) {
  if (of_landmark_.size() >= kMostLandmarks && !of_landmark_.contains(landmark)) return;
  std::vector<ObjectChip>& kept = of_landmark_[landmark];
  ObjectChip made{.exposure = exposure, .box = chip.box, .jpeg = chip.jpeg};
  const auto is_near = [&made](const ObjectChip& other) {
    return std::abs((other.exposure - made.exposure).value()) < kApart.value();
  };
  // Of one look the best picture alone stays.
  if (std::ranges::any_of(kept, [&](const ObjectChip& other) {
        return is_near(other) && !IsBetter(made, other);
      })) {
    return;
  }
  std::erase_if(kept, is_near);
  kept.insert(std::ranges::upper_bound(kept, made, IsBetter), std::move(made));
  if (kept.size() > kOfEach) kept.pop_back();
}

const std::vector<ObjectChip>& BestChips::Of(const std::optional<int>& landmark) const {
  static const std::vector<ObjectChip> kNone;
  const auto found = landmark ? of_landmark_.find(*landmark) : of_landmark_.end();
  return found != of_landmark_.end() ? found->second : kNone;
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#pragma once

namespace limpet {

/// A box along one axis of an image: its two ends [px], and which of them the image's border cuts.
/// A cut end tells nothing of the object but that it goes on.
struct BoxExtent {
  double low = 0.0, high = 0.0;
  bool is_low_cut = false, is_high_cut = false;
  [[nodiscard]] bool is_cut() const { return is_low_cut || is_high_cut; }
  /// One end shows.
  [[nodiscard]] bool is_half_cut() const { return is_low_cut != is_high_cut; }
  /// The end that shows; REQUIRES is_half_cut().
  [[nodiscard]] double shown_end() const { return is_low_cut ? high : low; }
  /// Centre of an object whose image has this half size: of a half cut one from the end that shows,
  /// else the middle.
  [[nodiscard]] double CentreOf(double half) const {
    if (is_half_cut()) return is_low_cut ? high - half : low + half;
    return 0.5 * (low + high);
  }
};

}  // namespace limpet

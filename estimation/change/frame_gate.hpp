// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "limpet/core/units.hpp"

namespace limpet {

/// Why a frame says nothing to the map.
enum class FrameDrop { kOutOfOrder, kOtherPhase, kNoAltitude, kTooHigh };
inline constexpr std::size_t kFrameDrops = 4;
[[nodiscard]] std::string_view NameOf(FrameDrop drop);

/// Says which camera frames count, and counts those that do not by reason. One rule for the vehicle
/// and for whoever judges its saved frames again.
class FrameGate {
 public:
  struct Params {
    Meters highest_view{6.5};     ///< frames from higher above the seabed show nothing
    Seconds altitude_lasts{5.0};  ///< how long an altitude stands in for a lost one
  };
  struct Verdict {
    std::optional<double> altitude;  ///< above the seabed [m], if known lately
    std::optional<FrameDrop> drop;   ///< nothing: the frame counts
  };

  explicit FrameGate(const Params& params) : params_(params) {}

  /// An altitude that was heard at `time`.
  void Hear(Seconds time, double altitude);
  /// Frames come as they were heard; `time` is that of the exposure, `altitude` the frame's own.
  [[nodiscard]] Verdict Judge(Seconds time, std::optional<double> altitude, std::string_view phase);

  [[nodiscard]] int used() const { return used_; }
  [[nodiscard]] int dropped(FrameDrop drop) const {
    return dropped_[static_cast<std::size_t>(drop)];
  }
  /// Last altitude heard, and when.
  [[nodiscard]] std::optional<double> altitude() const { return altitude_; }
  [[nodiscard]] Seconds altitude_time() const { return altitude_time_; }

 private:
  [[nodiscard]] std::optional<FrameDrop> Reason(Seconds time, const std::optional<double>& fresh,
                                                std::string_view phase) const;

  Params params_;
  std::optional<double> altitude_;
  Seconds altitude_time_;
  std::optional<Seconds> last_;
  int used_ = 0;
  std::array<int, kFrameDrops> dropped_{};
};

}  // namespace limpet

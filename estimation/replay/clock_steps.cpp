// SPDX-License-Identifier: MIT
#include "estimation/replay/clock_steps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "limpet/core/frames.hpp"

namespace limpet {
namespace {

constexpr double kBack = 5.0;               // [s] that stamps may come late
constexpr double kAhead = 600.0;            // [s] that a recorder may pause without being asked why
constexpr double kLongestBridged = 1800.0;  // [s] that are bridged
constexpr double kTogether = 5.0;           // [s] between rows of one clock
constexpr std::size_t kAsked = 20, kAgreeing = 14;  // rows that show where the clock is

double StampOf(const StreamRow& row) {
  if (const auto* frame = std::get_if<FrameRow>(&row)) return frame->arrival;
  return std::visit(
      [](const auto& one) {
        if constexpr (requires { one.t; }) {
          return one.t;
        } else {
          return 0.0;
        }
      },
      row);
}

/// What a vehicle that swims on has much the same a moment later; of the rows that say it.
struct AttitudeAndDepth {
  std::optional<double> yaw, tilt, depth;

  void Note(const StreamRow& row) {
    if (const auto* attitude = std::get_if<AttitudeEstimate>(&row)) {
      yaw = attitude->yaw;
      tilt = std::hypot(attitude->roll, attitude->pitch);
    } else if (const auto* inertial = std::get_if<InertialInput>(&row)) {
      yaw = inertial->heading;
    } else if (const auto* depth_row = std::get_if<DepthReading>(&row)) {
      depth = depth_row->depth;
    }
  }
  [[nodiscard]] bool IsWhole() const { return yaw && depth; }
  [[nodiscard]] bool GoesOnAs(const AttitudeAndDepth& next) const {
    constexpr double kTurn = 0.1, kLean = 0.1;  // [rad]
    constexpr double kSink = 0.2;               // [m]
    if (!yaw || !next.yaw || std::abs(WrapAngle(*yaw - *next.yaw)) > kTurn) return false;
    if (tilt && next.tilt && std::abs(*tilt - *next.tilt) > kLean) return false;
    return depth && next.depth && std::abs(*depth - *next.depth) < kSink;
  }
};

class ClockMender {
 public:
  ClockMender(const std::string& name, SensorStream& stream)
      : name_(name), stream_(stream), rows_(stream.rows) {}

  void Run() {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (Leaps(i) && IsAgreedFrom(i) && !Follow(i)) {
        rows_.resize(i);
        break;
      }
      if (MayBeAPauseOrAStep(i)) NoteJump(i);
      Mend(rows_[i]);
      before_.Note(rows_[i]);
    }
    if (stray_ > 0) {
      rows_.erase(rows_.begin(), rows_.begin() + static_cast<std::ptrdiff_t>(stray_));
      stream_.left_out.push_back(fmt::format(
          "{}: the first {} rows are stamped long before all others, and left out", name_, stray_));
    }
    SayJumps();
    for (SourceRow& row : stream_.source_rows) {
      row.t = MendedSource(row.t);
    }
    std::ranges::stable_sort(stream_.source_rows, {}, &SourceRow::t);
  }

 private:
  /// Stamps from `from` on are `by` [s] too late. `from`: as they are stamped.
  struct Stretch {
    double from = -std::numeric_limits<double>::infinity();
    double by = 0.0;
  };

  [[nodiscard]] double by() const { return stretches_.back().by; }
  [[nodiscard]] bool Leaps(std::size_t i) const {
    if (!newest_) return false;
    const double leap = LeapOf(i);
    return leap < -kBack || leap > kAhead || (leap > kBack && IsOnTheFormerClock(i));
  }
  [[nodiscard]] double LeapOf(std::size_t i) const { return StampOf(rows_[i]) - by() - *newest_; }
  [[nodiscard]] bool IsOnTheFormerClock(std::size_t i) const {
    if (stretches_.size() < 2) return false;
    const double former = stretches_[stretches_.size() - 2].by;
    return std::abs(StampOf(rows_[i]) - former - *newest_) < kBack;
  }
  /// Whether most of the rows that follow have about this row's time; some may have been measured
  /// before.
  [[nodiscard]] bool IsAgreedFrom(std::size_t i) const {
    if (i + kAsked > rows_.size()) return false;
    const double t = StampOf(rows_[i]);
    const auto first = rows_.begin() + static_cast<std::ptrdiff_t>(i);
    const auto agreeing =
        std::count_if(first, first + static_cast<std::ptrdiff_t>(kAsked),
                      [t](const StreamRow& row) { return std::abs(StampOf(row) - t) < kTogether; });
    return static_cast<std::size_t>(agreeing) >= kAgreeing;
  }
  /// Nothing tells a short pause from a clock that was set ahead, but that several sensors leap at
  /// once. One that falls silent for itself leaves the others' rows in between.
  [[nodiscard]] bool MayBeAPauseOrAStep(std::size_t i) const {
    if (!newest_ || LeapOf(i) <= kBack || LeapOf(i) > kAhead || !IsAgreedFrom(i)) return false;
    return KindsOf(i, i + kAsked) > 1 && KindsOf(i - std::min(i, kAsked), i) > 1;
  }
  [[nodiscard]] std::size_t KindsOf(std::size_t first, std::size_t end) const {
    std::set<std::size_t> kinds;
    for (; first < end; ++first)
      kinds.insert(rows_[first].index());
    return kinds.size();
  }
  void NoteJump(std::size_t i) {
    const double leap = LeapOf(i);
    if (jumps_++ == 0) {
      first_jump_ =
          fmt::format("all sensors pause or jump {:.1f} s at t = {:.1f} s", leap, *newest_);
      if (before_.GoesOnAs(AttitudeAndDepthFrom(i))) first_jump_ += ", and go on as they were";
    }
    jumped_ += leap;
  }
  void SayJumps() {
    if (jumps_ == 0) return;
    stream_.doubts.push_back(
        fmt::format("{}: {}: a pause or a clock that was set ahead, taken for a pause; {} such, "
                    "{:.1f} s in all",
                    name_, first_jump_, jumps_, jumped_));
  }
  /// The attitude and depth that are said together with row `i`.
  [[nodiscard]] AttitudeAndDepth AttitudeAndDepthFrom(std::size_t i) const {
    AttitudeAndDepth next;
    const double t = StampOf(rows_[i]);
    for (; i < rows_.size() && !next.IsWhole(); ++i) {
      if (std::abs(StampOf(rows_[i]) - t) < kTogether) next.Note(rows_[i]);
    }
    return next;
  }

  /// The rows from `i` on are on another clock, or after a pause; false if they are of another
  /// dive.
  bool Follow(std::size_t i) {
    const double leap = LeapOf(i);
    if (i < kAsked && leap > 0.0) {
      stray_ = i;
      newest_ = StampOf(rows_[i]) - by();
      return true;
    }
    if (leap < 0.0 || IsOnTheFormerClock(i) || before_.GoesOnAs(AttitudeAndDepthFrom(i))) {
      Step(i);
      return true;
    }
    if (leap > kLongestBridged) {
      stream_.cut = fmt::format(
          "{}: after {:.1f} s nothing is said for {:.0f} s, and the vehicle is not as it was: what "
          "follows is another dive",
          name_, *newest_, leap);
      return false;
    }
    newest_ = StampOf(rows_[i]) - by();
    return true;
  }

  void Step(std::size_t i) {
    const double stamped = StampOf(rows_[i]);
    const double leap = LeapOf(i);
    stretches_.push_back({.from = stamped, .by = by() + leap + LatenessOf(i)});
    stream_.left_out.push_back(fmt::format(
        "{}: the clock was set {} by {:.1f} s after {:.1f} s, as all sensors' stamps say at once: "
        "later stamps count from there",
        name_, leap > 0.0 ? "ahead" : "back", std::abs(leap), *newest_));
  }
  /// How far rows like this one are behind the newest, as the last of them was [s].
  [[nodiscard]] double LatenessOf(std::size_t i) const {
    for (std::size_t j = i; j-- > 0;) {
      if (rows_[j].index() == rows_[i].index())
        return std::max(0.0, newest_at_[j] - StampOf(rows_[j]));
    }
    return 0.0;
  }

  /// Of the clock before, which a frame's exposure may still be by, and of this one that which
  /// leads nearer to the present.
  [[nodiscard]] double Mended(double t) const {
    const double now = t - by();
    if (stretches_.size() < 2 || !newest_) return now;
    const double former = t - stretches_[stretches_.size() - 2].by;
    return std::abs(former - *newest_) < std::abs(now - *newest_) ? former : now;
  }
  void Mend(StreamRow& row) {
    std::visit(
        [this](auto& one) {
          if constexpr (requires { one.t; }) {
            one.t = Mended(one.t);
          } else {
            one.arrival = Mended(one.arrival);
            one.frame.exposure = Seconds(Mended(one.frame.exposure.value()));
          }
        },
        row);
    const double t = StampOf(row);
    if (std::isfinite(t) && (!newest_ || (t > *newest_ && t < *newest_ + kAhead))) newest_ = t;
    newest_at_.push_back(newest_.value_or(t));
  }
  /// A source's time after mending [s], by the last stretch that holds `t`.
  [[nodiscard]] double MendedSource(double t) const {
    const auto holds = [t](const Stretch& stretch) { return t >= stretch.from - kTogether; };
    const auto last = std::find_if(stretches_.rbegin(), stretches_.rend(), holds);
    return t - last->by;
  }

  const std::string& name_;
  SensorStream& stream_;
  std::vector<StreamRow>& rows_;
  std::vector<Stretch> stretches_{Stretch{}};
  std::optional<double> newest_;   ///< mended time
  std::vector<double> newest_at_;  ///< as each row came
  AttitudeAndDepth before_;
  int jumps_ = 0;           ///< that may be pauses or steps
  double jumped_ = 0.0;     ///< by all of them [s]
  std::string first_jump_;  ///< of them, in words
  std::size_t stray_ = 0;   ///< rows at the beginning, of another time than all others
};

}  // namespace

void TakeOutClockSteps(const std::string& name, SensorStream& stream) {
  ClockMender(name, stream).Run();
}

}  // namespace limpet

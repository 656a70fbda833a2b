// SPDX-License-Identifier: MIT
#include "limpet/planning/seen_planes.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "limpet/core/interval.hpp"
#include "limpet/planning/straightness.hpp"

namespace limpet {
namespace {

/// Spacing of the images that stand for a motion that turns [m].
constexpr double kStep = 1.0;
constexpr double kOverlap = 1.0;  ///< of what a motion shows with what it starts from [cells]
constexpr double kParallel = 1e-9;
constexpr std::size_t kFirstRoom = 1024;  ///< of a log

/// The number of bits that are set. Inline: without the instruction, which plain x86-64 lacks,
/// std::popcount is a call.
int CountOf(std::uint64_t bits) {
  bits -= bits >> 1U & 0x5555555555555555U;
  bits = (bits & 0x3333333333333333U) + (bits >> 2U & 0x3333333333333333U);
  bits = (bits + (bits >> 4U)) & 0x0F0F0F0F0F0F0F0FU;
  return static_cast<int>(bits * 0x0101010101010101U >> 56U);
}

/// A band of the plane across `normal`, |normal . (y, x)| <= half: in the row at `y` it covers the
/// x from `middle y - reach` to `middle y + reach`.
struct Strip {
  double middle = 0.0, reach = std::numeric_limits<double>::infinity();
  Strip(const PlanePoint& normal, double half) {
    if (std::abs(normal.y()) <= kParallel) return;  // it covers whole rows
    middle = -normal.x() / normal.y();
    reach = half / std::abs(normal.y());
  }
};

/// Rows whose ends are reckoned at a time, so that the compiler takes several at once.
constexpr std::size_t kRowsAtOnce = 32;
/// Added before numbers are cut to integers, and taken off again: below 0, too, they are rounded
/// down. More columns than a grid has.
constexpr int kBias = 1 << 24;

}  // namespace

SeenPlanes::SeenPlanes(const Ground& ground)
    : frame_(ground.frame()),
      words_per_row_((static_cast<std::size_t>(ground.frame().columns) + 63) / 64) {
  const Footprint& footprint = ground.footprint();
  for (std::size_t plane = 0; plane < kPlanes; ++plane) {
    images_[plane] = {.half_along = footprint.half_along(kLayerOf[plane]) / frame_.cell_m,
                      .half_across = footprint.half_across(kLayerOf[plane]) / frame_.cell_m};
    planes_[plane].resize(words_per_row_ * static_cast<std::size_t>(frame_.rows));
    logs_[plane].resize(kFirstRoom);
  }
  Reset(ground);
}

void SeenPlanes::Reset(const Ground& ground) {
  noted_ = {};
  if (version_ != ground.version()) Copy(ground);
  for (std::size_t plane = 0; plane < kPlanes; ++plane) {
    std::ranges::copy(copied_[plane], planes_[plane].begin());
  }
  unseen_ = unseen_as_copied_;
}

void SeenPlanes::Copy(const Ground& ground) {
  version_ = ground.version();
  const auto columns = static_cast<std::size_t>(frame_.columns);
  for (std::size_t plane = 0; plane < kPlanes; ++plane) {
    copied_[plane].assign(planes_[plane].size(), ~std::uint64_t{0});
    unseen_as_copied_[plane] = 0;
    for (std::size_t cell = 0; cell < ground.levels().size(); ++cell) {
      if (static_cast<int>(ground.levels()[cell]) > kLayerOf[plane]) continue;
      const std::size_t column = cell % columns;
      copied_[plane][cell / columns * words_per_row_ + column / 64] &=
          ~(std::uint64_t{1} << (column % 64));
      ++unseen_as_copied_[plane];
    }
  }
}

SeenPlanes::Place SeenPlanes::PlaceOf(const Pose2& pose) const {
  return {.row = (pose.north - frame_.north_min) / frame_.cell_m - 0.5,
          .column = (pose.east - frame_.east_min) / frame_.cell_m - 0.5,
          .cos = std::cos(pose.yaw),
          .sin = std::sin(pose.yaw)};
}

void SeenPlanes::Look(const Pose2& at) {
  const Place place = PlaceOf(at);
  for (std::size_t plane = 0; plane < kPlanes; ++plane) {
    LookAhead(plane, place, {2.0 * images_[plane].half_along, 0.0});
  }
}

void SeenPlanes::Sweep(const Pose2& from, const PathSegment& segment) {
  if (IsStraight(segment.curvature)) {
    SweepStraight(PlaceOf(from), segment.length / frame_.cell_m);
  } else {
    SweepTurn(from, segment);
  }
}

void SeenPlanes::SweepStraight(const Place& from, double length) {
  for (std::size_t plane = 0; plane < kPlanes; ++plane) {
    LookAhead(plane, from, {kOverlap, length});
  }
}

/// The sine and cosine of the heading by recurrence: they are half the cost otherwise.
void SeenPlanes::SweepTurn(const Pose2& from, const PathSegment& segment) {
  const int steps = std::max(1, static_cast<int>(std::ceil(segment.length / kStep)));
  const double step = segment.length / steps / frame_.cell_m;
  const double curvature = segment.curvature * frame_.cell_m;
  const double c = std::cos(curvature * step), s = std::sin(curvature * step);
  const Place begin = PlaceOf(from);
  Place at = begin;
  for (int i = 1; i <= steps; ++i) {
    const double cos = at.cos * c - at.sin * s;
    at.sin = at.sin * c + at.cos * s;
    at.cos = cos;
    at.row = begin.row + (at.sin - begin.sin) / curvature;
    at.column = begin.column - (at.cos - begin.cos) / curvature;
    for (std::size_t plane = 0; plane < kPlanes; ++plane) {
      LookAhead(plane, at, {2.0 * images_[plane].half_along, 0.0});  // its rear swings out, too
    }
  }
}

void SeenPlanes::LookAhead(std::size_t plane, const Place& at, const Stretch& stretch) {
  const Image& image = images_[plane];
  if (image.half_across <= 0.0 || unseen_[plane] == 0) return;
  const double front = image.half_along + stretch.length;
  const double back = image.half_along - std::min(stretch.lead, 2.0 * image.half_along);
  const double middle = 0.5 * (front + back);
  Show(plane,
       {.row = at.row + middle * at.cos,
        .column = at.column + middle * at.sin,
        .cos = at.cos,
        .sin = at.sin},
       {.half_along = 0.5 * (front - back), .half_across = image.half_across});
}

void SeenPlanes::Show(std::size_t plane, const Place& middle, const Image& image) {
  const double c = middle.cos, s = middle.sin, north = middle.row, east = middle.column;
  const double reach_n = std::abs(c) * image.half_along + std::abs(s) * image.half_across;
  const double reach_e = std::abs(s) * image.half_along + std::abs(c) * image.half_across;
  const int row_begin = std::max(0, static_cast<int>(std::ceil(north - reach_n)));
  const int row_end = std::min(frame_.rows, static_cast<int>(std::floor(north + reach_n)) + 1);
  const Strip along({c, s}, image.half_along), across({-s, c}, image.half_across);
  const Interval inside{std::max(-reach_e, -east), std::min(reach_e, frame_.columns - 1 - east)};
  Reserve(plane, static_cast<std::size_t>(std::max(0, row_end - row_begin)) * words_per_row_);
  std::array<int, kRowsAtOnce> begins{}, ends{};
  for (int first = row_begin; first < row_end; first += static_cast<int>(kRowsAtOnce)) {
    const std::size_t rows = std::min(kRowsAtOnce, static_cast<std::size_t>(row_end - first));
    for (std::size_t i = 0; i < rows; ++i) {
      const double dn = first + static_cast<int>(i) - north;
      const double a = along.middle * dn, b = across.middle * dn;
      const double low = std::max({a - along.reach, b - across.reach, inside.low});
      const double high = std::min({a + along.reach, b + across.reach, inside.high});
      begins[i] = kBias - static_cast<int>(kBias - (east + low));
      ends[i] = static_cast<int>(kBias + east + high) - kBias + 1;
    }
    for (std::size_t i = 0; i < rows; ++i) {
      if (begins[i] < ends[i]) SetRun(plane, first + static_cast<int>(i), begins[i], ends[i]);
    }
  }
}

void SeenPlanes::SetRun(std::size_t plane, int row, int begin, int end) {
  constexpr std::uint64_t kAll = ~std::uint64_t{0};
  const std::size_t first = Word(row, begin), last = Word(row, end - 1);
  const std::uint64_t from = kAll << (static_cast<unsigned>(begin) % 64U);
  const std::uint64_t until = kAll >> (63U - static_cast<unsigned>(end - 1) % 64U);
  if (first == last) {
    SetBits(plane, first, from & until);
    return;
  }
  SetBits(plane, first, from);
  for (std::size_t word = first + 1; word < last; ++word) {
    SetBits(plane, word, kAll);
  }
  SetBits(plane, last, until);
}

/// Whether any are new is a coin's toss: they are noted, and the note is kept if they are.
void SeenPlanes::SetBits(std::size_t plane, std::size_t word, std::uint64_t bits) {
  std::uint64_t& seen = planes_[plane][word];
  const std::uint64_t added = bits & ~seen;
  logs_[plane][noted_[plane]] = {.word = word, .bits = added};
  noted_[plane] += added != 0 ? 1 : 0;
  seen |= added;
  unseen_[plane] -= CountOf(added);
}

void SeenPlanes::Reserve(std::size_t plane, std::size_t more) {
  const std::size_t needed = noted_[plane] + more;
  if (needed > logs_[plane].size()) logs_[plane].resize(2 * needed);
}

void SeenPlanes::See(std::size_t plane, std::span<const Bits> cells) {
  Reserve(plane, cells.size());
  std::uint64_t* const words = planes_[plane].data();
  Bits* const log = logs_[plane].data();
  std::size_t noted = noted_[plane];
  int count = 0;
  for (const auto& [word, bits] : cells) {
    const std::uint64_t added = bits & ~words[word];
    words[word] |= added;
    log[noted] = {.word = word, .bits = added};
    noted += added != 0 ? 1 : 0;
    count += CountOf(added);
  }
  noted_[plane] = noted;
  unseen_[plane] -= count;
}

PlanePoint SeenPlanes::NthUnseen(std::size_t plane, int n) const {
  const std::vector<std::uint64_t>& words = planes_[plane];
  std::size_t word = 0;
  for (; CountOf(~words[word]) <= n; ++word) {
    n -= CountOf(~words[word]);
  }
  std::uint64_t unseen = ~words[word];
  for (; n > 0; --n) {
    unseen &= unseen - 1;  // without its lowest bit
  }
  const auto row = static_cast<double>(word / words_per_row_);
  const auto column = static_cast<double>(word % words_per_row_ * 64) + std::countr_zero(unseen);
  return {frame_.north_min + (row + 0.5) * frame_.cell_m,
          frame_.east_min + (column + 0.5) * frame_.cell_m};
}

void SeenPlanes::Rewind(const Moment& then) {
  for (std::size_t plane = 0; plane < kPlanes; ++plane) {
    for (const auto& [word, bits] : Since(plane, then.noted[plane])) {
      planes_[plane][word] &= ~bits;
    }
  }
  noted_ = then.noted;
  unseen_ = then.unseen;
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "estimation/mapping/depth_map.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include <fmt/format.h>

#include "estimation/mapping/cell_hash.hpp"
#include "limpet/core/config.hpp"
#include "limpet/core/number_text.hpp"
#include "limpet/core/record.hpp"

namespace limpet {
namespace {

constexpr std::string_view kFields = "north,east,beams,down_mm,square_mm2";
constexpr double kDeepest_mm = 1e7;

struct DepthHeader {
  double cell_m = 0.0, zero_sigma_m = 0.0;
  template <class V>
  void Describe(V& visit) {
    visit("cell_m", cell_m), visit("zero_sigma_m", zero_sigma_m);
  }
  [[nodiscard]] bool is_sound() const {
    constexpr double kLeastCell = 0.01, kMostCell = 100.0, kMostSigma = 1000.0;
    return cell_m >= kLeastCell && cell_m <= kMostCell && zero_sigma_m >= 0.0 &&
           zero_sigma_m <= kMostSigma;
  }
};

/// Takes the text up to `end`, and `end`, off the front.
std::string_view TakeUpTo(std::string_view& text, char end) {
  const std::size_t at = std::min(text.find(end), text.size());
  const std::string_view part = text.substr(0, at);
  text.remove_prefix(std::min(at + 1, text.size()));
  return part;
}

/// Five integers, or nothing.
std::optional<std::array<std::int64_t, 5>> Row(std::string_view line) {
  std::array<std::int64_t, 5> row{};
  for (std::int64_t& field : row) {
    const std::optional<std::int64_t> number = ParseInteger(TakeUpTo(line, ','));
    if (!number) return std::nullopt;
    field = *number;
  }
  return line.empty() ? std::optional(row) : std::nullopt;
}

bool IsSound(const std::array<std::int64_t, 5>& row) {
  constexpr std::int64_t kMostBeams = 1'000'000'000;
  const auto [north, east, beams, down, square] = row;
  const auto is_index = [](std::int64_t index) {
    return index >= std::numeric_limits<std::int32_t>::min() &&
           index <= std::numeric_limits<std::int32_t>::max();
  };
  return is_index(north) && is_index(east) && beams > 0 && beams <= kMostBeams && square >= 0 &&
         std::abs(static_cast<double>(down)) <= kDeepest_mm * static_cast<double>(beams);
}

}  // namespace

std::size_t DepthMap::KeyHash::operator()(const Key& key) const { return CellHash(key[0], key[1]); }

double DepthMap::Sums::scatter() const {
  const auto sum = static_cast<long double>(down_mm);
  const auto square = static_cast<long double>(square_mm2);
  return std::max(0.0, static_cast<double>(square - sum * sum / static_cast<long double>(beams)));
}

void DepthMap::Sum(const Eigen::Vector3d& p_W, std::int64_t sign) {
  constexpr double kFarthest = 1e6;
  const double down_mm = std::round(1e3 * p_W.z());
  const bool is_place = (p_W.head<2>().array().abs() < kFarthest).all();
  if (!is_place || !(std::abs(down_mm) <= kDeepest_mm)) return;
  const auto index = [this](double x) {
    return static_cast<std::int32_t>(std::floor(x / cell_m_));
  };
  const Key key{index(p_W.x()), index(p_W.y())};
  const auto down = static_cast<std::int64_t>(down_mm);
  Sums& sums = columns_[key];
  sums.beams += sign;
  sums.down_mm += sign * down;
  sums.square_mm2 += static_cast<std::uint64_t>(sign) * static_cast<std::uint64_t>(down * down);
  if (sums.beams == 0) columns_.erase(key);
}

std::optional<double> DepthMap::DownAt(const Eigen::Vector2d& p_W) const {
  const auto index = [this](double x) {
    return static_cast<std::int32_t>(std::floor(x / cell_m_));
  };
  const auto found = columns_.find({index(p_W.x()), index(p_W.y())});
  if (found == columns_.end()) return std::nullopt;
  const Sums& sums = found->second;
  return 1e-3 * static_cast<double>(sums.down_mm) / static_cast<double>(sums.beams);
}

std::vector<std::pair<DepthMap::Key, DepthMap::Sums>> DepthMap::Sorted() const {
  std::vector<std::pair<Key, Sums>> sorted(columns_.begin(), columns_.end());
  std::ranges::sort(sorted, {}, &std::pair<Key, Sums>::first);
  return sorted;
}

std::vector<DepthColumn> DepthMap::Columns() const {
  /// What all columns say of a single one's scatter is worth as much as so many of its own beams.
  constexpr double kBelievedBeams = 5.0;
  constexpr double kLeastScatter_mm2 = 100.0;  // of a map with no two beams anywhere in one column
  const std::vector<std::pair<Key, Sums>> sorted = Sorted();
  double scatter = kBelievedBeams * kLeastScatter_mm2, freedom = kBelievedBeams;
  for (const auto& [key, sums] : sorted) {
    scatter += sums.scatter();
    freedom += static_cast<double>(sums.beams - 1);
  }
  const double usual = scatter / freedom;
  std::vector<DepthColumn> columns;
  columns.reserve(sorted.size());
  for (const auto& [key, sums] : sorted) {
    const auto beams = static_cast<double>(sums.beams);
    const double own = (kBelievedBeams * usual + sums.scatter()) / (kBelievedBeams + beams - 1.0);
    columns.push_back({.north = (key[0] + 0.5) * cell_m_,
                       .east = (key[1] + 0.5) * cell_m_,
                       .down = 1e-3 * static_cast<double>(sums.down_mm) / beams,
                       .sigma = std::hypot(1e-3 * std::sqrt(own / beams), kShared),
                       .beams = static_cast<std::uint32_t>(sums.beams)});
  }
  return columns;
}

std::string DepthMap::Serialize() const {
  const DepthHeader header{.cell_m = cell_m_, .zero_sigma_m = zero_sigma_};
  std::string text = fmt::format("{}\n{}\n", EncodeRecord(header), kFields);
  for (const auto& [key, sums] : Sorted()) {
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{}\n", key[0], key[1], sums.beams,
                   sums.down_mm, sums.square_mm2);
  }
  return text;
}

Expected<DepthMap> DepthMap::Parse(std::string_view text) {
  const auto header = DecodeRecord<DepthHeader>(TakeUpTo(text, '\n'));
  if (!header || !header->is_sound()) return Error{"says no cell_m and zero_sigma_m"};
  if (TakeUpTo(text, '\n') != kFields) return Error{fmt::format("lacks the line `{}`", kFields)};
  DepthMap map(header->cell_m);
  map.zero_sigma_ = header->zero_sigma_m;
  std::optional<Key> last;
  for (int line = 3; !text.empty(); ++line) {
    const auto row = Row(TakeUpTo(text, '\n'));
    if (!row || !IsSound(*row)) return Error{fmt::format("line {}: no column", line)};
    const Key key{static_cast<std::int32_t>((*row)[0]), static_cast<std::int32_t>((*row)[1])};
    if (last && key <= *last) return Error{fmt::format("line {}: out of order", line)};
    last = key;
    map.columns_[key] = {.beams = (*row)[2],
                         .down_mm = (*row)[3],
                         .square_mm2 = static_cast<std::uint64_t>((*row)[4])};
  }
  return map;
}

}  // namespace limpet

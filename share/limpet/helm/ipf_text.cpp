// SPDX-License-Identifier: MIT
#include "limpet/helm/ipf_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <span>

#include <fmt/format.h>

#include "limpet/core/decimal_text.hpp"
#include "limpet/core/frames.hpp"
#include "limpet/core/number_text.hpp"
#include "limpet/helm/peak.hpp"

namespace limpet {
namespace {

constexpr double kFull = 100.0;          ///< of a preference that is met
constexpr double kPeakTolerance = 1e-6;  ///< of kFull
constexpr double kTableTolerance = 0.5;
constexpr int kDecimals = 4;  ///< that readers expect
using Index = std::array<int, 3>;

/// Points of the domain from `low` to `high`, both included, and the plane over them.
struct Piece {
  Index low{}, high{};
  std::array<double, 3> slope{};  ///< per index
  double constant = 0.0;          ///< at index 0
};

const std::optional<Peak>& PeakAlong(MotionVariable variable, const MotionBid& bid) {
  return variable == MotionVariable::kCourse  ? bid.course
         : variable == MotionVariable::kSpeed ? bid.speed
                                              : bid.depth;
}

std::vector<double> ValuesOf(const Peak& peak, const MotionAxis& axis, MotionVariable variable) {
  std::vector<double> values;
  for (int i = 0; i < axis.points; ++i) {
    const double away = axis.At(i) - peak.summit;
    values.push_back(kFull * peak.share *
                     PeakValue(peak, variable == MotionVariable::kCourse ? std::abs(WrapAngle(away))
                                                                         : std::abs(away)));
  }
  return values;
}

/// A bid as a function of the indices of the domain's points.
class IndexedBid {
 public:
  IndexedBid(const MotionBid& bid, const MotionDomain& domain) : table_(bid.table) {
    shares_ = table_ != nullptr ? 1.0 : 0.0;
    for (const MotionVariable variable : kMotionVariables) {
      const std::size_t v = IndexOf(variable);
      const std::optional<MotionAxis>& axis = domain.axis(variable);
      if (!axis) continue;
      const std::optional<Peak>& peak = PeakAlong(variable, bid);
      const bool is_joined = table_ != nullptr && table_->Covers(variable);
      if (peak) values_[v] = ValuesOf(*peak, *axis, variable), shares_ += peak->share;
      if (!peak && is_joined) values_[v].assign(static_cast<std::size_t>(axis->points), 0.0);
      is_joined_[v] = is_joined;
    }
    if (bid.present_course && domain.course) AddOn(*bid.present_course, *domain.course);
  }
  /// Share of the behavior's weight that all its preferences have together.
  [[nodiscard]] double shares() const { return shares_; }
  [[nodiscard]] bool IsAbout(std::size_t v) const { return !values_[v].empty(); }
  [[nodiscard]] bool IsJoined(std::size_t v) const { return is_joined_[v]; }
  [[nodiscard]] int Points(std::size_t v) const { return static_cast<int>(values_[v].size()); }
  /// Value that the peak on variable `v` alone has at a point of its axis.
  [[nodiscard]] double Own(std::size_t v, int point) const {
    return values_[v][static_cast<std::size_t>(point)] / shares_;
  }
  /// Value of the table and of the peaks on its variables, together.
  [[nodiscard]] double Joined(const Index& at) const {
    double sum = 0.0;
    std::size_t place = 0;
    for (const MotionVariable variable : kMotionVariables) {
      const std::size_t v = IndexOf(variable);
      if (!is_joined_[v]) continue;
      sum += Own(v, at[v]);
      place += static_cast<std::size_t>(at[v]) * table_->stride(variable);
    }
    return sum + kFull * static_cast<double>(table_->values()[place]) / shares_;
  }

 private:
  void AddOn(const Peak& present, const MotionAxis& axis) {
    const std::vector<double> more = ValuesOf(present, axis, MotionVariable::kCourse);
    std::vector<double>& values = values_[IndexOf(MotionVariable::kCourse)];
    values.resize(more.size());
    std::ranges::transform(values, more, values.begin(), std::plus());
    shares_ += present.share;
  }

  const MotionTable* table_;
  std::array<std::vector<double>, 3> values_;  ///< of peaks; empty: not about that variable
  std::array<bool, 3> is_joined_{};
  double shares_ = 0.0;
};

/// Runs of points over which a variable's own preference is a straight line.
std::vector<Piece> RunsOf(const IndexedBid& bid, std::size_t v) {
  std::vector<Piece> runs;
  for (int begin = 0; begin < bid.Points(v);) {
    const double first = bid.Own(v, begin);
    const double slope = begin + 1 < bid.Points(v) ? bid.Own(v, begin + 1) - first : 0.0;
    int end = std::min(begin + 1, bid.Points(v) - 1);
    while (end + 1 < bid.Points(v) &&
           std::abs(first + slope * (end + 1 - begin) - bid.Own(v, end + 1)) < kPeakTolerance) {
      ++end;
    }
    Piece run;
    run.low[v] = begin, run.high[v] = end;
    run.slope[v] = slope;
    run.constant = first - slope * begin;
    runs.push_back(run);
    begin = end + 1;
  }
  return runs;
}

/// Halves boxes of the table's points until a plane is near enough in each.
class TablePieces {
 public:
  explicit TablePieces(const IndexedBid& bid) : bid_(bid) {
    Piece whole;
    for (std::size_t v = 0; v < 3; ++v) {
      whole.high[v] = bid.IsJoined(v) ? bid.Points(v) - 1 : 0;
    }
    Divide(whole);
  }
  [[nodiscard]] std::vector<Piece> Take() { return std::move(pieces_); }

 private:
  /// The plane by the box's corners; false if it is too far from a point. A box of two points or
  /// less along each variable may be none either.
  [[nodiscard]] bool Fit(Piece& box) const {
    const double origin = bid_.Joined(box.low);
    box.constant = origin;
    for (std::size_t v = 0; v < 3; ++v) {
      Index far = box.low;
      far[v] = box.high[v];
      const int steps = box.high[v] - box.low[v];
      box.slope[v] = steps > 0 ? (bid_.Joined(far) - origin) / steps : 0.0;
      box.constant -= box.slope[v] * box.low[v];
    }
    Index at = box.low;
    for (at[0] = box.low[0]; at[0] <= box.high[0]; ++at[0]) {
      for (at[1] = box.low[1]; at[1] <= box.high[1]; ++at[1]) {
        for (at[2] = box.low[2]; at[2] <= box.high[2]; ++at[2]) {
          const double plane =
              box.constant + box.slope[0] * at[0] + box.slope[1] * at[1] + box.slope[2] * at[2];
          if (std::abs(plane - bid_.Joined(at)) > kTableTolerance) return false;
        }
      }
    }
    return true;
  }
  void Divide(Piece box) {
    if (Fit(box)) {
      pieces_.push_back(box);
      return;
    }
    std::size_t longest = 0;
    for (std::size_t v = 1; v < 3; ++v) {
      if (box.high[v] - box.low[v] > box.high[longest] - box.low[longest]) longest = v;
    }
    Piece first = box, second = box;
    first.high[longest] = (box.low[longest] + box.high[longest]) / 2;
    second.low[longest] = first.high[longest] + 1;
    Divide(first);
    Divide(second);
  }

  const IndexedBid& bid_;
  std::vector<Piece> pieces_;
};

/// Each of `pieces` with each of `others`, which are about other variables: values add.
std::vector<Piece> Crossed(const std::vector<Piece>& pieces, const std::vector<Piece>& others) {
  std::vector<Piece> crossed;
  crossed.reserve(pieces.size() * others.size());
  for (const Piece& one : pieces) {
    for (const Piece& other : others) {
      Piece both = one;
      for (std::size_t v = 0; v < 3; ++v) {
        both.low[v] += other.low[v], both.high[v] += other.high[v];
        both.slope[v] += other.slope[v];
      }
      both.constant += other.constant;
      crossed.push_back(both);
    }
  }
  return crossed;
}

std::vector<Piece> PiecesOf(const IndexedBid& bid) {
  bool has_table = false;
  for (std::size_t v = 0; v < 3; ++v) {
    has_table = has_table || bid.IsJoined(v);
  }
  std::vector<Piece> pieces = has_table ? TablePieces(bid).Take() : std::vector<Piece>(1);
  for (std::size_t v = 0; v < 3; ++v) {
    if (bid.IsAbout(v) && !bid.IsJoined(v)) pieces = Crossed(pieces, RunsOf(bid, v));
  }
  return pieces;
}

/// `course;0;359;360:depth;0;20;201`, of the variables that the bid is about.
std::string DomainText(const IndexedBid& bid, const MotionDomain& domain) {
  std::string text;
  for (const MotionVariable variable : kMotionVariables) {
    if (!bid.IsAbout(IndexOf(variable))) continue;
    const MotionAxis& axis = *domain.axis(variable);
    const double unit = variable == MotionVariable::kCourse ? 180.0 / std::numbers::pi : 1.0;
    text +=
        fmt::format("{}{};{};{};{}", text.empty() ? "" : ":", NameOf(variable),
                    DecimalText(axis.low * unit, 4), DecimalText(axis.high * unit, 4), axis.points);
  }
  return text;
}

void AddPiece(const Piece& piece, std::span<const std::size_t> variables, std::string& text) {
  for (const std::size_t v : variables) {
    text += fmt::format("{},{},", piece.low[v], piece.high[v]);
  }
  for (const std::size_t v : variables) {
    text += DecimalText(piece.slope[v], kDecimals) + ",";
  }
  text += DecimalText(piece.constant, kDecimals);
}

}  // namespace

std::string IpfText(const OwnedMotionBid& owned, const MotionDomain& domain,
                    std::int64_t iteration) {
  const IndexedBid bid(owned.bid, domain);
  std::vector<std::size_t> variables;
  for (std::size_t v = 0; v < 3; ++v) {
    if (bid.IsAbout(v)) variables.push_back(v);
  }
  if (variables.empty() || bid.shares() <= 0.0) return "";
  const std::vector<Piece> pieces = PiecesOf(bid);
  const std::string context = fmt::format("{}:{}", iteration, owned.owner);
  std::string text = fmt::format(
      "H,{},{},{},{},1,{},D,{},G", context.size(), context, variables.size(), pieces.size(),
      DecimalText(owned.weight * bid.shares(), 4), DomainText(bid, domain));
  for (const std::size_t v : variables) {
    text += fmt::format(",{}", bid.Points(v) - 1);
  }
  text += ",F,";
  for (const Piece& piece : pieces) {
    if (&piece != &pieces.front()) text += ",";
    AddPiece(piece, variables, text);
  }
  return text;
}

int IpfPieces(const std::string& text) {
  // H,<size>,<context>,<variables>,<pieces>,...: the context, a behavior's name, may have commas.
  const std::size_t end = text.find(",D,");
  if (end == std::string::npos) return 0;
  const std::vector<std::string> head = Split(std::string_view(text).substr(0, end), ',');
  constexpr std::size_t kFromEnd = 3;  // pieces, 1, weight
  const auto pieces = ParseInteger(head.at(head.size() - kFromEnd));
  return static_cast<int>(pieces.value_or(0));
}

std::vector<std::string> IpfPackets(const std::string& text, const std::string& behavior,
                                    std::int64_t iteration) {
  constexpr std::size_t kPacket = 2000, kHeader = 50;  // besides the function's name
  std::vector<std::string> packets;
  if (text.empty()) return packets;
  const std::string id = fmt::format("{}^{}", behavior, iteration);
  const std::size_t body = kPacket - kHeader - std::min(id.size(), kPacket / 2);
  const std::size_t count = (text.size() + body - 1) / body;
  for (std::size_t i = 0; i < count; ++i) {
    packets.push_back(fmt::format("P,{},{},{},{}", id, count, i + 1, text.substr(i * body, body)));
  }
  return packets;
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/console/scope_columns.hpp"

#include <algorithm>
#include <set>
#include <string>

#include <fmt/format.h>

namespace limpet {
namespace {

constexpr std::size_t kAge = 6;
constexpr std::size_t kRate = 6;
constexpr std::size_t kCount = 8;
constexpr std::size_t kGap = 2;
constexpr std::size_t kWideScreen = 110;  ///< from here on there is room for more columns
constexpr std::size_t kLeastValue = 8;

std::string SourceText(const VariableRow& row, bool keeps_utf8) {
  return OneLine(row.source_aux.empty() ? row.source : row.source + ":" + row.source_aux, kAnyWidth,
                 keeps_utf8);
}

std::string CountText(std::uint64_t count) {
  return count < 10'000'000 ? fmt::format("{}", count)
                            : fmt::format("{:.1f}M", static_cast<double>(count) / 1e6);
}

}  // namespace

ScopeColumns::ScopeColumns(const std::vector<const VariableRow*>& rows, std::size_t width,
                           bool keeps_utf8)
    : width_(width) {
  std::set<std::string> communities;
  for (const VariableRow* row : rows) {
    name_ = std::max(name_, ColumnsOf(OneLine(row->name, kAnyWidth, keeps_utf8)));
    source_ = std::max(source_, ColumnsOf(SourceText(*row, keeps_utf8)));
    communities.insert(row->community);
    has_count_ = has_count_ || (row->writes > 0 && width >= kWideScreen);
  }
  if (communities.size() > 1 && width >= kWideScreen) {
    for (const std::string& name : communities) {
      community_ = std::max(community_, ColumnsOf(OneLine(name, kAnyWidth, keeps_utf8)));
    }
    community_ = std::clamp<std::size_t>(community_, 9, 14);
  }
  if (width != kAnyWidth) {
    name_ = std::min(name_, std::max<std::size_t>(8, width * 3 / 10));
    source_ = std::min(source_, std::max<std::size_t>(6, width * 3 / 20));
  }
}

std::size_t ScopeColumns::ValueWidth() const {
  const std::size_t taken = name_ + source_ + kAge + kRate + 1 + 4 * kGap + 1 +
                            (has_count_ ? kCount + kGap : 0) +
                            (community_ > 0 ? community_ + kGap : 0);
  return width_ == kAnyWidth ? kAnyWidth : std::max(kLeastValue, width_ - std::min(width_, taken));
}

FrameLine ScopeColumns::Head() const {
  FrameLine line;
  const std::string gap(kGap, ' ');
  line.AddCell("VARIABLE", name_, Ink::kHeader).Add(gap);
  line.AddCell("SOURCE", source_, Ink::kHeader).Add(gap);
  if (community_ > 0) {
    line.AddCell("COMMUNITY", community_, Ink::kHeader).Add(gap);
  }
  line.AddNumber("AGE", kAge, Ink::kHeader).Add(gap);
  line.AddNumber("Hz", kRate, Ink::kHeader).Add(gap);
  if (has_count_) {
    line.AddNumber("HEARD", kCount, Ink::kHeader).Add(gap);
  }
  return line.Add("T VALUE", Ink::kHeader);
}

FrameLine ScopeColumns::Row(const VariableRow& row, const ScopeMoment& moment) const {
  constexpr double kFresh = 1.0;  // real seconds
  const bool is_fresh =
      row.changes > 0 && (moment.now - row.changed).value() < kFresh * moment.warp;
  const bool is_late = row.IsOverdue(moment.now);
  FrameLine line;
  const std::string gap(kGap, ' ');
  line.AddCell(OneLine(row.name, kAnyWidth, moment.keeps_utf8), name_).Add(gap);
  line.AddCell(SourceText(row, moment.keeps_utf8), source_, Ink::kSource).Add(gap);
  if (community_ > 0) {
    line.AddCell(OneLine(row.community, kAnyWidth, moment.keeps_utf8), community_).Add(gap);
  }
  line.AddNumber(ShownAge(row.Age(moment.now)), kAge, is_late ? Ink::kLate : Ink::kPlain).Add(gap);
  line.AddNumber(ShownRate(row.RateAt(moment.now)), kRate, is_late ? Ink::kLate : Ink::kPlain)
      .Add(gap);
  if (has_count_) {
    line.AddNumber(CountText(row.writes), kCount).Add(gap);
  }
  line.Add(std::string(1, row.value.type), Ink::kFaint).Add(" ");
  return line.Add(ShownValue(row.value, ValueWidth(), moment.keeps_utf8),
                  is_fresh ? Ink::kFresh : Ink::kPlain);
}

}  // namespace limpet

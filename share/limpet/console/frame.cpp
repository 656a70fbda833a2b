// SPDX-License-Identifier: MIT
#include "limpet/console/frame.hpp"

#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>

#include "limpet/console/shown_text.hpp"

namespace limpet {
namespace {

std::string Blanks(std::size_t count) { return std::string(count, ' '); }

const char* CodeOf(Ink ink, bool has_colors) {
  switch (ink) {
    case Ink::kTitle:
      return "1";
    case Ink::kHeader:
      return has_colors ? "1;36" : "1";
    case Ink::kSource:
      return has_colors ? "36" : "";
    case Ink::kFresh:
      return has_colors ? "32" : "1";
    case Ink::kGood:
      return has_colors ? "32" : "";
    case Ink::kLate:
      return has_colors ? "33" : "1";
    case Ink::kFaint:
      return "2";
    case Ink::kSelected:
      return "7";
    case Ink::kBad:
      return has_colors ? "1;31" : "1";
    default:
      return "";
  }
}

}  // namespace

FrameLine& FrameLine::Add(std::string_view text, Ink ink) {
  if (!text.empty()) {
    spans_.push_back({ink, std::string(text)});
  }
  return *this;
}

FrameLine& FrameLine::AddCell(std::string_view text, std::size_t width, Ink ink) {
  const std::string cell = OneLine(text, width);
  Add(cell, ink);
  return Add(Blanks(width - ColumnsOf(cell)));
}

FrameLine& FrameLine::AddNumber(std::string_view text, std::size_t width, Ink ink) {
  const std::string cell = OneLine(text, width);
  Add(Blanks(width - ColumnsOf(cell)));
  return Add(cell, ink);
}

FrameLine& FrameLine::FitTo(std::size_t width) {
  std::size_t left = width;
  for (Span& span : spans_) {
    span.text = OneLine(span.text, left);
    left -= ColumnsOf(span.text);
  }
  return Add(Blanks(left));
}

FrameLine& FrameLine::MakeAscii() {
  for (Span& span : spans_) {
    span.text = OneLine(span.text, kAnyWidth, false);
  }
  return *this;
}

FrameLine& FrameLine::PaintAll(Ink ink) {
  std::string text;
  for (const Span& span : spans_) {
    text += span.text;
  }
  spans_ = {{ink, text}};
  return *this;
}

std::size_t FrameLine::columns() const {
  std::size_t columns = 0;
  for (const Span& span : spans_) {
    columns += ColumnsOf(span.text);
  }
  return columns;
}

std::string FrameLine::PlainText() const {
  std::string text;
  for (const Span& span : spans_) {
    text += span.text;
  }
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

std::string PlainText(const Frame& frame) {
  std::string text;
  for (const FrameLine& line : frame) {
    text += line.PlainText() + "\n";
  }
  return text;
}

std::string Painted(const FrameLine& line, bool has_colors) {
  std::string text;
  for (const Span& span : line.spans()) {
    const std::string code = CodeOf(span.ink, has_colors);
    text += code.empty() ? span.text : fmt::format("\033[{}m{}\033[m", code, span.text);
  }
  return text;
}

bool ColorsAreWanted() {
  const char* refusal = std::getenv("NO_COLOR");  // NOLINT(concurrency-mt-unsafe): nobody sets it
  const char* terminal = std::getenv("TERM");     // NOLINT(concurrency-mt-unsafe)
  return (refusal == nullptr || *refusal == '\0') &&
         (terminal == nullptr || std::string_view(terminal) != "dumb");
}

Frame TextTable::Lines() const {
  std::vector<std::size_t> widths;
  for (const std::string& head : heads_) {
    widths.push_back(ColumnsOf(head));
  }
  for (const auto& row : rows_) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      widths[i] = std::max(widths[i], ColumnsOf(row[i].text));
    }
  }
  const auto line_of = [&widths](const std::vector<Cell>& cells) {
    FrameLine line;
    for (std::size_t i = 0; i + 1 < cells.size(); ++i) {
      line.AddCell(cells[i].text, widths[i], cells[i].ink).Add("  ");
    }
    return line.Add(cells.back().text, cells.back().ink);
  };
  std::vector<Cell> first;
  for (const std::string& head : heads_) {
    first.push_back({head, Ink::kHeader});
  }
  Frame lines{line_of(first)};
  for (const auto& row : rows_) {
    lines.push_back(line_of(row));
  }
  return lines;
}

}  // namespace limpet
